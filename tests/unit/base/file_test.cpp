// Reading and replacing whole files: errors are one line, and an old file survives every failure.
#include "base/error.hpp"
#include "base/file.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace ajar {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::string text_of(const fs::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

std::size_t entries_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// The message of the Error that `action` throws; empty when it throws none.
template <class Action> std::string error_of(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

void expect_one_line_naming(const std::string& message, const fs::path& path) {
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(File, ReadsBackWhatWasWritten) {
    const TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 1000; ++i) text.push_back(static_cast<char>(i * 37));
    write_file(folder / "all bytes.bin", text);
    EXPECT_EQ(text_of(folder / "all bytes.bin"), text);
    write_file(folder / "empty", std::string_view());
    EXPECT_EQ(text_of(folder / "empty"), "");
}

TEST(File, WritingLeavesNothingBesideTheFile) {
    const TemporaryFolder folder;
    write_file(folder / "a.txt", "one");
    write_file(folder / "a.txt", "two");
    EXPECT_EQ(text_of(folder / "a.txt"), "two");
    EXPECT_EQ(entries_in(folder.path()), 1u);
}

TEST(File, RefusesAFolderAsAFile) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "inner");
    expect_one_line_naming(error_of([&] { read_file(folder / "inner"); }), folder / "inner");
    expect_one_line_naming(error_of([&] { write_file(folder / "inner", "x"); }), folder / "inner");
    EXPECT_TRUE(fs::is_directory(folder / "inner"));
    EXPECT_EQ(entries_in(folder.path()), 1u);
}

TEST(File, SaysWhichFileIsMissing) {
    const TemporaryFolder folder;
    expect_one_line_naming(error_of([&] { read_file(folder / "none.glb"); }), folder / "none.glb");
    expect_one_line_naming(error_of([&] { read_file(folder / "no" / "where" / "x"); }),
                           folder / "no" / "where" / "x");
}

TEST(File, RefusesWhatIsNeitherFileNorFolder) {
    // Reading a pipe would wait for ever.
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    expect_one_line_naming(error_of([&] { read_file(folder / "pipe"); }), folder / "pipe");
    expect_one_line_naming(error_of([&] { read_file("/dev/zero"); }), "/dev/zero");
}

TEST(File, RefusesAFileBeyondTheLimit) {
    const TemporaryFolder folder;
    write_file(folder / "ten", "0123456789");
    EXPECT_EQ(read_file(folder / "ten", 10).size(), 10u);
    expect_one_line_naming(error_of([&] { read_file(folder / "ten", 9); }), folder / "ten");
}

TEST(File, RefusesToWriteIntoAMissingFolder) {
    const TemporaryFolder folder;
    expect_one_line_naming(error_of([&] { write_file(folder / "no" / "x", "x"); }), folder / "no" / "x");
    EXPECT_FALSE(fs::exists(folder / "no"));
}

TEST(File, RefusesToWriteIntoAFolderWithoutPermission) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    const TemporaryFolder folder;
    fs::create_directory(folder / "locked");
    write_file(folder / "locked" / "old", "old");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    expect_one_line_naming(error_of([&] { write_file(folder / "locked" / "old", "new"); }),
                           folder / "locked" / "old");
    fs::permissions(folder / "locked", fs::perms::owner_all);
    EXPECT_EQ(text_of(folder / "locked" / "old"), "old");
}

TEST(File, RefusesToWriteWhereNoFileCanBe) {
    // Not even root can make a file there.
    if (!fs::is_directory("/proc/self")) GTEST_SKIP() << "no /proc here";
    expect_one_line_naming(error_of([] { write_file("/proc/image.exr", "x"); }), "/proc/image.exr");
}

TEST(File, KeepsTheOldFileWhenTheDiskIsFull) {
    // /dev/full takes bytes and fails when they are flushed; a link to it stands for the temporary file.
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const TemporaryFolder folder;
    write_file(folder / "kept.txt", "old");
    PendingFile probe(folder / "kept.txt");
    fs::create_symlink("/dev/full", probe.temporary());
    expect_one_line_naming(error_of([&] { write_file(folder / "kept.txt", std::string(1 << 20, 'x')); }),
                           folder / "kept.txt");
    EXPECT_EQ(text_of(folder / "kept.txt"), "old");
}

TEST(PendingFile, RemovesWhatWasNotCommitted) {
    const TemporaryFolder folder;
    write_file(folder / "image.exr", "old");
    fs::path temporary;
    {
        const PendingFile pending(folder / "image.exr");
        temporary = pending.temporary();
        std::ofstream(temporary) << "half an ima";
        EXPECT_TRUE(fs::exists(temporary));
    }
    EXPECT_FALSE(fs::exists(temporary));
    EXPECT_EQ(text_of(folder / "image.exr"), "old");
    EXPECT_EQ(entries_in(folder.path()), 1u);
}

TEST(PendingFile, KeepsFolderAndExtension) {
    const TemporaryFolder folder;
    const PendingFile pending(folder / "image.v2.exr");
    EXPECT_EQ(pending.temporary().parent_path(), folder.path());
    EXPECT_EQ(pending.temporary().extension(), ".exr");
    EXPECT_NE(pending.temporary(), folder / "image.v2.exr");
}

TEST(PendingFile, ReplacesOnCommit) {
    const TemporaryFolder folder;
    write_file(folder / "image.png", "old");
    PendingFile pending(folder / "image.png");
    std::ofstream(pending.temporary()) << "new";
    EXPECT_EQ(text_of(folder / "image.png"), "old");
    pending.commit();
    EXPECT_EQ(text_of(folder / "image.png"), "new");
    EXPECT_EQ(entries_in(folder.path()), 1u);
}

TEST(PendingFile, SaysSoWhenThereIsNothingToCommit) {
    const TemporaryFolder folder;
    PendingFile pending(folder / "image.png");
    expect_one_line_naming(error_of([&] { pending.commit(); }), folder / "image.png");
}

} // namespace
} // namespace ajar
