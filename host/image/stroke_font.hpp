// Letters as strokes on a grid of five by nine points, drawn for this program: sans serif, proportional.
#pragma once

#include <string_view>

namespace ajar {

inline constexpr float STROKE_FONT_CAPITALS = 6; // grid steps from a capital's top (0) to its foot
inline constexpr float STROKE_FONT_GAP = 1.9f;   // between the strokes of neighbouring letters

// Pairs of digits x, y, y downwards; a space begins another stroke; two equal points are a dot. A character
// that the font lacks is a box.
std::string_view glyph_strokes(char character);

// Of its strokes, in grid steps.
float glyph_width(char character);

} // namespace ajar
