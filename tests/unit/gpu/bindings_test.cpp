// Tables read the same through texel buffers and through pointers; what is not bound reads as zero.
#include "gpu_test.hpp"

#include <array>
#include <random>

namespace ajar::gpu {
namespace {

class GpuBindings : public GpuTest {};

constexpr std::uint32_t COUNT = 1000;
using Row = std::array<glm::uvec4, shared::TABLE_COUNT>;

// The eight tables filled with noise, and what tables.comp reads from them.
class NoiseTables {
  public:
    explicit NoiseTables(const Device& device) {
        std::mt19937 random(1);
        for (std::uint32_t t = 0; t < shared::TABLE_COUNT; ++t) {
            const std::uint32_t binding = shared::BIND_TABLE_FIRST + t;
            words_[t].resize(binding == shared::BIND_TEXELS ? COUNT : COUNT * 4);
            for (std::uint32_t& word : words_[t]) word = static_cast<std::uint32_t>(random());
            buffers_.emplace_back(device, words_[t].size() * 4, "table");
            buffers_.back().write(std::span<const std::uint32_t>(words_[t]));
        }
    }

    void bind(Bindings& bindings) const {
        for (std::uint32_t t = 0; t < shared::TABLE_COUNT; ++t) {
            bindings.table(shared::BIND_TABLE_FIRST + t, buffers_[t]);
        }
    }

    shared::FrameRecord frame() const {
        shared::FrameRecord frame = {};
        frame.nodes = {buffers_[0].address()};
        frame.triangles = {buffers_[1].address()};
        frame.surfaces = {buffers_[2].address()};
        frame.instances = {buffers_[3].address()};
        frame.materials = {buffers_[4].address()};
        frame.texels = {buffers_[5].address()};
        frame.lights = {buffers_[6].address()};
        frame.environment = {buffers_[7].address()};
        return frame;
    }

    void expect(std::uint32_t i, const Row& row) const {
        for (std::uint32_t t = 0; t < shared::TABLE_COUNT; ++t) {
            for (int c = 0; c < 4; ++c) {
                if (shared::BIND_TABLE_FIRST + t == shared::BIND_TEXELS) {
                    // Vulkan lets a driver be a unit in the last place off when it converts, and lavapipe is.
                    const float expected = static_cast<float>(words_[t][i] >> (8 * c) & 255u) / 255.0f;
                    float seen;
                    std::memcpy(&seen, &row[t][c], sizeof(seen));
                    ASSERT_FLOAT_EQ(seen, expected);
                } else {
                    ASSERT_EQ(row[t][c], words_[t][4 * i + static_cast<std::uint32_t>(c)]) << "table " << t;
                }
            }
        }
    }

  private:
    std::array<std::vector<std::uint32_t>, shared::TABLE_COUNT> words_;
    std::vector<Buffer> buffers_;
};

std::vector<Row> read_tables(const Device& device, const NoiseTables& tables, std::uint32_t texel_buffers) {
    Buffer out(device, COUNT * sizeof(Row), "out");
    Buffer uniform(device, sizeof(shared::FrameRecord), "frame");
    const shared::FrameRecord frame = tables.frame();
    uniform.write(std::as_bytes(std::span(&frame, 1)));
    Bindings bindings(device);
    bindings.storage(shared::BIND_PATHS, out);
    bindings.uniform(uniform);
    tables.bind(bindings);
    const Kernel<TestArgs> kernel(
        device, test_kernels(), "tables",
        {{shared::SPEC_WORKGROUP_SIZE, 8}, {shared::SPEC_TEXEL_BUFFERS, texel_buffers}});
    Commands commands(device);
    commands.bind(bindings);
    kernel.dispatch(commands, {COUNT, 0, 0}, COUNT / 8);
    commands.submit();
    return out.read<Row>(0, COUNT);
}

TEST_F(GpuBindings, TexelBuffersReadWhatWasWritten) {
    Device& d = device();
    const NoiseTables tables(d);
    const auto rows = read_tables(d, tables, 1);
    for (std::uint32_t i = 0; i < COUNT; ++i) tables.expect(i, rows[i]);
}

TEST_F(GpuBindings, PointersReadTheSameAsTexelBuffers) {
    Device& d = device();
    const NoiseTables tables(d);
    const auto rows = read_tables(d, tables, 0);
    for (std::uint32_t i = 0; i < COUNT; ++i) tables.expect(i, rows[i]);
}

TEST_F(GpuBindings, PointersReadTheSameWhereTexelBuffersAreForbidden) {
    Device& d = device({.force_pointers = true});
    const NoiseTables tables(d);
    EXPECT_FALSE(Bindings::table_fits(d, shared::BIND_NODES, 16));
    const auto rows = read_tables(d, tables, 0);
    for (std::uint32_t i = 0; i < COUNT; ++i) tables.expect(i, rows[i]);
}

TEST_F(GpuBindings, WhatIsNotBoundReadsAsZero) {
    Device& d = device();
    const auto words = run_words(d, "nothing_bound", {1, 0, 0}, {{shared::SPEC_WORKGROUP_SIZE, 8}}, 1);
    EXPECT_EQ(words, std::vector<std::uint32_t>{0});
}

TEST_F(GpuBindings, ATableFitsUpToTheDevicesLimits) {
    Device& d = device();
    const std::uint64_t elements = d.limits().max_texel_elements;
    const std::uint64_t two_gib = std::uint64_t(1) << 31;
    EXPECT_TRUE(Bindings::table_fits(d, shared::BIND_NODES, 0));
    EXPECT_TRUE(Bindings::table_fits(d, shared::BIND_NODES, std::min(elements * 16, two_gib - 16)));
    EXPECT_FALSE(Bindings::table_fits(d, shared::BIND_NODES, elements * 16 + 1));
    EXPECT_FALSE(Bindings::table_fits(d, shared::BIND_NODES, two_gib));
    EXPECT_FALSE(Bindings::table_fits(d, shared::BIND_TEXELS, elements * 4 + 1));
}

} // namespace
} // namespace ajar::gpu
