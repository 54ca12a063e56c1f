// Extras that make lights soft: radius, angular diameter, and meshes that are spheres.
#include "unit/import/gltf_builder.hpp"

#include "import/info.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace ajar::test {
namespace {

GltfBuilder lit_by(const nlohmann::json& light) {
    GltfBuilder b = triangle();
    b.json["extensionsUsed"] = {"KHR_lights_punctual"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = nlohmann::json::array({light});
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    return b;
}

struct Shape {
    glm::vec3 scale{1};
    float bump = 0; // of one vertex, outwards
    bool open = false;
    bool inwards = false;
};

// Latitudes and longitudes, an odd number around so that its box is not centred, one double seam.
GltfBuilder sphere(const Shape& shape, const nlohmann::json& material = {{"emissiveFactor", {1, 1, 1}}}) {
    constexpr int ROWS = 12;
    constexpr int COLUMNS = 15;
    constexpr float PI = std::numbers::pi_v<float>;
    std::vector<glm::vec3> points;
    std::vector<std::uint16_t> indices;
    for (int r = 0; r <= ROWS; ++r)
        for (int c = 0; c <= COLUMNS; ++c) {
            const float theta = PI * static_cast<float>(r) / ROWS;
            const float phi = 2 * PI * static_cast<float>(c % COLUMNS) / COLUMNS;
            points.push_back(glm::vec3(1, 2, 3) + 2.0f * glm::vec3(std::sin(theta) * std::cos(phi),
                                                                   std::cos(theta),
                                                                   std::sin(theta) * std::sin(phi)));
        }
    points[40] += shape.bump * (points[40] - glm::vec3(1, 2, 3));
    for (int r = 0; r < (shape.open ? ROWS / 2 : ROWS); ++r)
        for (int c = 0; c < COLUMNS; ++c) {
            const int a = r * (COLUMNS + 1) + c;
            const int b = a + COLUMNS + 1;
            for (const int i : {a, a + 1, b, a + 1, b + 1, b})
                indices.push_back(static_cast<std::uint16_t>(i));
        }
    if (shape.inwards) std::reverse(indices.begin(), indices.end());
    GltfBuilder builder;
    builder.push("materials", material);
    const unsigned positions = builder.add(points);
    builder.show(
        {{"attributes", {{"POSITION", positions}}}, {"indices", builder.add(indices)}, {"material", 0}});
    builder.json["nodes"][0]["scale"] = {shape.scale.x, shape.scale.y, shape.scale.z};
    builder.json["nodes"][0]["name"] = "ball";
    builder.json["meshes"][0]["extras"]["ajar_sphere"] = true;
    return builder;
}

std::string only_warning(const ImportResult& result) {
    return result.info.warnings.size() == 1 ? result.info.warnings[0] : "";
}

TEST(GltfExtras, GiveLightsExtent) {
    const ImportResult lamp = import(lit_by({{"type", "point"}, {"extras", {{"radius", 0.25}}}}));
    EXPECT_EQ(lamp.scene.lights.at(0).radius, 0.25f);
    EXPECT_NE(info_text(lamp).find("(point, radius 0.25 m)"), std::string::npos);
    const ImportResult sun = import(
        lit_by({{"type", "directional"}, {"extras", {{"angular_diameter_degrees", 0.53}, {"radius", 3}}}}));
    EXPECT_NEAR(sun.scene.lights.at(0).angular_diameter, 0.53 * std::numbers::pi / 180, 1e-8);
    EXPECT_EQ(sun.scene.lights[0].radius, 0.0f) << "a directional light has none";
    EXPECT_NE(info_text(sun).find("0.53 degrees across"), std::string::npos);
}

TEST(GltfExtras, AreNobodysBusinessButTheirWriters) {
    for (const nlohmann::json& extras :
         {nlohmann::json(5), nlohmann::json("radius"), nlohmann::json::array({1}), nlohmann::json(nullptr),
          nlohmann::json{{"Radius", "large"}}, nlohmann::json{{"radius", 0}}}) {
        const ImportResult result = import(lit_by({{"type", "point"}, {"extras", extras}}));
        EXPECT_EQ(result.scene.lights.at(0).radius, 0.0f) << extras;
        EXPECT_TRUE(result.info.warnings.empty()) << extras;
    }
}

TEST(GltfExtras, ThatCannotBeUsedAreWarnedAbout) {
    for (const nlohmann::json& radius :
         {nlohmann::json(-1), nlohmann::json("large"), nlohmann::json(1e300), nlohmann::json(true)}) {
        const ImportResult result =
            import(lit_by({{"type", "spot"}, {"name", "bulb"}, {"extras", {{"radius", radius}}}}));
        EXPECT_EQ(result.scene.lights.at(0).radius, 0.0f) << radius;
        EXPECT_NE(only_warning(result).find("light 'bulb': extras.radius is ignored"), std::string::npos)
            << radius;
    }
    EXPECT_NE(only_warning(
                  import(lit_by({{"type", "directional"}, {"extras", {{"angular_diameter_degrees", 200}}}})))
                  .find("extras.angular_diameter_degrees is ignored"),
              std::string::npos);
}

TEST(GltfExtras, MakeASphereOfAMeshThatIsOne) {
    for (const bool by_node : {false, true}) {
        GltfBuilder builder = sphere({glm::vec3(0.5f)});
        if (by_node) {
            builder.json["nodes"][0]["extras"] = builder.json["meshes"][0]["extras"];
            builder.json["meshes"][0].erase("extras");
        }
        const ImportResult result = import(builder);
        EXPECT_TRUE(result.info.warnings.empty());
        const Instance& ball = result.scene.instances.at(0);
        EXPECT_NEAR(ball.sphere_radius, 1, 1e-5);
        EXPECT_LT(glm::length(ball.sphere_center - glm::vec3(0.5f, 1, 1.5f)), 1e-5f);
        for (const glm::vec3& p : result.scene.meshes[0].positions)
            EXPECT_LE(glm::length(0.5f * p - ball.sphere_center), ball.sphere_radius + 1e-6f)
                << "it holds its mesh";
        EXPECT_NE(info_text(result).find("ball (mesh as a sphere, radius 1 m)"), std::string::npos);
    }
}

TEST(GltfExtras, LeaveMeshesThatAreNoSpheresAlone) {
    const nlohmann::json glow{{"emissiveFactor", {1, 1, 1}}};
    nlohmann::json veiled = glow;
    veiled["alphaMode"] = "BLEND";
    const std::pair<GltfBuilder, const char*> cases[] = {
        {sphere({{1, 1.1f, 1}}), "scales it unevenly"},
        {sphere({glm::vec3(1), 0.05f}), "do not lie on a sphere"},
        {sphere({glm::vec3(1), 0, true}), "not closed"},
        {sphere({glm::vec3(1), 0, false, true}), "faces inwards"},
        {sphere({}, {{"doubleSided", false}}), "does not emit"},
        {sphere({}, veiled), "not the same everywhere"}};
    for (const auto& [builder, why] : cases) {
        const ImportResult result = import(builder);
        EXPECT_EQ(result.scene.instances.at(0).sphere_radius, 0.0f) << why;
        EXPECT_NE(only_warning(result).find("node 'ball': extras.ajar_sphere is ignored"), std::string::npos)
            << why;
        EXPECT_NE(only_warning(result).find(why), std::string::npos) << only_warning(result);
    }
    GltfBuilder slight = sphere({{1, 1.004f, 1}, 0.003f});
    EXPECT_GT(import(slight).scene.instances.at(0).sphere_radius, 0.0f) << "one hundredth is allowed";
    GltfBuilder flat = triangle();
    flat.push("materials", glow);
    flat.json["meshes"][0]["primitives"][0]["material"] = 0;
    flat.json["meshes"][0]["extras"]["ajar_sphere"] = true;
    EXPECT_NE(only_warning(import(flat)).find("do not lie on a sphere"), std::string::npos);
    flat.json["meshes"][0]["extras"]["ajar_sphere"] = "yes";
    EXPECT_NE(only_warning(import(flat)).find("not true or false"), std::string::npos);
}

TEST(GltfExtras, MakeASphereOfAMirroredMeshToo) {
    EXPECT_GT(import(sphere({{-1, 1, 1}})).scene.instances.at(0).sphere_radius, 0.0f);
}

} // namespace
} // namespace ajar::test
