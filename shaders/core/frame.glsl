// Orthonormal frames: local z is the normal.
// Basis: Duff et al. 2017, "Building an Orthonormal Basis, Revisited" (continuous but at n.z = 0, no branch).
#ifndef AJAR_FRAME_GLSL
#define AJAR_FRAME_GLSL
#extension GL_GOOGLE_include_directive : require

struct Frame {
    vec3 t;
    vec3 b; // cross(n, t): right-handed
    vec3 n;
};

Frame frame_make(vec3 n) {
    const float s = n.z < 0.0 ? -1.0 : 1.0;
    const float a = -1.0 / (s + n.z);
    const float b = n.x * n.y * a;
    return Frame(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// A frame whose t is `tangent` made perpendicular to the unit vector n; any t where the two are parallel, or
// the tangent is zero or not a number. `handedness` -1 mirrors b, as glTF's tangent.w does.
Frame frame_from_tangent(vec3 n, vec3 tangent, float handedness) {
    const vec3 t = tangent - n * dot(n, tangent);
    const float length2 = dot(t, t);
    Frame basis = frame_make(n);
    // Shorter than this, what is left of a unit tangent is rounding error.
    if (length2 > 1e-8) {
        basis.t = t * inversesqrt(length2);
        basis.b = cross(n, basis.t);
    }
    basis.b *= handedness;
    return basis;
}

vec3 frame_to_world(Frame basis, vec3 v) { return basis.t * v.x + basis.b * v.y + basis.n * v.z; }
vec3 frame_to_local(Frame basis, vec3 v) { return vec3(dot(v, basis.t), dot(v, basis.b), dot(v, basis.n)); }

#endif
