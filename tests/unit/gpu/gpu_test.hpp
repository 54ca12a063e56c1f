// What the tests of this folder share: a device with the validation layer on, whose silence every test requires.
#pragma once

#include "base/error.hpp"
#include "gpu/kernel.hpp"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/specialization.glsl.h"
#include "test_kernels.hpp"

#include <gtest/gtest.h>

namespace ajar::gpu {

class GpuTest : public testing::Test {
  protected:
    // Without the layer where it is not installed: then the tests prove a little less.
    Device& device(DeviceOptions options = {}) {
        options.on_validation = [this](std::string_view message) { messages_.emplace_back(message); };
        options.validation = true;
        try {
            device_ = std::make_unique<Device>(options);
        } catch (const Error& error) {
            if (std::string_view(error.what()).find("vulkan-validationlayers") == std::string_view::npos) throw;
            options.validation = false;
            device_ = std::make_unique<Device>(options);
        }
        return *device_;
    }

    void TearDown() override {
        device_.reset();
        for (const std::string& message : messages_) ADD_FAILURE() << "validation: " << message;
    }

  private:
    std::vector<std::string> messages_;
    std::unique_ptr<Device> device_;
};

// Arguments of the kernels in shaders/ here: the same fields as their push constants.
struct FillArgs {
    std::uint32_t count;
    std::uint32_t factor;
    std::uint32_t offset;
};

template <class F> std::string error_of(F&& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace ajar::gpu
