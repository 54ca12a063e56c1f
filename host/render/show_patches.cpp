// Integrator radiosity: shows what was solved for the scene's patches, by itself or after one bounce of path
// tracing (the final gather of Reichert 1992).
#include "render/choices.hpp"
#include "render/integrator.hpp"
#include "shaders/kernels/connect.glsl.h"
#include "shaders/kernels/extend.glsl.h"
#include "shaders/kernels/shade.glsl.h"
#include "shaders/kernels/show_patches.glsl.h"

#include <optional>

namespace ajar {

namespace {

using namespace shared;

class PatchIntegrator : public Integrator {
  public:
    explicit PatchIntegrator(const IntegratorContext& context)
        : connects_(context.settings.strategy != "bsdf"),
          extend_camera_(context.device, "extend", context.with_option(EXTEND_CAMERA)),
          show_(context.device, "show_patches",
                context.with_option(find_shading(context.settings.shading) == Shading::flat ? SHOW_FLAT
                                                                                            : SHOW_SMOOTH)) {
        if (find_shading(context.settings.shading) != Shading::gather) return;
        gather_.emplace(Gather{
            {context.device, "shade", context.with_option(SHADE_WHOLE)},
            {context.device, "connect",
             context.with_option(context.shadow_packets ? CONNECT_TOGETHER : CONNECT_APART)},
            {context.device, "extend", context.with_option(EXTEND_BOUNCE)},
        });
    }

    void add_steps(Steps& steps) const override {
        steps.add(extend_camera_, 0);
        steps.add_aovs();
        if (gather_) {
            steps.add(gather_->shade, 0);
            if (connects_) steps.add(gather_->connect, 0);
            steps.add(gather_->extend, 1);
        }
        steps.add(show_, gather_ ? 1 : 0);
    }

  private:
    struct Gather {
        gpu::Kernel<ShadeArgs> shade;
        gpu::Kernel<ConnectArgs> connect;
        gpu::Kernel<ExtendArgs> extend;
    };

    bool connects_;
    gpu::Kernel<ExtendArgs> extend_camera_;
    gpu::Kernel<ShowPatchesArgs> show_;
    std::optional<Gather> gather_;
};

} // namespace

std::unique_ptr<Integrator> make_patch_integrator(const IntegratorContext& context) {
    return std::make_unique<PatchIntegrator>(context);
}

} // namespace ajar
