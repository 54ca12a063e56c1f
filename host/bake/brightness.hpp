// How bright baked light is, against what can be stored: 8 bits, and vertex colours up to 1.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace ajar {

class Brightness {
  public:
    // The sum times 2^exposure, cut to [0, 1]. What is reflected counts as too bright where the channel is
    // cut of which most is seen; `times` is what it is multiplied by when it is seen. That emitters are cut
    // is no loss, as they would be in any picture of that exposure.
    glm::vec3 stored(const glm::vec3& reflected, const glm::vec3& emitted, float exposure,
                     const glm::vec3& times = glm::vec3(1)) {
        const float scale = std::exp2(exposure);
        const glm::vec3 seen = reflected * times;
        const int channel = seen.x >= seen.y ? (seen.x >= seen.z ? 0 : 2) : (seen.y >= seen.z ? 1 : 2);
        ++count_;
        if (scale * reflected[channel] > 1) ++clipped_;
        most_ = std::max(most_, scale * reflected[channel]);
        return glm::clamp(scale * (reflected + emitted), 0.0f, 1.0f);
    }

    double clipped_share() const {
        return count_ == 0 ? 0 : static_cast<double>(clipped_) / static_cast<double>(count_);
    }
    // To be taken from the exposure so that nothing is cut.
    double stops_too_bright() const { return most_ > 1 ? std::log2(static_cast<double>(most_)) : 0; }

  private:
    std::uint64_t count_ = 0, clipped_ = 0;
    float most_ = 0;
};

} // namespace ajar
