#include "render/element_materials.hpp"

#include "gpu/commands.hpp"
#include "gpu/kernel.hpp"
#include "render/path_pool.hpp"
#include "render/specialize.hpp"
#include "shaders/kernels/average.glsl.h"

#include <algorithm>

namespace ajar {

using namespace shared;

namespace {

constexpr std::uint32_t POINTS = 64; // four a row and column of a texture's footprint
constexpr std::uint32_t ELEMENTS_AT_ONCE = 1u << 16;

} // namespace

ElementMaterials average_materials(const gpu::Device& device, const GpuScene& scene,
                                   std::span<const SurfaceElement> elements, const RenderSettings& settings) {
    ElementMaterials result;
    if (elements.empty()) return result;
    const PathPool pool(device, settings, 1); // no paths, but kernels are specialised for one
    const gpu::Specialization specialization = specialize(device, scene, pool, settings, 0, true);
    const gpu::Kernel<AverageArgs> kernel(device, "average", specialization);
    FrameRecord frame = scene.frame();
    frame.seed = settings.seed;
    gpu::Buffer frame_buffer(device, sizeof frame, "frame");
    frame_buffer.write(std::span<const FrameRecord>(&frame, 1));
    const std::size_t most = std::min<std::size_t>(elements.size(), ELEMENTS_AT_ONCE);
    gpu::Buffer places(device, most * sizeof(SurfaceElement), "surface elements");
    const gpu::Buffer emission(device, most * sizeof(SideValue), "emission of elements");
    const gpu::Buffer reflectance(device, most * sizeof(SideValue), "reflectance of elements");
    gpu::Bindings bindings(device);
    gpu::Commands commands(device);
    bindings.uniform(frame_buffer);
    pool.bind(bindings);
    scene.bind(bindings);
    commands.bind(bindings);
    for (std::size_t first = 0; first < elements.size(); first += most) {
        const std::size_t count = std::min(most, elements.size() - first);
        places.write(elements.subspan(first, count));
        const AverageArgs args{{places.address()},
                               {emission.address()},
                               {reflectance.address()},
                               0,
                               static_cast<std::uint32_t>(count),
                               POINTS,
                               0};
        kernel.dispatch(commands, args,
                        (args.side_count + device.workgroup_size() - 1) / device.workgroup_size());
        commands.submit();
        for (const SideValue& value : emission.read<SideValue>(0, count))
            result.emission.push_back(value.rgb);
        for (const SideValue& value : reflectance.read<SideValue>(0, count))
            result.reflectance.push_back(value.rgb);
    }
    return result;
}

} // namespace ajar
