#include "base/file.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

namespace ajar {

namespace fs = std::filesystem;

std::vector<std::byte> read_file(const fs::path& path, std::uintmax_t max_bytes) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status)) throw Error(fmt::format("{}: no such file", path.string()));
    if (fs::is_directory(status)) throw Error(fmt::format("{}: is a folder, not a file", path.string()));
    if (!fs::is_regular_file(status)) throw Error(fmt::format("{}: is not a regular file", path.string()));
    const std::uintmax_t size = fs::file_size(path, code);
    if (code) throw Error(fmt::format("{}: {}", path.string(), code.message()));
    if (size > max_bytes)
        throw Error(fmt::format("{}: has {} bytes, the limit here is {}", path.string(), size, max_bytes));
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(fmt::format("{}: cannot be opened: {}", path.string(), std::strerror(errno)));
    std::vector<std::byte> bytes(size);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(file.gcount()) != size)
        throw Error(fmt::format("{}: ended after {} of {} bytes", path.string(), file.gcount(), size));
    return bytes;
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
    PendingFile pending(path);
    {
        std::ofstream file(pending.temporary(), std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file) throw Error(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
    }
    pending.commit();
}

void write_file(const fs::path& path, std::string_view text) {
    write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

PendingFile::PendingFile(fs::path path) : path_(std::move(path)) {
    std::error_code code;
    const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, code))
        throw Error(fmt::format("{}: the folder {} does not exist", path_.string(), folder.string()));
    if (fs::is_directory(path_, code))
        throw Error(fmt::format("{}: is a folder, not a file", path_.string()));
    if (::access(folder.c_str(), W_OK) != 0)
        throw Error(fmt::format("{}: the folder {} is not writable", path_.string(), folder.string()));
    temporary_ = folder / fmt::format(".{}.{}.partial{}", path_.stem().string(), ::getpid(),
                                      path_.extension().string());
}

PendingFile::~PendingFile() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void PendingFile::commit() {
    std::error_code code;
    fs::rename(temporary_, path_, code);
    if (code) throw Error(fmt::format("{}: cannot be replaced: {}", path_.string(), code.message()));
    temporary_.clear();
}

} // namespace ajar
