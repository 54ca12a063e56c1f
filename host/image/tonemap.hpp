// From scene radiance to what a display shows: a table of operators, each linear Rec. 709 in and
// display-linear Rec. 709 in [0, 1] out. To add one: a function and a row in tonemap.cpp; --tonemap and
// --help read the table.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace ajar {

struct TonemapOperator {
    const char* name;
    const char* help;                              // one line
    glm::vec3 (*apply)(const glm::vec3& radiance); // non-negative and finite in
};

// The first is the default, "linear": comparisons and golden images want nothing bent.
std::span<const TonemapOperator> tonemap_operators();

// Throws Error listing the names there are.
const TonemapOperator& find_tonemap(std::string_view name);

struct Tonemap {
    const TonemapOperator* op = &tonemap_operators().front();
    float exposure = 0; // EV: radiance is multiplied by 2^exposure first

    // sRGB-encoded, in [0, 1]. Negative radiance and NaN count as 0, infinity as the largest float.
    glm::vec3 operator()(const glm::vec3& radiance) const;
};

} // namespace ajar
