// A segment's paths sorted by what they met, in order, so that each kind is dealt with by full workgroups:
// few rays meet a light, and many leave the scene, but where a driver runs both sides of a branch all threads
// wait for those that do. (pbrt-v4 has queues for escaped rays and for emitters that were hit; Pharr et al.
// 2023, section 15.3.)
#ifndef AJAR_HIT_LISTS_GLSL
#define AJAR_HIT_LISTS_GLSL
#include "../shared/bvh.glsl.h"
#include "paths.glsl"
#include "scan.glsl"

// Slots of the segment, by what their paths met: 12 KiB at most, and every device has 16.
shared uint hit_scattering[SEGMENT_SIZE]; // something that scatters light
shared uint hit_emitting[SEGMENT_SIZE];   // something that emits light; it may scatter, too
shared uint hit_escaped[SEGMENT_SIZE];    // nothing

// How many of each kind.
struct HitLists {
    uint scattering;
    uint emitting;
    uint escaped;
};

// Lists that are made besides that of what scatters, and what counts as such.
const uint HIT_LISTS_EMITTING = 1u << 0;
const uint HIT_LISTS_ESCAPED = 1u << 1;
const uint HIT_LISTS_ALL_SCATTER = 1u << 2; // whatever was met
const uint HIT_LISTS_ALL_EMIT = 1u << 3;

// Of the paths in slots first to first + count - 1. For all threads of the workgroup, under uniform control
// flow. Everything is stored, also what is not listed: into places that come next (scan_place).
HitLists hit_lists(uint first, uint count, const uint wanted) {
    HitLists lists = HitLists(0u, 0u, 0u);
    for (uint base = 0u; base < count; base += WORKGROUP_SIZE) {
        uint i = base + gl_LocalInvocationID.x;
        bool exists = i < count;
        uint triangle = path_triangle(first + min(i, count - 1u));
        bool hit = exists && triangle != NO_TRIANGLE;
        uint flags = fetch_triangle(hit ? triangle * TRIANGLE_TEXELS : 0u).w;
        bool scatters = hit && ((wanted & HIT_LISTS_ALL_SCATTER) != 0u || (flags & TRIANGLE_SCATTERS) != 0u);
        Scan scattering = scan_keepers(scatters);
        hit_scattering[lists.scattering + scan_place(scattering, scatters)] = i;
        lists.scattering += scattering.total;
        if ((wanted & HIT_LISTS_EMITTING) != 0u) {
            bool emits = hit && ((wanted & HIT_LISTS_ALL_EMIT) != 0u || (flags & TRIANGLE_EMITS) != 0u);
            Scan emitting = scan_keepers(emits);
            hit_emitting[lists.emitting + scan_place(emitting, emits)] = i;
            lists.emitting += emitting.total;
        }
        if ((wanted & HIT_LISTS_ESCAPED) != 0u) {
            bool escapes = exists && !hit;
            Scan escaped = scan_keepers(escapes);
            hit_escaped[lists.escaped + scan_place(escaped, escapes)] = i;
            lists.escaped += escaped.total;
        }
        scan_barrier();
        if (base + WORKGROUP_SIZE >= count) break;
    }
    return lists;
}

#endif
