// Scenes and command lines of renders that take a moment.
#pragma once

#include "cli/run_ajar.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ajar::test {

// A tiny Cornell box; further arguments win over these.
std::vector<std::string> tiny(std::vector<std::string> more);

// The same box, compared by `ajar lab` into a folder.
std::vector<std::string> lab(const std::string& folder, const std::vector<std::string>& more);

// Reads a render's progress (--progress json) until that many samples are done; false where it ends before.
bool wait_for_samples(Process& process, std::uint64_t samples);

// A triangle in view, without material or light.
void write_triangle(const std::filesystem::path& file);
// The same, emitting; `strength` as JSON writes a number.
void write_glowing_triangle(const std::filesystem::path& file, const std::string& strength);

} // namespace ajar::test
