#include "unit/import/compressed_files.hpp"

#include "base/error.hpp"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

namespace ajar::test {

unsigned compressed_view(GltfBuilder& b, const std::vector<unsigned char>& bytes, std::size_t count,
                         std::size_t stride, const char* mode, const char* filter, const char* name) {
    const unsigned raw = b.view(bytes);
    nlohmann::json extension = b.json["bufferViews"][raw];
    extension["count"] = count;
    extension["byteStride"] = stride;
    extension["mode"] = mode;
    extension["filter"] = filter;
    b.json["bufferViews"][raw] = {
        {"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{name, extension}}}};
    // The fallback buffer has no bytes anywhere, as gltfpack writes it.
    b.json["buffers"] = {{{"byteLength", b.bin.size()}}, {{"byteLength", count * stride}}};
    return raw;
}

std::vector<char> draco_square() {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int normal = builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
    const glm::vec3 up(0, 0, 1);
    for (unsigned f = 0; f < 2; ++f) {
        const draco::FaceIndex face(f);
        builder.SetAttributeValuesForFace(position, face, &SQUARE[SQUARE_INDICES[3 * f]].x,
                                          &SQUARE[SQUARE_INDICES[3 * f + 1]].x,
                                          &SQUARE[SQUARE_INDICES[3 * f + 2]].x);
        builder.SetAttributeValuesForFace(normal, face, &up.x, &up.x, &up.x);
    }
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::EncoderBuffer buffer;
    draco::Encoder encoder;
    if (!encoder.EncodeMeshToBuffer(*mesh, &buffer).ok()) throw Error("Draco cannot encode the square");
    return {buffer.data(), buffer.data() + buffer.size()};
}

GltfBuilder draco_file(const std::vector<char>& stream) {
    GltfBuilder b;
    const unsigned view = b.view(stream);
    const unsigned position = b.push("accessors", {{"componentType", F32}, {"count", 4}, {"type", "VEC3"}});
    const unsigned normal = b.push("accessors", {{"componentType", F32}, {"count", 4}, {"type", "VEC3"}});
    const unsigned index = b.push("accessors", {{"componentType", U16}, {"count", 6}, {"type", "SCALAR"}});
    b.show({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
            {"indices", index},
            {"extensions",
             {{"KHR_draco_mesh_compression",
               {{"bufferView", view}, {"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}}}}}});
    b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return b;
}

} // namespace ajar::test
