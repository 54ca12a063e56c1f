// Compiled pipelines on disk, one file per driver. Every failure means "no cache", never an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ajar::gpu {

// What makes a cache usable by one driver and no other.
struct CacheKey {
    std::uint32_t vendor = 0;
    std::uint32_t device = 0;
    std::uint32_t driver_version = 0;
    std::uint8_t uuid[16] = {};
};

std::filesystem::path cache_file(const std::filesystem::path& folder, const CacheKey& key);

// The driver's data as it was stored; empty when there is none, it is damaged, or it is another driver's.
std::vector<std::byte> load_cache(const std::filesystem::path& folder, const CacheKey& key);

// Stores it, creating the folder. Does nothing where that is impossible.
void store_cache(const std::filesystem::path& folder, const CacheKey& key,
                 std::span<const std::byte> data) noexcept;

} // namespace ajar::gpu
