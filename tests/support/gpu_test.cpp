#include "support/gpu_test.hpp"

namespace ajar::test {

std::unique_ptr<gpu::Device> GpuTest::device_;
std::string GpuTest::messages_;

void GpuTest::SetUpTestSuite() {
    gpu::DeviceOptions options;
    options.validation = true;
    options.on_validation = [](std::string_view message) { messages_.append(message).append("\n"); };
    device_ = std::make_unique<gpu::Device>(options);
}

void GpuTest::TearDownTestSuite() { device_.reset(); }

void GpuTest::TearDown() {
    EXPECT_EQ(messages_, "") << "the validation layer complains";
    messages_.clear();
}

} // namespace ajar::test
