// receive: the product of rows with a vector: out_i = sum over j of F_ij x_j, the mean of what the row's rays
// met, in the rays' order, so that a row gives the same bits whenever it is computed. The scalars, too. One
// thread per row.
#ifndef AJAR_RECEIVE_GLSL_H
#define AJAR_RECEIVE_GLSL_H
#include "../shared/radiosity.glsl.h"
DUAL_BEGIN

struct ReceiveArgs {
    RowWordPtr rows;        // of row first_row on
    SideIndexPtr row_sides; // by row
    SideValuePtr from;      // x; also BIND_SIDE_VALUES, which is read unless SPEC_TEXEL_BUFFERS is 0
    SideValuePtr to;        // out, by side
    uint first_row;
    uint row_count;
    uint rays_log2;         // rays of a row, at least 4
    uint pad;
};
DUAL_SIZE(ReceiveArgs, 48);

DUAL_END
#endif
