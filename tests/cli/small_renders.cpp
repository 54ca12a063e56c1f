#include "cli/small_renders.hpp"

#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;

// With more members of the primitive and of the document.
void write_triangle(const fs::path& file, const std::string& primitive_members, const std::string& members) {
    write_text(file, R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0})" +
                         primitive_members + R"(}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
        "min":[0,0,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])" +
                         members + "}");
}

} // namespace

bool wait_for_samples(Process& process, std::uint64_t samples) {
    for (std::string line = process.read_line(); !line.empty(); line = process.read_line()) {
        const nlohmann::json event = nlohmann::json::parse(line);
        if (event["event"] == "progress" && event["done"].get<std::uint64_t>() >= samples) return true;
    }
    return false;
}

std::vector<std::string> tiny(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", scene_path("cornell-box"), "--size", "24x16", "--samples",
                                       "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::vector<std::string> lab(const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"lab", scene_path("cornell-box"), "--size", "16x16", "-o", folder};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

void write_triangle(const fs::path& file) { write_triangle(file, "", ""); }

void write_glowing_triangle(const fs::path& file, const std::string& strength) {
    write_triangle(file, R"(,"material":0)",
                   R"(,"extensionsUsed":["KHR_materials_emissive_strength"],
        "materials":[{"doubleSided":true,"emissiveFactor":[1,1,1],"extensions":{
        "KHR_materials_emissive_strength":{"emissiveStrength":)" +
                       strength + "}}}]");
}

} // namespace ajar::test
