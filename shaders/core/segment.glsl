// Which segment a workgroup works on, and which pixel and sample a path belongs to.
#ifndef AJAR_SEGMENT_GLSL
#define AJAR_SEGMENT_GLSL
#include "../shared/segment_args.glsl.h"
#include "sampler.glsl"
#include "tables.glsl"
#include "workgroup.glsl"

// The segment of this workgroup, or NO_SEGMENT when there are more workgroups than segments.
const uint NO_SEGMENT = 0xffffffffu;
uint segment_index_of(SegmentArgs args, uint w) {
    if (w >= args.segment_count) return NO_SEGMENT;
    // Products stay below 2^32: at most 2^16 segments in a dispatch.
    return args.first_segment + (w * args.segment_stride) % args.segment_count;
}
uint segment_index(SegmentArgs args) { return segment_index_of(args, workgroup_index()); }

// The same where TRACE_SHARES workgroups share a segment.
struct SegmentShare {
    uint segment; // or NO_SEGMENT
    uint first;   // of its slots
    uint size;    // slots
};
SegmentShare segment_share(SegmentArgs args) {
    uint size = SEGMENT_SIZE / TRACE_SHARES;
    uint w = workgroup_index();
    return SegmentShare(segment_index_of(args, w / TRACE_SHARES), w % TRACE_SHARES * size, size);
}
// How many of a segment's first `count` slots are in the share.
uint segment_share_of(SegmentShare share, uint count) {
    return min(count - min(count, share.first), share.size);
}

// Paths that segment begins with.
uint segment_fill(SegmentArgs args, uint segment) {
    uint first = segment * SEGMENT_SIZE;
    return min(SEGMENT_SIZE, args.path_count - min(first, args.path_count));
}

struct PathOwner {
    uint ordinal; // of the pixel
    uint sample_index;
};

PathOwner segment_owner(SegmentArgs args, uint home) {
    return PathOwner(args.first_ordinal + (home >> args.samples_log2),
                     args.first_sample + (home & ((1u << args.samples_log2) - 1u)));
}

// The points of a path. Its pixel enters by ordinal, which needs no look-up.
Sampler segment_sampler(SegmentArgs args, uint home) {
    PathOwner owner = segment_owner(args, home);
    return sampler_begin(frame.seed, owner.ordinal, owner.sample_index, frame.sequence_log2);
}

// Random bits of the path's next ray, for stochastic alpha. A shadow ray's differ from the extension's.
uint segment_salt(SegmentArgs args, uint home, bool shadow) {
    PathOwner owner = segment_owner(args, home);
    uint path = rng_combine(rng_combine(frame.seed, owner.ordinal), owner.sample_index);
    return rng_combine(path, 2u * args.bounce + (shadow ? 1u : 0u));
}

#endif
