// Small valid files, one per part of the importer, which the mutation test and the fuzzer start from.
#pragma once

#include "unit/import/gltf_builder.hpp"

#include <string>
#include <vector>

namespace ajar::test {

struct Seed {
    std::string name;
    GltfBuilder builder;
};

std::vector<Seed> seeds();

} // namespace ajar::test
