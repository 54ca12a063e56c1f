// Whole files in and out. An output is written beside its name and renamed: no failure leaves half a file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

// The bytes of a regular file. Throws Error when it is missing, a folder, unreadable or beyond max_bytes.
std::vector<std::byte> read_file(const std::filesystem::path& path,
                                 std::uintmax_t max_bytes = UINTMAX_C(1) << 36);

// Replaces `path` by `bytes` in one step (rename(2)). Throws Error; the old file is then untouched.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

// A temporary name in the folder of `path`, for writers that need a file name; commit() renames it to `path`,
// the destructor removes it when commit() was not reached. Keeps the extension, which image writers look at.
class PendingFile {
  public:
    explicit PendingFile(std::filesystem::path path);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;
    const std::filesystem::path& temporary() const { return temporary_; }
    void commit();

  private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

} // namespace ajar
