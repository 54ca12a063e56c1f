// A few small scenes, one for every kind of light and surface, that tests loop over.
#pragma once

#include "scene/scene.hpp"

#include <ostream>
#include <span>

namespace ajar::test {

struct SmallScene {
    const char* name;
    Scene (*build)();
    bool light_alone; // sampling lights alone sees all of it (no mirrors)
};

std::span<const SmallScene> small_scenes();

// How GoogleTest names one.
inline void PrintTo(const SmallScene& scene, std::ostream* out) { *out << scene.name; }

} // namespace ajar::test
