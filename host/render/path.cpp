// The wavefront path tracers: path (next-event estimation with multiple importance sampling) and naive.
#include "render/integrator.hpp"
#include "shaders/kernels/connect.glsl.h"
#include "shaders/kernels/extend.glsl.h"
#include "shaders/kernels/naive.glsl.h"
#include "shaders/kernels/shade.glsl.h"
#include "shaders/shared/specialization.glsl.h"

namespace ajar {

namespace {

using namespace shared;

// generate and accumulate are the renderer's: every integrator shares them.
class PathIntegrator : public Integrator {
  public:
    explicit PathIntegrator(const IntegratorContext& context)
        : last_bounce_(context.settings.max_bounces + 1), connects_(context.settings.strategy != "bsdf"),
          extend_camera_(context.device, "extend", context.with_option(EXTEND_CAMERA)),
          extend_bounce_(context.device, "extend", context.with_option(EXTEND_BOUNCE)),
          shade_(context.device, "shade", context.specialization),
          connect_camera_(context.device, "connect",
                          context.with_option(context.shadow_packets ? CONNECT_TOGETHER : CONNECT_APART)),
          connect_bounce_(context.device, "connect", context.with_option(CONNECT_APART)) {}

    void add_steps(Steps& steps) const override {
        for (std::uint32_t bounce = 0; bounce <= last_bounce_; ++bounce) {
            steps.add(bounce == 0 ? extend_camera_ : extend_bounce_, bounce);
            if (bounce == 0) steps.add_aovs();
            steps.add(shade_, bounce);
            if (connects_ && bounce < last_bounce_)
                steps.add(bounce == 0 ? connect_camera_ : connect_bounce_, bounce);
        }
    }

  private:
    std::uint32_t last_bounce_; // where only emission is counted
    bool connects_;
    gpu::Kernel<ExtendArgs> extend_camera_;
    gpu::Kernel<ExtendArgs> extend_bounce_;
    gpu::Kernel<ShadeArgs> shade_;
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
