// What options mean for a scene.
#include "render/choices.hpp"
#include "render/render.hpp"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(ChooseLightSampler, TakesTheTreeWhereThereAreMany) {
    EXPECT_EQ(choose_light_sampler("auto", 0), "power");
    EXPECT_EQ(choose_light_sampler("auto", 4), "power");
    EXPECT_EQ(choose_light_sampler("auto", 5), "tree");
    EXPECT_EQ(choose_light_sampler("auto", 1u << 24), "tree");
}

TEST(ChooseLightSampler, LeavesANamedOneAlone) {
    for (const Choice& row : light_samplers())
        for (const std::uint32_t lights : {0u, 100u})
            EXPECT_EQ(choose_light_sampler(row.name, lights), row.name);
}

TEST(ChooseLightSampler, ItsChoiceIsAmongTheSamplers) {
    for (const Choice& option : light_sampler_options())
        for (const std::uint32_t lights : {0u, 100u})
            EXPECT_NO_THROW(find_light_sampler(choose_light_sampler(option.name, lights))) << option.name;
}

} // namespace
} // namespace ajar
