#include "ajar/save_image.hpp"

#include "image/tonemap.hpp"
#include "image/write.hpp"

namespace ajar {

void save_image(const std::filesystem::path& path, const Image& image, const SaveOptions& options) {
    WriteOptions write;
    write.exr_floats = options.full_floats ? ExrFloats::full : ExrFloats::half;
    write.tonemap.op = &find_tonemap(options.tonemap);
    write.tonemap.exposure = options.exposure;
    write_image(path, image, write);
}

void check_save(const std::filesystem::path& path, const SaveOptions& options) {
    check_output_name(path);
    find_tonemap(options.tonemap);
}

} // namespace ajar
