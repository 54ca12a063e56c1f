// Recording, submitting and timing. After every dispatch stands one barrier for everything: the stages of a
// path tracer depend on each other, so finer ones gain nothing.
#include "base/clock.hpp"
#include "base/error.hpp"
#include "gpu/device_impl.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

namespace ajar::gpu {
namespace {

constexpr std::uint32_t STAMPS_PER_POOL = 512;

void full_barrier(const vk::raii::CommandBuffer& commands) {
    using Stage = vk::PipelineStageFlagBits;
    using Access = vk::AccessFlagBits;
    const vk::MemoryBarrier barrier(Access::eShaderWrite, Access::eShaderRead | Access::eShaderWrite |
                                                              Access::eUniformRead | Access::eTransferRead |
                                                              Access::eTransferWrite | Access::eHostRead);
    commands.pipelineBarrier(Stage::eComputeShader, Stage::eComputeShader | Stage::eTransfer | Stage::eHost,
                             {}, barrier, {}, {});
}

} // namespace

Submitter::Submitter(const Device::Impl& device_in) : device(device_in) {
    try {
        pool = vk::raii::CommandPool(device.device, {{}, device.facts.queue_family});
        commands = std::move(
            vk::raii::CommandBuffers(device.device, {*pool, vk::CommandBufferLevel::ePrimary, 1}).front());
        fence = vk::raii::Fence(device.device, vk::FenceCreateInfo());
    } catch (const vk::SystemError& error) {
        throw_error("command buffer", error);
    }
}

void Submitter::begin() {
    if (recording) return;
    commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    recording = true;
}

void Submitter::run(const std::string& what) {
    if (!recording) return;
    try {
        commands.end();
        const vk::SubmitInfo info({}, {}, *commands);
        {
            const std::lock_guard lock(device.queue_mutex);
            device.queue.submit(info, *fence);
        }
        const auto result = device.device.waitForFences(*fence, true, UINT64_MAX);
        if (result != vk::Result::eSuccess) throw Error(what + ": the device did not finish");
        device.device.resetFences(*fence);
        drop();
    } catch (const vk::SystemError& error) {
        throw_error(what, error);
    }
}

void Submitter::drop() {
    pool.reset();
    recording = false;
}

Commands::Impl::Impl(const Device& device_in) : device(device_in), submitter(device_in.impl()) {}

// Timestamp i is taken after dispatch i - 1; number 0 stands at the beginning.
void Commands::Impl::stamp() {
    if (!device.limits().timestamps || !device.options().timestamps) return;
    const std::uint32_t pool = stamp_count / STAMPS_PER_POOL;
    const std::uint32_t slot = stamp_count % STAMPS_PER_POOL;
    if (pool == queries.size()) {
        queries.emplace_back(device.impl().device,
                             vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, STAMPS_PER_POOL));
    }
    if (slot == 0) submitter.commands.resetQueryPool(*queries[pool], 0, STAMPS_PER_POOL);
    submitter.commands.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *queries[pool], slot);
    ++stamp_count;
}

void Commands::Impl::dispatch(const KernelBase::Impl& kernel, const void* args, std::uint32_t group_count) {
    if (group_count == 0) return;
    assert(set && "bind() comes first");
    const Device::Impl& owner = device.impl();
    const std::uint32_t rows = (group_count - 1) / owner.facts.max_group_count[0] + 1;
    if (rows > owner.facts.max_group_count[1]) {
        throw Error(fmt::format("kernel {}: {} workgroups are more than the device can start", kernel.name,
                                group_count));
    }
    const std::uint32_t columns = (group_count - 1) / rows + 1;
    try {
        submitter.begin();
        const vk::raii::CommandBuffer& commands = submitter.commands;
        if (stamp_count == 0) stamp();
        if (!set_bound) {
            commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *owner.pipeline_layout, 0, set, {});
            set_bound = true;
        }
        if (owner.instance.debug_utils) {
            commands.beginDebugUtilsLabelEXT(vk::DebugUtilsLabelEXT(kernel.name.c_str()));
        }
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *kernel.pipeline);
        commands.pushConstants<std::byte>(*owner.pipeline_layout, vk::ShaderStageFlagBits::eCompute, 0,
                                          {kernel.args_bytes, static_cast<const std::byte*>(args)});
        commands.dispatch(columns, rows, 1);
        full_barrier(commands);
        stamp();
        labels.push_back(kernel.name);
        if (owner.instance.debug_utils) commands.endDebugUtilsLabelEXT();
    } catch (const vk::SystemError& error) {
        throw_error("kernel " + kernel.name, error);
    }
}

double Commands::Impl::collect() {
    const Device::Impl& owner = device.impl();
    std::vector<std::uint64_t> ticks(stamp_count);
    for (std::uint32_t first = 0; first < stamp_count; first += STAMPS_PER_POOL) {
        const std::uint32_t count = std::min(STAMPS_PER_POOL, stamp_count - first);
        // The C function: the C++ one returns another type in each release of the headers.
        const VkResult result = owner.device.getDispatcher()->vkGetQueryPoolResults(
            static_cast<VkDevice>(*owner.device), static_cast<VkQueryPool>(*queries[first / STAMPS_PER_POOL]),
            0, count, count * sizeof(ticks[0]), &ticks[first], sizeof(ticks[0]),
            VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
        if (result != VK_SUCCESS)
            throw_error("timestamps", vk::SystemError(make_error_code(vk::Result(result))));
    }
    // Only the low bits count, and they wrap around.
    const std::uint32_t bits = owner.facts.timestamp_bits;
    const std::uint64_t mask = bits >= 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << bits) - 1;
    double total = 0;
    for (std::size_t i = 0; i + 1 < ticks.size(); ++i) {
        const double seconds =
            static_cast<double>((ticks[i + 1] - ticks[i]) & mask) * owner.facts.timestamp_seconds;
        profile[labels[i]].seconds += seconds;
        total += seconds;
    }
    return total;
}

Commands::Commands(const Device& device) : impl_(std::make_unique<Impl>(device)) {}
Commands::~Commands() = default;

void Commands::bind(const Bindings& bindings) {
    impl_->set = *bindings.impl().set_handle;
    impl_->set_bound = false;
}

double Commands::submit() {
    if (impl_->labels.empty()) return 0;
    const Clock::time_point begin = Clock::now();
    try {
        impl_->submitter.run("running " + impl_->labels.front() + " to " + impl_->labels.back());
    } catch (const Error&) {
        reset();
        throw;
    }
    double seconds = seconds_since(begin);
    for (const std::string& label : impl_->labels) ++impl_->profile[label].dispatches;
    if (impl_->stamp_count > 0) seconds = impl_->collect();
    reset();
    return seconds;
}

void Commands::reset() {
    if (impl_->submitter.recording) impl_->submitter.drop();
    impl_->labels.clear();
    impl_->stamp_count = 0;
    impl_->set_bound = false;
}

const Profile& Commands::profile() const { return impl_->profile; }

} // namespace ajar::gpu
