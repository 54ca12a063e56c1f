// Sizes of the solution and of its rest; see measure.glsl.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "measure.glsl.h"
#include "../core/variants.glsl"
#include "../core/workgroup.glsl"
#include "../radiosity/power.glsl"

layout(push_constant, scalar) uniform ArgsBlock { MeasureArgs args; };

void main() {
    uint thread = workgroup_index() * WORKGROUP_SIZE + gl_LocalInvocationID.x;
    uint first = thread * MEASURE_ROWS;
    if (first >= args.row_count) return;
    RowsMeasure m = RowsMeasure(0.0, 0.0, 0.0, 0.0, 0.0, uint[3](0u, 0u, 0u));
    for (uint k = 0u; k < min(MEASURE_ROWS, args.row_count - first); ++k) {
        uint side = args.row_sides.at[first + k].side;
        float area = args.reflectance.at[side].scalar;
        vec3 value = args.solution.at[side].rgb;
        vec3 rest = args.rest.at[side].rgb;
        float rest_power = power_of(rest, area);
        m.max_rest = max(m.max_rest, math_max3(abs(rest)));
        m.max_value = max(m.max_value, math_max3(abs(value)));
        m.rest_power += rest_power;
        m.power += power_of(value, area);
        m.max_rest_power = max(m.max_rest_power, rest_power);
    }
    args.measures.at[thread] = m;
}
