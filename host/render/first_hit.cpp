// Integrators that look at camera rays' hits alone: normals, albedo, ao. Examples of what an integrator
// needs.
#include "render/integrator.hpp"
#include "shaders/kernels/albedo.glsl.h"
#include "shaders/kernels/ao.glsl.h"
#include "shaders/kernels/connect.glsl.h"
#include "shaders/kernels/extend.glsl.h"
#include "shaders/kernels/normals.glsl.h"

namespace ajar {

namespace {

using namespace shared;

// One kernel after the camera rays' extend.
template <class Args> class FirstHitIntegrator : public Integrator {
  public:
    FirstHitIntegrator(const IntegratorContext& context, const char* kernel)
        : from_surfaces_(context.from_surfaces),
          extend_(context.device, "extend", context.with_option(EXTEND_CAMERA)),
          show_(context.device, kernel, context.specialization) {}

    void add_steps(Steps& steps) const override {
        if (!from_surfaces_) steps.add(extend_, 0);
        steps.add_aovs();
        steps.add(show_, 0);
    }

  private:
    bool from_surfaces_;
    gpu::Kernel<ExtendArgs> extend_;
    gpu::Kernel<Args> show_;
};

class AoIntegrator : public FirstHitIntegrator<AoArgs> {
  public:
    explicit AoIntegrator(const IntegratorContext& context)
        : FirstHitIntegrator(context, "ao"), connect_(context.device, "connect", context.specialization) {}

    void add_steps(Steps& steps) const override {
        FirstHitIntegrator::add_steps(steps);
        steps.add(connect_, 0);
    }

  private:
    gpu::Kernel<ConnectArgs> connect_;
};

} // namespace

std::unique_ptr<Integrator> make_normals_integrator(const IntegratorContext& context) {
    return std::make_unique<FirstHitIntegrator<NormalsArgs>>(context, "normals");
}

std::unique_ptr<Integrator> make_albedo_integrator(const IntegratorContext& context) {
    return std::make_unique<FirstHitIntegrator<AlbedoArgs>>(context, "albedo");
}

std::unique_ptr<Integrator> make_ao_integrator(const IntegratorContext& context) {
    return std::make_unique<AoIntegrator>(context);
}

} // namespace ajar
