// Renders a case as disjoint ranges of samples that double, and measures the error of their growing mean: the
// whole curve costs no more samples than its last point.
#pragma once

#include "ajar/ajar.hpp"
#include "cli/lab/options.hpp"
#include "image/convergence.hpp"
#include "image/merge.hpp"
#include "image/relative_error.hpp"
#include "image/ztest.hpp"

#include <functional>
#include <optional>

namespace ajar::cli {

// What was rendered of one set of settings.
struct Samples {
    SampleMean mean;
    double seconds = 0;       // rendering alone
    RenderResult totals;      // rays and losses of all ranges; the last range's manifest; no image
    bool interrupted = false; // a range was given up; `mean` has the whole ones before it
};

// share: of the budget, in [0, 1]. Return false to stop.
using ShareSink = std::function<bool(double share)>;
// Called after a range: its own image, its number of samples; `so_far` includes it.
using RangeSink = std::function<void(const Image& range, std::uint32_t samples, const Samples& so_far)>;

// Ranges end at powers of two, at `stops` and at the budget's end; at least one sample is taken. `first`: the
// first sample, where earlier ones are there already; `spent`: seconds that count although they are past.
Samples render_ranges(Session& session, RenderSettings settings, const Budget& budget, std::uint32_t first,
                      double spent, const std::vector<std::uint32_t>& stops, const RangeSink& each,
                      const ShareSink& share);

// Renders one sample that nobody looks at, so that compiling kernels and uploading are not part of any time.
// Its image's metadata says what was rendered.
RenderResult warm_up(Session& session, RenderSettings settings);

struct Checkpoint {
    std::uint64_t samples = 0; // per pixel
    double seconds = 0;
    double relmse = 0;
};

// Whether a case converges to the reference, by z-tests over the whole picture and over its sixteen parts.
struct MeanTest {
    bool same = true;
    double p = 1; // corrected for the number of tests
};

struct Measured {
    std::string name;
    RenderSettings settings;
    std::vector<Checkpoint> checkpoints;
    RenderResult totals;
    std::optional<SlopeFit> slope;
    std::optional<MeanTest> mean; // absent where the reference has no variance
    double mean_shift = 0;        // relative, of the picture's mean
    std::vector<Image> pictures;  // at the stops, or the last; the beauty alone
    const Checkpoint& last() const { return checkpoints.back(); }
    double efficiency() const; // 1 / (relMSE x seconds)
};

struct ReferenceView {
    const Image& image;
    double noise = 0; // the relMSE that it would have against the truth; errors below ten times that are no
                      // evidence of a slope
};

// Empty when it was interrupted. significance: of the mean's test.
std::optional<Measured> measure(Session& session, const Case& which, const LabPlan& plan,
                                const ReferenceView& reference, double significance, const ShareSink& share);

} // namespace ajar::cli
