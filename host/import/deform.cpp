#include "import/deform.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ajar::gltf {

namespace {

// Adds weight * displacement to the first three components.
template <class Vec> void displace(const JsonObject& target, std::string_view name, float weight,
                                   PrimitiveReader& reader, const Primitive& primitive,
                                   std::vector<Vec>& values) {
    const auto accessor = target.index(name, reader.accessors.count(), "accessor");
    if (!accessor || values.empty()) return;
    if (reader.accessors.elements(*accessor) != primitive.file_vertices)
        target.fail(name, fmt::format("has {} elements for {} positions",
                                      reader.accessors.elements(*accessor), primitive.file_vertices));
    reader.document.charge(values.size() * sizeof(glm::vec3), target);
    const std::vector<glm::vec3> deltas = reader.accessors.read<glm::vec3>(*accessor, primitive.selection);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < 3; ++c) values[i][c] += weight * deltas[i][c];
}

void check_finite(const JsonObject& json, const Primitive& primitive, std::string_view after) {
    for (const glm::vec3& p : primitive.positions)
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            json.fail("", fmt::format("a position is not finite after {}", after));
}

} // namespace

void apply_morph_targets(const JsonObject& json, std::span<const float> weights, PrimitiveReader& reader,
                         Primitive& primitive) {
    if (primitive.triangles.empty() ||
        std::all_of(weights.begin(), weights.end(), [](float weight) { return weight == 0; }))
        return;
    const std::vector<JsonObject> targets = json.objects("targets");
    for (std::size_t i = 0; i < std::min(targets.size(), weights.size()); ++i) {
        if (weights[i] == 0) continue;
        displace(targets[i], "POSITION", weights[i], reader, primitive, primitive.positions);
        displace(targets[i], "NORMAL", weights[i], reader, primitive, primitive.normals);
        displace(targets[i], "TANGENT", weights[i], reader, primitive, primitive.tangents);
    }
    check_finite(json, primitive, "morphing");
}

std::vector<glm::mat4> joint_matrices(const JsonObject& skin, const Nodes& nodes, Accessors& accessors) {
    const std::vector<std::uint32_t> joints = skin.indices("joints", nodes.count(), "node");
    if (joints.empty()) skin.fail("joints", "is empty or missing");
    std::vector<glm::mat4> matrices;
    if (const auto accessor = skin.index("inverseBindMatrices", accessors.count(), "accessor")) {
        if (accessors.elements(*accessor) < joints.size())
            skin.fail("inverseBindMatrices", fmt::format("has {} matrices for {} joints",
                                                         accessors.elements(*accessor), joints.size()));
        matrices = accessors.read<glm::mat4>(*accessor);
    }
    matrices.resize(joints.size(), glm::mat4(1));
    for (std::size_t i = 0; i < joints.size(); ++i) matrices[i] = nodes.to_world(joints[i]) * matrices[i];
    return matrices;
}

void apply_skin(const JsonObject& json, std::span<const glm::mat4> joints, Primitive& primitive) {
    for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        glm::mat4 blended(0);
        float total = 0;
        for (const Influences& set : primitive.influences)
            for (int k = 0; k < 4; ++k) {
                const float weight = set.weights[v][k];
                if (weight == 0) continue;
                if (set.joints[v][k] >= joints.size())
                    json.fail("attributes", fmt::format("vertex {} follows joint {}, the skin has {}", v,
                                                        set.joints[v][k], joints.size()));
                blended += weight * joints[set.joints[v][k]];
                total += weight;
            }
        // Weights should sum to 1 and often do not quite. A vertex without any follows the first joint.
        blended = total > 0 ? blended / total : joints[0];
        const glm::mat3 linear(blended);
        primitive.positions[v] = glm::vec3(blended * glm::vec4(primitive.positions[v], 1));
        // The cofactor matrix: the inverse transpose up to its length, defined for singular matrices too.
        const glm::mat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                 glm::cross(linear[0], linear[1]));
        const float flip = glm::dot(cofactor[0], linear[0]) < 0 ? -1.0f : 1.0f;
        if (!primitive.normals.empty()) primitive.normals[v] = flip * (cofactor * primitive.normals[v]);
        if (!primitive.tangents.empty())
            primitive.tangents[v] =
                glm::vec4(linear * glm::vec3(primitive.tangents[v]), primitive.tangents[v].w);
    }
    check_finite(json, primitive, "skinning");
}

} // namespace ajar::gltf
