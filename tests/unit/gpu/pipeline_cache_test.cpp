// The cache of compiled pipelines: it survives whatever happened to its file.
#include "gpu/pipeline_cache.hpp"

#include "base/file.hpp"
#include "gpu_test.hpp"

#include <cstring>

namespace ajar::gpu {
namespace {

namespace fs = std::filesystem;

class GpuPipelineCache : public GpuTest {
  protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) /
                 (std::string("ajar-") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder);
    }
    void TearDown() override {
        GpuTest::TearDown();
        fs::remove_all(folder);
    }

    static CacheKey key() {
        CacheKey key{0x10005, 7, 22, {}};
        for (std::uint8_t i = 0; i < 16; ++i) key.uuid[i] = static_cast<std::uint8_t>(i * 3);
        return key;
    }
    // What a driver of that key would give: its header, then something of its own.
    static std::vector<std::byte> data(const CacheKey& key) {
        std::vector<std::byte> bytes(100, std::byte(42));
        const std::uint32_t words[] = {32, 1, key.vendor, key.device};
        std::memcpy(bytes.data(), words, 16);
        std::memcpy(bytes.data() + 16, key.uuid, 16);
        return bytes;
    }

    fs::path folder;
};

TEST_F(GpuPipelineCache, LoadsWhatWasStored) {
    EXPECT_TRUE(load_cache(folder, key()).empty());
    store_cache(folder, key(), data(key()));
    EXPECT_EQ(load_cache(folder, key()), data(key()));
}

TEST_F(GpuPipelineCache, IgnoresAnotherDriversData) {
    store_cache(folder, key(), data(key()));
    for (int field = 0; field < 4; ++field) {
        CacheKey other = key();
        if (field == 0) ++other.vendor;
        if (field == 1) ++other.device;
        if (field == 2) ++other.driver_version;
        if (field == 3) ++other.uuid[15];
        EXPECT_TRUE(load_cache(folder, other).empty());
        if (field == 2) continue; // the header knows nothing of it, the file's name does
        fs::copy_file(cache_file(folder, key()), cache_file(folder, other));
        EXPECT_TRUE(load_cache(folder, other).empty());
    }
}

TEST_F(GpuPipelineCache, IgnoresDamagedFilesOfAnyLength) {
    store_cache(folder, key(), data(key()));
    const fs::path file = cache_file(folder, key());
    const auto whole = read_file(file);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        write_file(file, std::span(whole).first(length));
        EXPECT_TRUE(load_cache(folder, key()).empty()) << length;
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        auto bad = whole;
        bad[i] ^= std::byte(1);
        write_file(file, bad);
        EXPECT_TRUE(load_cache(folder, key()).empty()) << i;
    }
}

TEST_F(GpuPipelineCache, SurvivesFoldersThatCantBe) {
    fs::create_directories(folder);
    write_file(folder / "file", "in the way");
    store_cache(folder / "file" / "below", key(), data(key()));
    EXPECT_TRUE(load_cache(folder / "file" / "below", key()).empty());
    fs::create_directories(cache_file(folder, key()));
    store_cache(folder, key(), data(key()));
    EXPECT_TRUE(load_cache(folder, key()).empty());
}

TEST_F(GpuPipelineCache, IsStoredByTheDeviceAndReplacedWhenDamaged) {
    const TestArgs args{8, 1, 0};
    run_words(device({.cache_folder = folder}), "fill", args, {}, 8);
    device(); // the first one is gone and has stored
    ASSERT_TRUE(fs::exists(folder));
    const auto entry = *fs::directory_iterator(folder);
    write_file(entry.path(), "damaged");
    EXPECT_EQ(run_words(device({.cache_folder = folder}), "fill", args, {}, 8).back(), 7u);
    device();
    EXPECT_GT(fs::file_size(entry.path()), 32u);
}

TEST_F(GpuPipelineCache, IsNotNeededByTheDevice) {
    fs::create_directories(folder);
    write_file(folder / "file", "in the way");
    const TestArgs args{8, 1, 0};
    EXPECT_EQ(run_words(device({.cache_folder = folder / "file"}), "fill", args, {}, 8).back(), 7u);
}

TEST(GpuCacheFolder, FollowsTheXdgSpecification) {
    EXPECT_EQ(default_cache_folder("/x", "/home/a"), "/x/ajar");
    EXPECT_EQ(default_cache_folder(nullptr, "/home/a"), "/home/a/.cache/ajar");
    EXPECT_EQ(default_cache_folder("", "/home/a"), "/home/a/.cache/ajar");
    EXPECT_EQ(default_cache_folder("relative", "/home/a"), "/home/a/.cache/ajar");
    EXPECT_EQ(default_cache_folder(nullptr, nullptr), "");
}

} // namespace
} // namespace ajar::gpu
