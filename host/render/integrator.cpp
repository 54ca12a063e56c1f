#include "render/integrator.hpp"

#include "shaders/shared/specialization.glsl.h"

namespace ajar {

gpu::Specialization IntegratorContext::with_option(std::uint32_t option) const {
    gpu::Specialization with = specialization;
    with.emplace_back(shared::SPEC_OPTION, option);
    return with;
}

gpu::Specialization IntegratorContext::with_option(std::uint32_t option, std::uint32_t light_sampler) const {
    gpu::Specialization with = with_option(option);
    for (auto& [id, value] : with)
        if (id == shared::SPEC_LIGHT_SAMPLER) value = light_sampler;
    return with;
}

} // namespace ajar
