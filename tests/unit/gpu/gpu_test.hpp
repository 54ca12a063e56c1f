// What the tests of this folder share: a device with the validation layer on, whose silence every test
// requires, and a way to run one of the kernels in shaders/.
#pragma once

#include "base/error.hpp"
#include "gpu/kernel.hpp"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/specialization.glsl.h"
#include "test_kernels.hpp"

#include <gtest/gtest.h>

namespace ajar::gpu {

// The push constants of all kernels in shaders/.
struct TestArgs {
    std::uint32_t count = 0;
    std::uint32_t factor = 0;
    std::uint32_t offset = 0;
};

class GpuTest : public testing::Test {
  protected:
    // Without the layer where it is not installed: then the tests prove a little less.
    Device& device(DeviceOptions options = {});
    void TearDown() override;

    // Runs `name` with `threads` threads and an output of so many bytes at BIND_PATHS, which it returns.
    static std::vector<std::byte> run(const Device& device, std::string_view name, const TestArgs& args,
                                      const Specialization& specialization, std::uint32_t threads,
                                      std::uint64_t out_bytes, const shared::FrameRecord* frame = nullptr);
    // The same where each of args.count threads writes one word.
    static std::vector<std::uint32_t> run_words(const Device& device, std::string_view name,
                                                const TestArgs& args, const Specialization& specialization,
                                                std::uint32_t threads);

  private:
    std::vector<std::string> messages_;
    std::unique_ptr<Device> device_;
};

template <class T> std::vector<T> as(const std::vector<std::byte>& bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

template <class F> std::string error_of(F&& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace ajar::gpu
