// The wavefront path tracers: path (next-event estimation with multiple importance sampling), direct (the
// same without indirect bounces) and naive.
#include "base/error.hpp"
#include "render/choices.hpp"
#include "render/integrator.hpp"
#include "shaders/kernels/connect.glsl.h"
#include "shaders/kernels/extend.glsl.h"
#include "shaders/kernels/naive.glsl.h"
#include "shaders/kernels/shade.glsl.h"
#include "shaders/shared/specialization.glsl.h"

#include <fmt/format.h>
#include <optional>

namespace ajar {

namespace {

using namespace shared;

// Every light is a pair of dispatches at every bounce.
constexpr std::uint32_t MAX_LIGHTS_FOR_ALL = 256;

// How many lights get a shadow ray each; 0: one that is picked.
std::uint32_t lights_in_turn(const IntegratorContext& context) {
    if (find_light_rays(context.settings.light_rays) == SHADE_WHOLE || context.settings.strategy == "bsdf")
        return 0;
    if (context.light_count > MAX_LIGHTS_FOR_ALL)
        throw Error(fmt::format("light rays 'all': the scene has {} lights, more than {} (use 'one', which "
                                "picks one of them)",
                                context.light_count, MAX_LIGHTS_FOR_ALL));
    return context.light_count;
}

// shade with one of its tasks: at bounce 0 of paths that begin on surfaces, these are white.
class ShadeKernels {
  public:
    ShadeKernels(const IntegratorContext& context, std::uint32_t task)
        : later_(context.device, "shade", specialization(context, task)),
          first_(context.device, "shade",
                 specialization(context, context.from_surfaces ? task | SHADE_WHITE : task)) {}
    const gpu::Kernel<ShadeArgs>& at(std::uint32_t bounce) const { return bounce == 0 ? first_ : later_; }

  private:
    // Visibility is not known yet while it is learned.
    static gpu::Specialization specialization(const IntegratorContext& context, std::uint32_t option) {
        const bool learns = (option & ~SHADE_WHITE) == SHADE_LEARN;
        return learns ? context.with_option(option, LIGHT_SAMPLER_TREE) : context.with_option(option);
    }

    gpu::Kernel<ShadeArgs> later_;
    gpu::Kernel<ShadeArgs> first_;
};

// generate and accumulate are the renderer's: every integrator shares them.
class PathIntegrator : public Integrator {
  public:
    explicit PathIntegrator(const IntegratorContext& context)
        : last_bounce_(context.settings.max_bounces + 1), connects_(context.settings.strategy != "bsdf"),
          from_surfaces_(context.from_surfaces), lights_in_turn_(lights_in_turn(context)),
          extend_camera_(context.device, "extend", context.with_option(EXTEND_CAMERA)),
          extend_bounce_(context.device, "extend", context.with_option(EXTEND_BOUNCE)),
          shade_(context, lights_in_turn_ > 0 ? SHADE_SCATTER : SHADE_WHOLE),
          connect_camera_(context.device, "connect",
                          context.with_option(context.shadow_packets ? CONNECT_TOGETHER : CONNECT_APART)),
          connect_bounce_(context.device, "connect", context.with_option(CONNECT_APART)) {
        if (lights_in_turn_ > 0) light_.emplace(context, SHADE_LIGHT);
        if (lights_in_turn_ > 0 || !connects_ || !learns_visibility(context.settings)) return;
        learn_.emplace(context, SHADE_LEARN);
        count_.emplace(context.device, "connect", context.with_option(CONNECT_LEARN));
    }

    void add_steps(Steps& steps) const override {
        for (std::uint32_t bounce = 0; bounce <= last_bounce_; ++bounce) {
            add_extend(steps, bounce);
            if (bounce == 0) steps.add_aovs();
            if (bounce < last_bounce_) add_all_lights(steps, bounce);
            steps.add(shade_.at(bounce), bounce);
            if (connects_ && lights_in_turn_ == 0 && bounce < last_bounce_) add_connect(steps, bounce);
        }
    }

    void add_learning_steps(Steps& steps) const override {
        for (std::uint32_t bounce = 0; learn_ && bounce < last_bounce_; ++bounce) {
            add_extend(steps, bounce);
            steps.add(learn_->at(bounce), bounce);
            steps.add(*count_, bounce);
        }
    }

  private:
    void add_extend(Steps& steps, std::uint32_t bounce) const {
        if (bounce > 0 || !from_surfaces_) steps.add(bounce == 0 ? extend_camera_ : extend_bounce_, bounce);
    }
    void add_connect(Steps& steps, std::uint32_t bounce) const {
        steps.add(bounce == 0 ? connect_camera_ : connect_bounce_, bounce);
    }
    // Each makes its shadow rays where the last one's were.
    void add_all_lights(Steps& steps, std::uint32_t bounce) const {
        for (std::uint32_t light = 0; light < lights_in_turn_; ++light) {
            steps.add([this, bounce, light](gpu::Commands& commands, const SegmentArgs& slice) {
                ShadeArgs args{slice, light};
                args.segments.bounce = bounce;
                light_->at(bounce).dispatch(commands, args, slice.segment_count);
            });
            add_connect(steps, bounce);
        }
    }

    std::uint32_t last_bounce_; // where only emission is counted
    bool connects_;
    bool from_surfaces_;
    std::uint32_t lights_in_turn_; // 0: shade_ picks one
    std::optional<ShadeKernels> light_;
    std::optional<ShadeKernels> learn_;
    std::optional<gpu::Kernel<ConnectArgs>> count_;
    gpu::Kernel<ExtendArgs> extend_camera_;
    gpu::Kernel<ExtendArgs> extend_bounce_;
    ShadeKernels shade_;
    gpu::Kernel<ConnectArgs> connect_camera_;
    gpu::Kernel<ConnectArgs> connect_bounce_;
};

class NaiveIntegrator : public Integrator {
  public:
    explicit NaiveIntegrator(const IntegratorContext& context)
        : last_bounce_(context.settings.max_bounces + 1),
          extend_camera_(context.device, "extend", context.with_option(EXTEND_CAMERA)),
          extend_bounce_(context.device, "extend", context.with_option(EXTEND_BOUNCE)),
          naive_(
              context.device, "naive",
              context.with_option(context.settings.naive_sampling == "cosine" ? NAIVE_COSINE : NAIVE_BSDF)) {}

    void add_steps(Steps& steps) const override {
        for (std::uint32_t bounce = 0; bounce <= last_bounce_; ++bounce) {
            steps.add(bounce == 0 ? extend_camera_ : extend_bounce_, bounce);
            if (bounce == 0) steps.add_aovs();
            steps.add(naive_, bounce);
        }
    }

  private:
    std::uint32_t last_bounce_;
    gpu::Kernel<ExtendArgs> extend_camera_;
    gpu::Kernel<ExtendArgs> extend_bounce_;
    gpu::Kernel<NaiveArgs> naive_;
};

} // namespace

std::unique_ptr<Integrator> make_path_integrator(const IntegratorContext& context) {
    return std::make_unique<PathIntegrator>(context);
}

std::unique_ptr<Integrator> make_naive_integrator(const IntegratorContext& context) {
    return std::make_unique<NaiveIntegrator>(context);
}

} // namespace ajar
