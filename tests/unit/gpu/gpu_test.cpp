// The shared half of these tests.
#include "gpu_test.hpp"

namespace ajar::gpu {

Device& GpuTest::device(DeviceOptions options) {
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

void GpuTest::TearDown() {
    device_.reset();
    for (const std::string& message : messages_) ADD_FAILURE() << "validation: " << message;
}

std::vector<std::byte> GpuTest::run(const Device& device, std::string_view name, const TestArgs& args,
                                    const Specialization& specialization, std::uint32_t threads,
                                    std::uint64_t out_bytes, const shared::FrameRecord* frame) {
    std::uint32_t size = device.workgroup_size();
    for (const auto& [id, value] : specialization) {
        if (id == shared::SPEC_WORKGROUP_SIZE) size = value;
    }
    Buffer out(device, out_bytes, "out");
    Buffer uniform(device, sizeof(shared::FrameRecord), "frame");
    Bindings bindings(device);
    bindings.storage(shared::BIND_PATHS, out);
    if (frame != nullptr) {
        uniform.write(std::as_bytes(std::span(frame, 1)));
        bindings.uniform(uniform);
    }
    const Kernel<TestArgs> kernel(device, test_kernels(), name, specialization);
    Commands commands(device);
    commands.bind(bindings);
    kernel.dispatch(commands, args, (threads + size - 1) / size);
    commands.submit();
    return out.read<std::byte>(0, out_bytes);
}

std::vector<std::uint32_t> GpuTest::run_words(const Device& device, std::string_view name,
                                              const TestArgs& args, const Specialization& specialization,
                                              std::uint32_t threads) {
    return as<std::uint32_t>(
        run(device, name, args, specialization, threads, args.count * sizeof(std::uint32_t)));
}

} // namespace ajar::gpu
