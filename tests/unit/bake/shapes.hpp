// Scenes whose surfaces are hard to cut up, for the tests of charts and atlases.
#pragma once

#include "support/scene_builder.hpp"

#include <string>
#include <utility>
#include <vector>

namespace ajar::test {

// Name and scene: flat and curved, open and closed, mirrored and stretched, ramps over themselves, specks.
std::vector<std::pair<std::string, Scene>> awkward_scenes();

} // namespace ajar::test
