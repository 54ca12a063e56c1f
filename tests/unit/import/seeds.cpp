#include "unit/import/seeds.hpp"

#include "unit/import/compressed_files.hpp"

namespace ajar::test {

namespace {

GltfBuilder strip_with_indices() {
    GltfBuilder b;
    const unsigned position = b.add(SQUARE);
    b.show({{"attributes", {{"POSITION", position}}},
            {"indices", b.add(std::vector<std::uint16_t>{0, 1, 2, 3})},
            {"mode", 5}});
    b.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", position}}}, {"mode", 0}});
    return b;
}

GltfBuilder sparse_accessor() {
    GltfBuilder b = triangle();
    const unsigned index_view = b.view(std::vector<std::uint16_t>{1});
    const unsigned value_view = b.view(std::vector<glm::vec3>{{2, 0, 0}});
    b.json["accessors"][0]["sparse"] = {{"count", 1},
                                        {"indices", {{"bufferView", index_view}, {"componentType", U16}}},
                                        {"values", {{"bufferView", value_view}}}};
    return b;
}

GltfBuilder every_material_property() {
    const nlohmann::json map = {
        {"index", 0},
        {"texCoord", 0},
        {"extensions",
         {{"KHR_texture_transform",
           {{"offset", {0.1, 0.2}}, {"rotation", 0.3}, {"scale", {2, 3}}, {"texCoord", 0}}}}}};
    GltfBuilder b = textured_triangle(
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {1, 0.5, 0.25, 1}},
           {"baseColorTexture", map},
           {"metallicFactor", 0.5},
           {"roughnessFactor", 0.5}}},
         {"normalTexture", map},
         {"occlusionTexture", map},
         {"emissiveTexture", map},
         {"emissiveFactor", {1, 1, 1}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.3},
         {"doubleSided", true},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2}}},
           {"KHR_materials_ior", {{"ior", 1.4}}},
           {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 1, 1}}}},
           {"KHR_materials_unlit", nlohmann::json::object()}}}});
    b.push("images", {{"bufferView", b.view(one_texel(1, 2, 3))}, {"mimeType", "image/png"}});
    b.push("samplers", {{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}});
    b.push("textures", {{"source", 0}, {"sampler", 0}});
    const unsigned colors = b.view(std::vector<std::uint16_t>(12, 65535));
    b.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = b.accessor(colors, U16, 3, "VEC4", true);
    return b;
}

GltfBuilder tree_of_everything() {
    GltfBuilder b = triangle();
    b.json["nodes"] = {{{"children", {1, 2}}, {"scale", {1, -2, 3}}, {"rotation", {0, 0, 1, 0}}},
                       {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1}}},
                       {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
    b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
    b.json["extensionsUsed"] = {"KHR_lights_punctual"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"},
         {"color", {1, 1, 1}},
         {"intensity", 3},
         {"range", 9},
         {"extras", {{"radius", 0.2}}},
         {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
    b.json["meshes"][0]["extras"]["ajar_sphere"] = true;
    return b;
}

GltfBuilder skin_and_morph() {
    GltfBuilder b = triangle();
    auto& primitive = b.json["meshes"][0]["primitives"][0];
    const unsigned joints = b.view(std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    primitive["attributes"]["JOINTS_0"] = b.accessor(joints, U8, 3, "VEC4");
    primitive["attributes"]["WEIGHTS_0"] = b.add(std::vector<glm::vec4>(3, {0.5f, 0.5f, 0, 0}));
    primitive["targets"] = {{{"POSITION", b.add(std::vector<glm::vec3>(3, {0, 0, 1}))}}};
    b.json["meshes"][0]["weights"] = {0.5};
    b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, {{"translation", {1, 2, 3}}}};
    b.json["scenes"][0]["nodes"] = {0, 1};
    b.json["skins"] = {
        {{"joints", {1, 2}}, {"inverseBindMatrices", b.add(std::vector<glm::mat4>(2, glm::mat4(1)))}}};
    return b;
}

GltfBuilder meshopt_file() {
    std::vector<glm::vec3> filtered(SQUARE.size());
    meshopt_encodeFilterExp(filtered.data(), filtered.size(), sizeof(glm::vec3), 15, &SQUARE[0].x);
    GltfBuilder b;
    const unsigned view = compressed_view(b, encode_vertices(filtered), 4, 12, "ATTRIBUTES", "EXPONENTIAL");
    b.show({{"attributes", {{"POSITION", b.accessor(view, F32, 4, "VEC3")}}}, {"mode", 6}});
    return b;
}

GltfBuilder meshopt_indices() {
    std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(6, 4));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), SQUARE_INDICES.data(), 6));
    GltfBuilder b;
    const unsigned position = b.add(SQUARE);
    const unsigned view = compressed_view(b, bytes, 6, 4, "TRIANGLES");
    b.show({{"attributes", {{"POSITION", position}}}, {"indices", b.accessor(view, U32, 6, "SCALAR")}});
    return b;
}

} // namespace

std::vector<Seed> seeds() {
    return {{"triangle", triangle()},
            {"strip", strip_with_indices()},
            {"sparse", sparse_accessor()},
            {"materials", every_material_property()},
            {"tree", tree_of_everything()},
            {"skin", skin_and_morph()},
            {"meshopt", meshopt_file()},
            {"meshopt_indices", meshopt_indices()},
            {"draco", draco_file(draco_square())}};
}

} // namespace ajar::test
