// A file is 32 hexadecimal digits, the content hash of the rest, then what the driver gave us: drivers check
// the header of their data (Vulkan 1.2, "Pipeline Cache Header"), hardly ever the rest.
#include "gpu/pipeline_cache.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "gpu/device.hpp"

#include <fmt/format.h>

#include <cstring>

namespace ajar::gpu {
namespace {

constexpr std::size_t HASH_DIGITS = 32;
constexpr std::uintmax_t MAX_FILE_BYTES = UINTMAX_C(1) << 28;

// VkPipelineCacheHeaderVersionOne.
struct DriverHeader {
    std::uint32_t header_bytes;
    std::uint32_t version;
    std::uint32_t vendor;
    std::uint32_t device;
    std::uint8_t uuid[16];
};
static_assert(sizeof(DriverHeader) == 32);

bool belongs_to(std::span<const std::byte> data, const CacheKey& key) {
    DriverHeader header;
    if (data.size() < sizeof(header)) return false;
    std::memcpy(&header, data.data(), sizeof(header));
    return header.header_bytes >= sizeof(header) && header.version == 1 && header.vendor == key.vendor &&
           header.device == key.device && std::memcmp(header.uuid, key.uuid, sizeof(key.uuid)) == 0;
}

} // namespace

std::filesystem::path default_cache_folder(const char* xdg_cache_home, const char* home) {
    // The XDG base directory specification: relative paths are to be ignored.
    if (xdg_cache_home != nullptr && std::filesystem::path(xdg_cache_home).is_absolute()) {
        return std::filesystem::path(xdg_cache_home) / "ajar";
    }
    if (home != nullptr && std::filesystem::path(home).is_absolute()) {
        return std::filesystem::path(home) / ".cache" / "ajar";
    }
    return {};
}

std::filesystem::path cache_file(const std::filesystem::path& folder, const CacheKey& key) {
    std::string uuid;
    for (const std::uint8_t byte : key.uuid) uuid += fmt::format("{:02x}", byte);
    return folder /
           fmt::format("pipelines-{:x}-{:x}-{:x}-{}.bin", key.vendor, key.device, key.driver_version, uuid);
}

std::vector<std::byte> load_cache(const std::filesystem::path& folder, const CacheKey& key) {
    if (folder.empty()) return {};
    std::vector<std::byte> file;
    try {
        const auto path = cache_file(folder, key);
        if (std::error_code ignored; !std::filesystem::is_regular_file(path, ignored)) return {};
        file = read_file(path, MAX_FILE_BYTES);
    } catch (const std::exception&) {
        return {};
    }
    if (file.size() < HASH_DIGITS) return {};
    const std::span<const std::byte> data = std::span(file).subspan(HASH_DIGITS);
    const std::string hash = content_hash(data);
    if (std::memcmp(hash.data(), file.data(), HASH_DIGITS) != 0 || !belongs_to(data, key)) return {};
    return {data.begin(), data.end()};
}

void store_cache(const std::filesystem::path& folder, const CacheKey& key,
                 std::span<const std::byte> data) noexcept {
    if (folder.empty() || data.empty()) return;
    try {
        std::filesystem::create_directories(folder);
        const std::string hash = content_hash(data);
        const auto digits = std::as_bytes(std::span(hash));
        std::vector<std::byte> file(digits.begin(), digits.end());
        file.insert(file.end(), data.begin(), data.end());
        write_file(cache_file(folder, key), file);
    } catch (const std::exception&) { // a read-only home is no reason to fail
    }
}

} // namespace ajar::gpu
