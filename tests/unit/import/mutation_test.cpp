// A short, repeatable run of what tests/fuzz does for hours: damaged files are read or refused with an Error.
#include "base/error.hpp"
#include "unit/import/seeds.hpp"

#include <gtest/gtest.h>
#include <random>

namespace ajar::test {
namespace {

class Mutator {
  public:
    explicit Mutator(std::uint32_t seed) : random_(seed) {}

    std::size_t below(std::size_t n) { return random_() % n; }

    // Replaces, removes or repeats one value somewhere in the document.
    void change(nlohmann::json& document) {
        std::vector<nlohmann::json*> containers;
        collect(document, containers);
        nlohmann::json& container = *containers[below(containers.size())];
        if (container.empty()) {
            container = strange_value();
            return;
        }
        auto victim = container.begin();
        std::advance(victim, below(container.size()));
        const std::size_t choice = below(8);
        if (choice == 0)
            container.erase(victim);
        else if (choice == 1 && container.is_array())
            container.push_back(nlohmann::json(*victim));
        else if (choice == 2)
            *victim = nlohmann::json(*containers[below(containers.size())]);
        else if (choice <= 4 && victim->is_number())
            *victim = victim->get<double>() + (choice == 3 ? 1 : -1);
        else
            *victim = strange_value();
    }

    void change(std::vector<std::byte>& bytes) {
        for (std::size_t i = 0; i <= below(4); ++i)
            bytes[below(bytes.size())] = static_cast<std::byte>(below(256));
        if (below(20) == 0) bytes.resize(below(bytes.size()) + 1);
    }

  private:
    static void collect(nlohmann::json& value, std::vector<nlohmann::json*>& containers) {
        if (!value.is_structured()) return;
        containers.push_back(&value);
        for (nlohmann::json& child : value) collect(child, containers);
    }

    nlohmann::json strange_value() {
        static const nlohmann::json values[] = {nullptr,
                                                true,
                                                "",
                                                "text",
                                                nlohmann::json::array(),
                                                nlohmann::json::object(),
                                                0,
                                                1,
                                                3,
                                                -1,
                                                0.5,
                                                255,
                                                65535,
                                                1 << 20,
                                                0x7fffffff,
                                                0xffffffffu,
                                                std::int64_t{1} << 40,
                                                INT64_MAX,
                                                INT64_MIN,
                                                UINT64_MAX,
                                                1e30,
                                                -1e30,
                                                1e300,
                                                1e-45,
                                                5120,
                                                5121,
                                                5125,
                                                5126,
                                                "data:,",
                                                "../x",
                                                {0},
                                                {1, 2, 3},
                                                {{"index", 0}}};
        return values[below(std::size(values))];
    }

    std::mt19937 random_;
};

ImportOptions small_limits() {
    ImportOptions options;
    options.limits.decoded_slack_bytes = std::uint64_t{4} << 20;
    return options;
}

// Returns whether the file was read.
bool survives(std::span<const std::byte> bytes) {
    try {
        import_gltf_memory(bytes, {}, small_limits());
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
        return false;
    }
}

TEST(Mutation, TheSeedsAreValid) {
    for (const Seed& seed : seeds()) EXPECT_EQ(import_error(seed.builder), "") << seed.name;
}

TEST(Mutation, OfJsonValuesIsReadOrRefused) {
    Mutator mutator(1);
    std::size_t read = 0, refused = 0;
    for (const Seed& seed : seeds())
        for (int i = 0; i < 10000; ++i) {
            GltfBuilder b = seed.builder;
            for (std::size_t k = 0; k <= mutator.below(3); ++k) mutator.change(b.json);
            ++(survives(b.glb()) ? read : refused);
        }
    // Neither harmless nor hopeless: else the mutations would try nothing.
    EXPECT_GT(read, 500u);
    EXPECT_GT(refused, 500u);
}

TEST(Mutation, OfBinaryDataIsReadOrRefused) {
    Mutator mutator(2);
    for (const Seed& seed : seeds())
        for (int i = 0; i < 1000; ++i) {
            GltfBuilder b = seed.builder;
            mutator.change(b.bin);
            survives(b.glb());
        }
}

TEST(Mutation, OfAnyByteIsReadOrRefused) {
    Mutator mutator(3);
    for (const Seed& seed : seeds()) {
        const std::vector<std::byte> whole = seed.builder.glb();
        for (int i = 0; i < 1000; ++i) {
            std::vector<std::byte> bytes = whole;
            mutator.change(bytes);
            survives(bytes);
        }
    }
}

} // namespace
} // namespace ajar::test
