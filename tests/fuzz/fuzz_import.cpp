// libFuzzer's entry: any bytes are read as glTF or refused with an Error; whatever else happens is a finding.
#include "base/error.hpp"
#include "import/import.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ajar::ImportOptions options;
    options.limits.decoded_slack_bytes = std::uint64_t{4} << 20; // to stay fast
    try {
        ajar::import_gltf_memory(std::as_bytes(std::span(data, size)), {}, options);
    } catch (const ajar::Error&) {}
    return 0;
}
