// Fixture for tests that run kernels: one device for the test suite, under the validation layer, whose
// messages fail the test that causes them.
#pragma once

#include "gpu/kernel.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace ajar::test {

class GpuTest : public testing::Test {
  public:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void TearDown() override;

  protected:
    static const gpu::Device& device() { return *device_; }
    static constexpr std::uint32_t WORKGROUP_SIZE = 64;

    static std::uint32_t groups_of(std::size_t items) {
        return static_cast<std::uint32_t>((items + WORKGROUP_SIZE - 1) / WORKGROUP_SIZE);
    }

  private:
    static std::unique_ptr<gpu::Device> device_;
    static std::string messages_;
};

} // namespace ajar::test
