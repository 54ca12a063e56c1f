#include "render/surface_index.hpp"

namespace ajar {

bool mirrors(const glm::mat4& transform) { return glm::determinant(glm::mat3(transform)) < 0; }

SurfaceIndex::SurfaceIndex(const Scene& scene, std::span<const TriangleSource> sources) : scene_(scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        first_.push_back(count);
        count += scene.meshes[instance.mesh].triangles.size();
    }
    leaves_.resize(count);
    for (std::uint32_t leaf = 0; leaf < sources.size(); ++leaf)
        leaves_[first_[sources[leaf].instance] + sources[leaf].triangle] = leaf;
}

shared::SurfaceElement SurfaceIndex::element(const SceneElement& element) const {
    const bool swapped = mirrors(scene_.instances[element.instance].to_world);
    const auto turned = [&](const glm::vec2& at) { return swapped ? glm::vec2(at.y, at.x) : at; };
    return {leaf(element.instance, element.triangle), element.flags, turned(element.origin),
            turned(element.edge_a), turned(element.edge_b)};
}

} // namespace ajar
