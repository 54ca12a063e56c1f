#include "radiosity/radiosity_rig.hpp"

#include "render/specialize.hpp"
#include "render/surface_index.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <bit>

namespace ajar {

using namespace shared;

namespace {

// Form factors' random numbers are not those of direct light.
constexpr std::uint32_t OTHER_SEED = 0x666f726d; // "form"

// Front and back of each patch. Patches' barycentrics are those of the device.
std::vector<SurfaceElement> side_elements(const Scene& scene, const GpuScene& gpu_scene,
                                          const PatchMesh& mesh) {
    const SurfaceIndex index(scene, gpu_scene.triangle_sources());
    std::vector<SurfaceElement> elements;
    elements.reserve(2 * mesh.patches.size());
    for (const Patch& patch : mesh.patches) {
        const PatchSource& source = mesh.sources[patch.source];
        SurfaceElement element{index.leaf(source.instance, source.triangle), 0, patch.corners[0],
                               patch.corners[1] - patch.corners[0], patch.corners[2] - patch.corners[0]};
        elements.push_back(element);
        element.flags = ELEMENT_BACK;
        elements.push_back(element);
    }
    return elements;
}

// Sobol points, always: rows of form factors are stratified.
RenderSettings sobol(RenderSettings settings) {
    settings.sampler = "sobol";
    return settings;
}

} // namespace

RadiosityRig::RadiosityRig(const gpu::Device& device_in, const Scene& scene, const GpuScene& gpu_scene,
                           const PatchMesh& mesh_in, const RenderSettings& settings_in, std::uint32_t rays)
    : device(device_in), mesh(mesh_in), settings(settings_in),
      elements(side_elements(scene, gpu_scene, mesh_in)),
      pool(device_in, settings_in, std::uint64_t{elements.size()} * rays),
      trace_shares(ajar::trace_shares(device_in, gpu_scene, pool)),
      element_buffer(device_in, elements.size() * sizeof(SurfaceElement), "sides of patches"),
      commands(device_in),
      patches_(device_in, gpu_scene.triangle_sources(), mesh_in.triangles(), mesh_in.nodes),
      frame_(device_in, sizeof(FrameRecord), "frame"), bindings_(device_in) {
    specialization =
        specialize(device, gpu_scene, pool, sobol(settings), 0, patches_.fits_texel_buffer(device));
    element_buffer.write(std::span<const SurfaceElement>(elements));
    FrameRecord frame = gpu_scene.frame();
    frame.seed = settings.seed ^ OTHER_SEED;
    patches_.describe(frame);
    frame_.write(std::span<const FrameRecord>(&frame, 1));
    bindings_.uniform(frame_);
    pool.bind(bindings_);
    gpu_scene.bind(bindings_);
    patches_.bind(bindings_);
    commands.bind(bindings_);
}

gpu::Specialization RadiosityRig::plain(std::uint32_t option) const {
    const std::uint64_t vector_bytes = (elements.size() + SIDES_BESIDE) * sizeof(SideValue);
    const bool texels = gpu::Bindings::table_fits(device, BIND_SIDE_VALUES, vector_bytes);
    return {{SPEC_WORKGROUP_SIZE, device.workgroup_size()},
            {SPEC_OPTION, option},
            {SPEC_TEXEL_BUFFERS, texels ? 1u : 0u}};
}

std::uint64_t RadiosityRig::device_bytes() const {
    return pool.device_bytes() + patches_.device_bytes() + element_buffer.size_bytes() + frame_.size_bytes();
}

} // namespace ajar
