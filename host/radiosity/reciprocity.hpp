// How far rows of form factors are from A_i F_ij = A_j F_ji, which holds of the exact ones.
#pragma once

#include "radiosity/form_factors.hpp"

#include <cstdint>

namespace ajar {

// Over pairs of sides: root mean squares, of the root mean square of the two products' means.
struct Reciprocity {
    std::uint64_t pairs = 0;
    double rms = 0;      // of the products' difference
    double expected = 0; // of that difference if rays were independent: stratified ones do better
    double max = 0;      // greatest difference
};

// Of up to `rows` rows evenly spread, each with a side that its neighbour sees.
Reciprocity measure_reciprocity(const RadiosityRig& rig, FormFactors& factors, std::uint32_t rows);

} // namespace ajar
