// What the cases are measured against: an image that is given, or one that is rendered, kept under a key of
// all that decides it, and continued where a later run wants more samples.
#pragma once

#include "cli/lab/measure.hpp"
#include "cli/progress.hpp"

#include <filesystem>

namespace ajar::cli {

struct Reference {
    Image image;
    std::filesystem::path file;
    std::uint64_t samples = 0; // of this file; 0: not known
    std::uint64_t found = 0;   // of those, that an earlier run had left
    double seconds = 0;        // of all of them
    double noise = 0;          // the relMSE that it would have against the truth; 0: not known
    bool given = false;
    bool interrupted = false; // then there may be no image
};

// Throws Error: unreadable, no radiance, another size than `settings` have.
Reference read_reference(const std::filesystem::path& file, const RenderSettings& settings);

// share: of what is left to render. A file in `folder` that cannot be read is replaced, with a warning.
Reference render_reference(Session& session, const LabPlan& plan, const std::filesystem::path& folder,
                           ProgressDisplay& display, const ShareSink& share);

} // namespace ajar::cli
