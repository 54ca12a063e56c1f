// The whole language of a struct that C++ and GLSL share. Include it first; see shaders/README.md.
// Fields: uint int float vecN uvecN matN, constant-length arrays, other dual structs, pointers (first).
// Scalar layout.
#ifndef AJAR_DUAL_GLSL_H
#define AJAR_DUAL_GLSL_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define DUAL_BEGIN                                                                                  \
    namespace ajar::shared {                                                                        \
    using uint = std::uint32_t;                                                                     \
    using glm::mat3;                                                                                \
    using glm::mat4;                                                                                \
    using glm::uvec2;                                                                               \
    using glm::uvec3;                                                                               \
    using glm::uvec4;                                                                               \
    using glm::vec2;                                                                                \
    using glm::vec3;                                                                                \
    using glm::vec4;
#define DUAL_END }
#define DUAL_SIZE(T, bytes) static_assert(sizeof(T) == bytes, #T " has another size than its GPU counterpart")
// A typed 64-bit device address.
#define DUAL_PTR(T)                                                                                 \
    struct T##Ptr {                                                                                 \
        std::uint64_t address = 0;                                                                  \
    }
#else
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#define DUAL_BEGIN
#define DUAL_END
#define DUAL_SIZE(T, bytes)
#define DUAL_PTR(T)                                                                                 \
    layout(buffer_reference, scalar, buffer_reference_align = 4) buffer T##Ptr { T at[]; }
#endif

#endif
