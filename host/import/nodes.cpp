#include "import/nodes.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

namespace ajar::gltf {

namespace {

glm::mat4 local_transform(const JsonObject& node) {
    const std::vector<float> m = node.numbers("matrix");
    if (!m.empty()) {
        if (m.size() != 16) node.fail("matrix", fmt::format("must have 16 numbers, has {}", m.size()));
        glm::mat4 matrix;
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) matrix[c][r] = m[static_cast<std::size_t>(4 * c + r)];
        if (matrix[0].w != 0 || matrix[1].w != 0 || matrix[2].w != 0 || matrix[3].w != 1)
            node.fail("matrix", "must end in the row 0 0 0 1");
        return matrix;
    }
    const glm::vec3 translation = node.vector<3>("translation", glm::vec3(0));
    const glm::vec4 rotation = node.vector<4>("rotation", glm::vec4(0, 0, 0, 1)); // x y z w
    const glm::vec3 scale = node.vector<3>("scale", glm::vec3(1));
    glm::quat q(rotation.w, rotation.x, rotation.y, rotation.z);
    const float length = glm::length(q);
    q = length > 0 && std::isfinite(length) ? q / length : glm::quat(1, 0, 0, 0);
    glm::mat4 matrix = glm::mat4_cast(q);
    for (int c = 0; c < 3; ++c) matrix[c] *= scale[c];
    matrix[3] = glm::vec4(translation, 1);
    return matrix;
}

bool is_finite(const glm::mat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

} // namespace

Nodes::Nodes(Document& document) : objects_(document.root().objects("nodes")) {
    if (count() > document.options().limits.max_nodes)
        document.root().fail("nodes", fmt::format("there are {}, more than {} (the limit)", count(),
                                                  document.options().limits.max_nodes));
    link();
    place(document);
    collect(choose_scene(document));
}

void Nodes::link() {
    children_.resize(count());
    parents_.assign(count(), NO_INDEX);
    for (std::uint32_t i = 0; i < count(); ++i) {
        children_[i] = objects_[i].indices("children", count(), "node");
        for (const std::uint32_t child : children_[i]) {
            if (parents_[child] != NO_INDEX)
                objects_[i].fail("children",
                                 fmt::format("node {} is also a child of node {}", child, parents_[child]));
            parents_[child] = i;
        }
    }
}

// A tree that hangs on a node without parent is visited whole; what stays unvisited hangs on a cycle.
void Nodes::place(Document& document) {
    to_world_.resize(count());
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < count(); ++i)
        if (parents_[i] == NO_INDEX) open.push_back(i);
    std::size_t visited = 0;
    std::vector<bool> is_placed(count());
    for (; !open.empty(); ++visited) {
        const std::uint32_t i = open.back();
        open.pop_back();
        is_placed[i] = true;
        const glm::mat4 local = local_transform(objects_[i]);
        to_world_[i] = parents_[i] == NO_INDEX ? local : to_world_[parents_[i]] * local;
        if (!is_finite(to_world_[i])) objects_[i].fail("", "its transform is not finite");
        open.insert(open.end(), children_[i].begin(), children_[i].end());
    }
    document.info().nodes = count();
    if (visited == count()) return;
    const auto first = std::find(is_placed.begin(), is_placed.end(), false);
    objects_[static_cast<std::size_t>(first - is_placed.begin())].fail("children",
                                                                       "the node tree has a cycle here");
}

std::vector<std::uint32_t> Nodes::choose_scene(Document& document) {
    const std::vector<JsonObject> scenes = document.root().objects("scenes");
    AssetInfo& info = document.info();
    for (const JsonObject& scene : scenes) info.scene_names.push_back(scene.text("name"));
    const std::string& wanted = document.options().scene;
    std::optional<std::uint32_t> chosen;
    if (!wanted.empty()) {
        const auto named = std::find(info.scene_names.begin(), info.scene_names.end(), wanted);
        std::uint32_t index = 0;
        const char* end = wanted.data() + wanted.size();
        if (named != info.scene_names.end())
            chosen = static_cast<std::uint32_t>(named - info.scene_names.begin());
        else if (const auto parsed = std::from_chars(wanted.data(), end, index);
                 parsed.ec == std::errc() && parsed.ptr == end && index < scenes.size())
            chosen = index;
        else
            throw Error(fmt::format("{}: there is no scene '{}' (it has {}: give a name or an index)",
                                    document.file(), wanted, scenes.size()));
    } else {
        chosen = document.root().index("scene", scenes.size(), "scene");
        if (!chosen && !scenes.empty()) chosen = 0;
    }
    if (chosen) {
        info.scene = *chosen;
        scene_name_ = info.scene_names[*chosen];
        return scenes[*chosen].indices("nodes", count(), "node");
    }
    std::vector<std::uint32_t> roots; // a file without scenes: everything
    for (std::uint32_t i = 0; i < count(); ++i)
        if (parents_[i] == NO_INDEX) roots.push_back(i);
    return roots;
}

void Nodes::collect(const std::vector<std::uint32_t>& roots) {
    std::vector<bool> is_in(count());
    std::vector<std::uint32_t> open(roots.rbegin(), roots.rend());
    while (!open.empty()) {
        const std::uint32_t i = open.back();
        open.pop_back();
        if (is_in[i]) continue; // listed by the scene although its parent is as well
        is_in[i] = true;
        in_scene_.push_back(i);
        open.insert(open.end(), children_[i].rbegin(), children_[i].rend());
    }
}

std::string Nodes::scene_name() const { return scene_name_; }

std::string Nodes::name(std::uint32_t node) const {
    const std::string name = objects_[node].text("name");
    return name.empty() ? fmt::format("node {}", node) : name;
}

} // namespace ajar::gltf
