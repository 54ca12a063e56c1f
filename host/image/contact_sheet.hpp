// Pictures side by side with their names, figures and magnified insets: what `ajar lab` shows its cases with.
#pragma once

#include "image/canvas.hpp"

#include <string>
#include <vector>

namespace ajar {

struct SheetCell {
    std::string title;            // above the picture
    std::string caption;          // below the insets
    const Image* image = nullptr; // lives as long as the sheet is made
    bool frames_insets = false;   // the insets' places are drawn into the picture
};

struct ContactSheet {
    std::string title;
    std::vector<std::vector<SheetCell>> rows; // all pictures of one size; rows may end early
    std::vector<Region> insets;               // in pixels of the pictures; cut at their borders
    Tonemap tonemap;                          // the same for every picture
};

// For write_image with the operator "linear". Throws Error when there is no picture, or sizes differ.
Image contact_sheet(const ContactSheet& sheet);

// Rows of so many cells that the whole is about as wide as a screen is; the order is kept.
std::vector<std::vector<SheetCell>> flow(std::vector<SheetCell> cells, const ContactSheet& sheet);

// Where pictures of one size differ most from the reference in unlike ways: `count` regions of that width and
// height in pixels that do not overlap (fewer where there is no room). Judged as shown by `tonemap`.
std::vector<Region> choose_insets(const std::vector<const Image*>& images, const Image& reference,
                                  const Tonemap& tonemap, std::uint32_t width, std::uint32_t height,
                                  std::size_t count);

} // namespace ajar
