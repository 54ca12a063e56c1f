// One image out of several that hold disjoint samples of the same pixels: means by their numbers of samples,
// and the variance that all samples together have.
#pragma once

#include "image/image.hpp"

namespace ajar {

// Images with layers "" and "variance" (of the mean; of a single sample: its square), as the film makes them.
class SampleMean {
  public:
    // Adds an image whose every pixel has that many samples. Throws Error where sizes or layers do not fit.
    void add(const Image& image, std::uint64_t samples);
    std::uint64_t samples() const { return samples_; }
    // Layers "" and "variance". Not before the first add().
    Image image() const;

  private:
    std::uint32_t width_ = 0, height_ = 0;
    std::uint64_t samples_ = 0;
    std::vector<double> sums_;    // R, G, B of each pixel
    std::vector<double> squares_; // sums of the samples' squares
};

} // namespace ajar
