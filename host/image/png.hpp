// What OpenImageIO's PNG reader is given: a file checked from end to end, without the chunks that decide no
// pixel. So libpng never prints about a foreign colour profile or a cut-off end, nothing is unpacked but
// pixels, and no gamma or profile chunk can bend colours (glTF 2.0, section 3.8, says to ignore them).
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace ajar {

// The PNG's IHDR, PLTE, tRNS, IDAT and IEND chunks. Throws Error starting with `name` on a bad length, CRC or
// end.
std::vector<std::byte> essential_png(std::span<const std::byte> bytes, std::string_view name);

} // namespace ajar
