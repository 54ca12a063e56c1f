#include "cli/lab/measure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ajar::cli {

namespace {

// Below an eighth of what is there already another range is not worth its start.
constexpr std::uint64_t SMALLEST_ADDITION = 8;

// The next range's length; 0 at the end.
std::uint32_t next_range(const Budget& budget, std::uint64_t first, std::uint64_t done, double seconds,
                         double rate, const std::vector<std::uint32_t>& stops) {
    const std::uint64_t at = first + done;
    std::uint64_t end = std::bit_floor(at) * 2;
    if (at == 0) end = 1;
    for (const std::uint32_t stop : stops)
        if (stop > at) end = std::min<std::uint64_t>(end, stop);
    end = std::min<std::uint64_t>(end, UINT32_MAX); // the renderer's limit of samples
    if (budget.samples > 0)
        return static_cast<std::uint32_t>(std::min<std::uint64_t>(end, budget.samples) - at);
    if (done == 0) return 1;
    const double fits = std::max(budget.seconds - seconds, 0.0) * rate;
    const std::uint64_t count = std::min(end - at, static_cast<std::uint64_t>(std::min(fits, 1e9)));
    return count * SMALLEST_ADDITION < done ? 0 : static_cast<std::uint32_t>(count);
}

void add_totals(RenderResult& totals, RenderResult& range) {
    totals.samples += range.samples;
    totals.rays += range.rays;
    totals.shadow_rays += range.shadow_rays;
    totals.shadow_rays_open += range.shadow_rays_open;
    if (totals.invalid_samples == 0)
        std::copy(std::begin(range.first_invalid), std::end(range.first_invalid), totals.first_invalid);
    totals.invalid_samples += range.invalid_samples;
    totals.saturated_samples += range.saturated_samples;
    totals.exhausted_loops += range.exhausted_loops;
    totals.manifest = std::move(range.manifest);
}

// Samples that a sequence is laid out for where time is what ends it.
constexpr std::uint32_t TIMED_SEQUENCE = 1u << 16;

Image beauty_of(const Image& image) {
    Image copy{image.width, image.height, {beauty(image, "picture")}, {}, image.range};
    return copy;
}

MeanTest test_means(const Image& image, const Image& reference, double significance) {
    // Large parts: with heavy tails the mean of a few hundred pixels is not normal.
    const BlockSize whole{image.width, image.height};
    const BlockSize part{(image.width + 3) / 4, (image.height + 3) / 4};
    MeanTest test;
    for (const BlockSize block : {whole, part})
        test.p = std::min(test.p, sidak(z_test(image, reference, block, significance).corrected_p, 2));
    test.same = test.p >= significance;
    return test;
}

} // namespace

Samples render_ranges(Session& session, RenderSettings settings, const Budget& budget, std::uint32_t first,
                      double spent, const std::vector<std::uint32_t>& stops, const RangeSink& each,
                      const ShareSink& share) {
    Samples samples;
    samples.seconds = spent;
    double rate = 0; // samples a second in the last range
    while (true) {
        const std::uint64_t done = samples.mean.samples();
        settings.samples = next_range(budget, first, done, samples.seconds, rate, stops);
        if (settings.samples == 0) break;
        settings.first_sample = first + static_cast<std::uint32_t>(done);
        RenderResult range = session.render(settings, [&](const Progress& p) {
            const double at = budget.samples > 0
                                  ? static_cast<double>(done + p.done) / std::max(budget.samples - first, 1u)
                                  : (samples.seconds + p.seconds) / budget.seconds;
            return !share || share(std::min(at, 1.0));
        });
        if (range.interrupted) {
            samples.interrupted = true;
            break;
        }
        samples.mean.add(range.image, range.samples);
        samples.seconds += range.render_seconds;
        rate = range.samples / std::max(range.render_seconds, 1e-9);
        add_totals(samples.totals, range);
        if (each) each(range.image, range.samples, samples);
    }
    return samples;
}

RenderResult warm_up(Session& session, RenderSettings settings) {
    settings.samples = 1;
    settings.first_sample = 0;
    return session.render(settings);
}

double Measured::efficiency() const {
    const double cost = last().relmse * last().seconds;
    return cost > 0 ? 1 / cost : 0;
}

std::optional<Measured> measure(Session& session, const Case& which, const LabPlan& plan,
                                const ReferenceView& reference, double significance, const ShareSink& share) {
    if (share && !share(0)) return std::nullopt;
    Measured m;
    m.name = which.name, m.settings = which.settings;
    // One picture, so one sequence, though it is made of ranges.
    if (m.settings.sampler == "blue-noise" && m.settings.sequence_samples == 0)
        m.settings.sequence_samples = plan.budget.samples > 0 ? plan.budget.samples : TIMED_SEQUENCE;
    const double learning = warm_up(session, m.settings).learning_seconds;
    std::vector<ErrorPoint> independent;
    const auto each = [&](const Image& range, std::uint32_t count, const Samples& so_far) {
        const RelativeError alone = relative_error(range, reference.image);
        if (alone.mse > 10 * reference.noise)
            independent.push_back({static_cast<double>(count), alone.mse, alone.standard_error});
        const Image mean = so_far.mean.image();
        const RelativeError error = relative_error(mean, reference.image);
        m.checkpoints.push_back({so_far.mean.samples(), so_far.seconds, error.mse});
        m.mean_shift = error.mean_shift;
        if (std::find(plan.stops.begin(), plan.stops.end(), so_far.mean.samples()) != plan.stops.end())
            m.pictures.push_back(beauty_of(mean));
    };
    Samples samples = render_ranges(session, m.settings, plan.budget, 0, learning, plan.stops, each, share);
    if (samples.interrupted) return std::nullopt;
    m.slope = fit_slope(independent);
    const Image mean = samples.mean.image();
    if (reference.image.find("variance")) m.mean = test_means(mean, reference.image, significance);
    if (plan.stops.empty()) m.pictures.push_back(beauty_of(mean));
    m.totals = std::move(samples.totals);
    return m;
}

} // namespace ajar::cli
