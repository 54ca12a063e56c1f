// Runs the built `ajar`, or any program, as a user would: arguments in, exit code and both outputs back.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace ajar::test {

struct Result {
    int exit_code = -1; // 128 + signal when a signal ended it
    std::string out;
    std::string err;
};

struct Surroundings {
    std::map<std::string, std::string> environment; // on top of the test's own
    std::filesystem::path folder;                   // empty: the test's own
    std::uintmax_t max_file_bytes = 0; // 0: no limit. A longer file fails to be written, as on a full disk
};

// A program that runs while the test goes on.
class Process {
  public:
    explicit Process(const std::vector<std::string>& command, const Surroundings& surroundings = {});
    ~Process(); // kills it when finish() was not reached
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // The next line of its stdout, without the newline; empty at the end.
    std::string read_line();
    void send(int signal) const;
    // The rest of both outputs and the exit code.
    Result finish();

  private:
    pid_t pid_ = -1;
    int out_ = -1;
    int err_ = -1;
    std::string pending_;
};

Result run(const std::vector<std::string>& command, const Surroundings& surroundings = {});
// `ajar ARGUMENTS...`, without a pipeline cache of its own in the user's home.
Result run_ajar(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

std::vector<std::string> ajar_command(const std::vector<std::string>& arguments);
std::string scene_path(const std::string& name); // scenes/NAME/NAME.gltf
std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);
std::vector<std::string> lines(const std::string& text);

} // namespace ajar::test
