// Which segment a workgroup works on, and which pixel and sample a path belongs to.
#ifndef AJAR_SEGMENT_GLSL
#define AJAR_SEGMENT_GLSL
#include "../shared/segment_args.glsl.h"
#include "tables.glsl"
#include "workgroup.glsl"

// The segment of this workgroup, or NO_SEGMENT when there are more workgroups than segments.
const uint NO_SEGMENT = 0xffffffffu;
uint segment_index(SegmentArgs args) {
    uint w = workgroup_index();
    if (w >= args.segment_count) return NO_SEGMENT;
    // Products stay below 2^32: at most 2^16 segments in a dispatch.
    return args.first_segment + (w * args.segment_stride) % args.segment_count;
}

// Paths that segment begins with.
uint segment_fill(SegmentArgs args, uint segment) {
    uint first = segment * SEGMENT_SIZE;
    return min(SEGMENT_SIZE, args.path_count - min(first, args.path_count));
}

struct PathOwner {
    uvec2 pixel;
    uint sample_index;
};

PathOwner segment_owner(SegmentArgs args, uint home) {
    uint packed_pixel = frame.pixel_order.at[args.first_ordinal + (home >> args.samples_log2)].packed;
    PathOwner owner;
    owner.pixel = uvec2(packed_pixel & 0xffffu, packed_pixel >> 16);
    owner.sample_index = args.first_sample + (home & ((1u << args.samples_log2) - 1u));
    return owner;
}

#endif
