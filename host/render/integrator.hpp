// An integrator is an ordered list of dispatches that takes a pass from camera rays to path radiances.
#pragma once

#include "gpu/kernel.hpp"
#include "render/render.hpp"
#include "render/settings.hpp"
#include "shaders/kernels/connect.glsl.h"
#include "shaders/kernels/extend.glsl.h"
#include "shaders/shared/segment_args.glsl.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace ajar {

// What integrators compile their kernels for.
struct IntegratorContext {
    const gpu::Device& device;
    const RenderSettings& settings;
    gpu::Specialization
        specialization;  // workgroup and segment size, tables, features, strategy, light sampler
    bool shadow_packets; // shadow rays of camera rays' hits are better traced together
    std::uint32_t light_count;
    bool from_surfaces; // bounce 0 is where paths begin: nothing to extend, and shaded white

    // The same with SPEC_OPTION set, and another light sampler.
    gpu::Specialization with_option(std::uint32_t option) const;
    gpu::Specialization with_option(std::uint32_t option, std::uint32_t light_sampler) const;
};

// One dispatch, given the slice of segments it works on.
using Step = std::function<void(gpu::Commands&, const shared::SegmentArgs&)>;

// The dispatches of a pass, in order.
class Steps {
  public:
    // trace_shares: workgroups a segment for kernels that trace (SPEC_TRACE_SHARES).
    explicit Steps(std::uint32_t trace_shares) : trace_shares_(trace_shares) {}

    // A kernel over segments; its arguments are the slice alone. The kernel must outlive the steps.
    template <class Args> void add(const gpu::Kernel<Args>& kernel, std::uint32_t bounce) {
        constexpr bool traces =
            std::is_same_v<Args, shared::ExtendArgs> || std::is_same_v<Args, shared::ConnectArgs>;
        const std::uint32_t groups = traces ? trace_shares_ : 1;
        list_.push_back([&kernel, bounce, groups](gpu::Commands& commands, const shared::SegmentArgs& slice) {
            Args args{};
            args.segments = slice;
            args.segments.bounce = bounce;
            kernel.dispatch(commands, args, slice.segment_count * groups);
        });
    }
    void add(Step step) { list_.push_back(std::move(step)); }
    // Where the attributes of first hits are taken, if they are asked for: after bounce 0's extend.
    void add_aovs() {
        if (aovs_) list_.push_back(aovs_);
    }
    void set_aovs(Step step) { aovs_ = std::move(step); }
    const std::vector<Step>& list() const { return list_; }

  private:
    std::uint32_t trace_shares_;
    std::vector<Step> list_;
    Step aovs_;
};

class Integrator {
  public:
    virtual ~Integrator() = default;
    // Adds what lies between generate and accumulate.
    virtual void add_steps(Steps& steps) const = 0;
    // Adds what follows generate in the pass that learns visibility; nothing where it would not be used.
    virtual void add_learning_steps(Steps&) const {}
};

// A row of the table that --integrator and --help print (choices.cpp).
struct IntegratorRow {
    Choice choice;
    std::unique_ptr<Integrator> (*make)(const IntegratorContext&);
    bool from_surfaces = false; // it heeds the context's
    bool shows_patches = false; // it needs what radiosity found for them
};

std::unique_ptr<Integrator> make_path_integrator(const IntegratorContext& context);
std::unique_ptr<Integrator> make_naive_integrator(const IntegratorContext& context);
std::unique_ptr<Integrator> make_normals_integrator(const IntegratorContext& context);
std::unique_ptr<Integrator> make_albedo_integrator(const IntegratorContext& context);
std::unique_ptr<Integrator> make_ao_integrator(const IntegratorContext& context);
std::unique_ptr<Integrator> make_patch_integrator(const IntegratorContext& context);

} // namespace ajar
