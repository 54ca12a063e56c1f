#include "render/render_job.hpp"

#include "base/clock.hpp"
#include "render/camera.hpp"
#include "render/choices.hpp"
#include "render/sample_sequence.hpp"
#include "render/specialize.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <bit>
#include <limits>

namespace ajar {

using namespace shared;

namespace {

constexpr std::uint32_t MAX_SAMPLES_PER_PASS = 64; // a segment holds whole pixels: no more than its 64 paths

// The settings with every default replaced by what it stands for; the pool's are for the pool to say.
RenderSettings resolved(RenderSettings settings, const GpuScene& scene) {
    if (!(settings.filter_radius > 0))
        settings.filter_radius = settings.filter == PixelFilter::box ? 0.5f : 1.5f;
    if (settings.integrator == "direct") settings.max_bounces = 0;
    if (!(settings.ao_distance > 0)) settings.ao_distance = 0.2f * scene.frame().scene_radius;
    settings.light_sampler = choose_light_sampler(settings.light_sampler, scene.frame().light_count);
    settings.sequence_samples = sequence_samples(settings);
    return settings;
}

// Samples that a pass takes of each pixel: as many as fit in the pool, so that small pictures fill it too,
// and eight at least, so that neighbouring paths begin alike and a pixel's sums are fetched once for all of
// them.
std::uint32_t samples_per_pass(const PathPool& pool, std::uint32_t chunk_pixels) {
    const std::uint32_t fit = std::max(pool.paths() / chunk_pixels, 8u);
    return std::min({std::bit_floor(fit), MAX_SAMPLES_PER_PASS, pool.segment_paths()});
}

} // namespace

RenderJob::RenderJob(const gpu::Device& device, const Scene& scene, const GpuScene& gpu_scene,
                     const RenderSettings& settings, LearnedVisibility* visibility,
                     std::span<const SurfaceElement> elements, const PatchTable* patches)
    : device_(device), settings_(resolved(settings, gpu_scene)), camera_(choose_camera(scene, settings)),
      film_(device,
            elements.empty() ? FilmPixels::picture(settings.width, settings.height)
                             : FilmPixels::list(elements.size()),
            settings.aovs),
      pool_(device, settings,
            std::uint64_t{film_.pixel_count()} * std::min(settings.samples, MAX_SAMPLES_PER_PASS)),
      bindings_(device), commands_(device), diagnostics_(device, sizeof(Diagnostics), "diagnostics"),
      frame_buffer_(device, sizeof(FrameRecord), "frame"), gpu_scene_(gpu_scene), visibility_(visibility),
      patches_(patches), context_{device,
                                  settings_,
                                  specialization(),
                                  gpu_scene.suits_shadow_packets(),
                                  gpu_scene.frame().light_count,
                                  !elements.empty()},
      accumulate_(device, "accumulate", context_.specialization),
      integrator_(find_integrator(settings.integrator).make(context_)),
      steps_(trace_shares(device, gpu_scene, pool_)) {
    if (!elements.empty()) {
        elements_ = gpu::Buffer(device, elements.size_bytes(), "surface elements");
        elements_.write(elements);
        place_.emplace(device, "place", context_.specialization);
    } else {
        const auto filter = static_cast<std::uint32_t>(settings.filter);
        generate_.emplace(device, "generate", context_.with_option(filter));
    }
    settings_.pool_paths = pool_.paths();
    settings_.segment_paths = pool_.segment_paths();
    if (settings.aovs) aov_.emplace(device, "aov", context_.specialization);
    add_steps();
    pool_.bind(bindings_);
    gpu_scene.bind(bindings_);
    if (visibility_ != nullptr) visibility_->bind(bindings_);
    if (patches_ != nullptr) patches_->bind(bindings_);
    write_frame(settings_.seed, settings_.sequence_samples);
    bindings_.uniform(frame_buffer_);
}

gpu::Specialization RenderJob::specialization() const {
    const std::uint32_t features = camera_.kind == CameraKind::orthographic ? FEATURE_ORTHOGRAPHIC : 0;
    const bool fits = (visibility_ == nullptr || visibility_->fits_texel_buffer(device_)) &&
                      (patches_ == nullptr || patches_->fits_texel_buffer(device_));
    return specialize(device_, gpu_scene_, pool_, settings_, features, fits);
}

void RenderJob::add_begin(Steps& steps) const {
    if (generate_) return steps.add(*generate_, 0);
    steps.add([this](gpu::Commands& commands, const SegmentArgs& slice) {
        place_->dispatch(commands, {{elements_.address()}, slice, 0}, slice.segment_count);
    });
}

void RenderJob::add_steps() {
    add_begin(steps_);
    if (aov_)
        steps_.set_aovs([this](gpu::Commands& commands, const SegmentArgs& slice) {
            aov_->dispatch(commands, {slice}, pixel_groups(slice));
        });
    integrator_->add_steps(steps_);
    steps_.add([this](gpu::Commands& commands, const SegmentArgs& slice) {
        accumulate_.dispatch(commands, {slice}, pixel_groups(slice));
    });
}

void RenderJob::write_frame(std::uint32_t seed, std::uint32_t sequence_samples) {
    FrameRecord frame = gpu_scene_.frame();
    place_camera(camera_, settings_.width, settings_.height, frame);
    frame.pixel_order.address = film_.pixel_order().address();
    frame.aovs.address = film_.aovs() ? film_.aovs().address() : 0;
    frame.diagnostics.address = diagnostics_.address();
    frame.pool_paths = pool_.paths();
    frame.seed = seed;
    frame.max_bounces = settings_.max_bounces;
    frame.rr_depth = settings_.rr_depth;
    frame.filter_radius = settings_.filter_radius;
    frame.sequence_log2 = static_cast<std::uint32_t>(std::countr_zero(std::max(sequence_samples, 1u)));
    frame.ao_distance = settings_.ao_distance;
    frame.sample_clamp = settings_.clamp > 0 ? settings_.clamp : std::numeric_limits<float>::max();
    if (visibility_ != nullptr) visibility_->describe(frame);
    if (patches_ != nullptr) patches_->describe(frame);
    frame_buffer_.write(std::span<const FrameRecord>(&frame, 1));
}

// Samples that nobody takes again for the image, enough for some hundreds of cells, one a pixel at least.
bool RenderJob::learn(const ProgressSink& progress) {
    constexpr std::uint32_t PATHS = 1u << 19;
    constexpr std::uint32_t OTHER_SEED = 0x6c656172; // "lear"
    const Clock::time_point start = Clock::now();
    Steps steps(trace_shares(device_, gpu_scene_, pool_));
    add_begin(steps);
    integrator_->add_learning_steps(steps);
    const std::uint32_t samples = std::bit_floor(std::max(PATHS / film_.pixel_count(), 1u));
    const std::uint32_t per_pass =
        std::min(samples, samples_per_pass(pool_, std::min(film_.chunk_pixels(), film_.pixel_count())));
    write_frame(settings_.seed ^ OTHER_SEED, samples);
    PassRunner runner(commands_, steps.list(), settings_.slice_seconds);
    for (std::uint32_t done = 0; done < samples && steps.list().size() > 1; done += per_pass) {
        const auto keep_going = [&] {
            return !progress || progress({"learn", done, samples, seconds_since(start)});
        };
        if (!run_samples(runner, done, per_pass, keep_going)) return false;
    }
    pool_.clear_totals();
    visibility_->freeze();
    write_frame(settings_.seed, settings_.sequence_samples);
    visibility_->seconds = seconds_since(start);
    return true;
}

// Takes `count` samples of every pixel, from that one on.
bool RenderJob::run_samples(PassRunner& runner, std::uint32_t first_sample, std::uint32_t count,
                            const std::function<bool()>& keep_going) {
    const std::uint32_t pass_pixels = std::max(pool_.paths() / count, 1u);
    for (std::size_t chunk = 0; chunk < film_.chunks().size(); ++chunk) {
        const std::uint32_t chunk_first = static_cast<std::uint32_t>(chunk) * film_.chunk_pixels();
        const std::uint32_t chunk_end = std::min(chunk_first + film_.chunk_pixels(), film_.pixel_count());
        bindings_.storage(BIND_FILM, film_.chunks()[chunk]);
        commands_.bind(bindings_);
        for (std::uint32_t first = chunk_first; first < chunk_end; first += pass_pixels) {
            SegmentArgs args{};
            args.path_count = std::min(pass_pixels, chunk_end - first) * count;
            args.segment_count = (args.path_count + pool_.segment_paths() - 1) / pool_.segment_paths();
            args.first_ordinal = first;
            args.chunk_ordinal = chunk_first;
            args.samples_log2 = static_cast<std::uint32_t>(std::countr_zero(count));
            args.first_sample = first_sample;
            if (!runner.run(args, keep_going)) return false;
        }
    }
    return true;
}

RenderOutput RenderJob::run(const ProgressSink& progress) {
    const Clock::time_point start = Clock::now();
    const std::uint32_t per_pass =
        samples_per_pass(pool_, std::min(film_.chunk_pixels(), film_.pixel_count()));
    RenderOutput output;
    RenderStats& stats = output.stats;
    PassRunner runner(commands_, steps_.list(), settings_.slice_seconds);
    const auto keep_going = [&] {
        return !progress || progress({"render", stats.samples, settings_.samples, seconds_since(start)});
    };
    if (visibility_ != nullptr && !visibility_->is_frozen()) {
        stats.interrupted = !learn(progress);
        stats.learning_seconds = visibility_->seconds;
    }
    while (stats.samples < settings_.samples && !stats.interrupted) {
        // One sample first, then as many again: whoever interrupts early has a whole picture.
        const std::uint32_t wanted = std::min(std::max(stats.samples, 1u), settings_.samples - stats.samples);
        const std::uint32_t count = std::bit_floor(std::min(per_pass, wanted));
        if (!run_samples(runner, settings_.first_sample + stats.samples, count, keep_going)) {
            stats.interrupted = true;
            break;
        }
        stats.samples += count;
        if (settings_.time_limit > 0 && seconds_since(start) >= settings_.time_limit &&
            stats.samples < settings_.samples) {
            stats.out_of_time = true;
            break;
        }
    }
    if (!stats.interrupted) keep_going();
    stats.render_seconds = seconds_since(start);
    fill_stats(stats);
    output.image = film_.resolve();
    return output;
}

void RenderJob::fill_stats(RenderStats& stats) const {
    const Diagnostics diagnostics = diagnostics_.read<Diagnostics>(0, 1).front();
    const PoolTotals totals = pool_.totals();
    stats.settings = settings_;
    stats.bvh_seconds = gpu_scene_.bvh_seconds();
    stats.light_tree_seconds = gpu_scene_.light_tree_seconds();
    stats.triangles = gpu_scene_.triangle_count();
    stats.lights = gpu_scene_.frame().light_count;
    stats.device_bytes =
        gpu_scene_.device_bytes() + pool_.device_bytes() + film_.device_bytes() + elements_.size_bytes();
    if (visibility_ != nullptr) stats.device_bytes += visibility_->device_bytes();
    if (patches_ != nullptr) stats.device_bytes += patches_->device_bytes();
    stats.camera_rays = std::uint64_t{film_.pixel_count()} * stats.samples;
    stats.extension_rays = totals.extension_rays;
    stats.shadow_rays = totals.shadow_rays;
    stats.shadow_rays_open = totals.shadow_rays_open;
    stats.exhausted_loops = totals.exhausted_loops;
    stats.invalid_samples = diagnostics.invalid_count;
    stats.invalid_pixel = diagnostics.invalid_pixel;
    stats.invalid_sample = diagnostics.invalid_sample;
    stats.saturated_samples = diagnostics.saturated_count;
    stats.profile = commands_.profile();
}

} // namespace ajar
