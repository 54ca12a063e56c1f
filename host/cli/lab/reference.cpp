#include "cli/lab/reference.hpp"

#include "base/hash.hpp"
#include "cli/rendering.hpp"
#include "image/read.hpp"

#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace ajar::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* KEY = "ajar:lab_key";
constexpr const char* SAMPLES = "ajar:lab_samples";
constexpr const char* SECONDS = "ajar:lab_seconds";
constexpr const char* NOISE = "ajar:lab_noise";

// Settings, hashes of scene and shaders, device and version, as the image of one sample names them.
std::string key_of(const RenderResult& one_sample) {
    std::string all;
    for (const auto& [name, value] : one_sample.image.metadata) all += name + ' ' + value + '\n';
    return content_hash(std::as_bytes(std::span(all.data(), all.size())));
}

std::string metadata_text(const Image& image, const char* name) {
    for (const auto& [key, text] : image.metadata)
        if (key == name) return text;
    return {};
}

template <class T> T metadata_number(const Image& image, const char* name) {
    const std::string text = metadata_text(image, name);
    T value{};
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

// Empty where there is none of this key.
Reference find_kept(const fs::path& file, const std::string& key, const RenderSettings& s,
                    ProgressDisplay& display) {
    Reference kept;
    kept.file = file;
    if (std::error_code code; !fs::exists(file, code)) return kept;
    try {
        Image image = read_image(file);
        if (metadata_text(image, KEY) != key || image.width != s.width || image.height != s.height ||
            !image.find("variance"))
            throw Error("it is not what its name says");
        kept.samples = kept.found = metadata_number<std::uint64_t>(image, SAMPLES);
        kept.seconds = metadata_number<double>(image, SECONDS);
        kept.noise = metadata_number<double>(image, NOISE);
        if (kept.samples == 0) throw Error("it does not tell its samples");
        kept.image = std::move(image);
    } catch (const Error& error) {
        display.warning(fmt::format("{}: kept reference replaced: {}", file.string(), error.what()));
        kept = {};
        kept.file = file;
    }
    return kept;
}

bool enough(const Reference& kept, const Budget& budget) {
    return budget.samples > 0 ? kept.samples >= budget.samples
                              : kept.samples > 0 && kept.seconds >= budget.seconds;
}

void keep(const Reference& r, const RenderResult& one_sample, const std::string& key) {
    Image image = r.image;
    image.metadata = one_sample.image.metadata;
    image.metadata.emplace_back(KEY, key);
    image.metadata.emplace_back(SAMPLES, std::to_string(r.samples));
    image.metadata.emplace_back(SECONDS, fmt::format("{}", r.seconds));
    image.metadata.emplace_back(NOISE, fmt::format("{}", r.noise));
    SaveOptions options;
    options.full_floats = true;
    save_image(r.file, image, options);
}

// What the mean of na + nb samples lacks, by the difference of its two parts: that has variance
// s (1/na + 1/nb) of which the mean has s / (na + nb). Stratified samples have less.
double noise_of_parts(const Image& a, double na, const Image& b, double nb) {
    return relative_error(a, b).mse * na * nb / ((na + nb) * (na + nb));
}

} // namespace

Reference read_reference(const fs::path& file, const RenderSettings& s) {
    Reference r;
    r.image = read_image(file);
    r.file = file;
    r.given = true;
    const Layer& pixels = beauty(r.image, file.string());
    if (r.image.range != Range::scene)
        throw Error(fmt::format("{}: holds no radiance (an .exr of `ajar render` does)", file.string()));
    if (r.image.width != s.width || r.image.height != s.height)
        throw Error(fmt::format("{}: is {} x {} pixels, not {} x {} (see --size)", file.string(),
                                r.image.width, r.image.height, s.width, s.height));
    for (const float value : pixels.pixels)
        if (!std::isfinite(value))
            throw Error(fmt::format("{}: holds a value that is not finite", file.string()));
    if (const Layer* variance = r.image.find("variance"); variance && variance->channels >= 3)
        r.noise = relative_variance(r.image);
    return r;
}

Reference render_reference(Session& session, const LabPlan& plan, const fs::path& folder,
                           ProgressDisplay& display, const ShareSink& share) {
    const RenderResult one_sample = warm_up(session, plan.reference_settings);
    const std::string key = key_of(one_sample);
    Reference r =
        find_kept(folder / fmt::format("reference-{}.exr", key), key, plan.reference_settings, display);
    if (enough(r, plan.reference_budget)) return r;
    const std::uint64_t found = r.found;
    const Image before = r.image; // what an earlier run had left, if anything
    Budget budget = plan.reference_budget;
    if (budget.seconds > 0) budget.seconds -= r.seconds;
    const auto each = [&](const Image& range, std::uint32_t count, const Samples& so_far) {
        SampleMean mean = so_far.mean;
        if (found > 0) mean.add(before, found);
        const double others = static_cast<double>(mean.samples()) - count; // r.image is of those
        if (others > 0) r.noise = noise_of_parts(range, count, r.image, others);
        r.image = mean.image();
    };
    const Samples samples = render_ranges(session, plan.reference_settings, budget,
                                          static_cast<std::uint32_t>(found), 0, {}, each, share);
    r.interrupted = samples.interrupted;
    r.samples = r.found + samples.mean.samples();
    r.seconds += samples.seconds;
    warn_of_losses(samples.totals, display, "reference: ");
    if (samples.mean.samples() > 0) keep(r, one_sample, key);
    return r;
}

} // namespace ajar::cli
