#include "cli/run_ajar.hpp"

#include <array>
#include <csignal>
#include <fstream>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ajar::test {

namespace {

[[noreturn]] void become(const std::vector<std::string>& command, const Surroundings& surroundings) {
    std::signal(SIGINT, SIG_DFL); // a shell that runs the tests in the background has made us ignore it
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    for (const auto& [name, value] : surroundings.environment) setenv(name.c_str(), value.c_str(), 1);
    if (!surroundings.folder.empty() && chdir(surroundings.folder.c_str()) != 0) _exit(127);
    if (surroundings.max_file_bytes != 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{surroundings.max_file_bytes, surroundings.max_file_bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

} // namespace

Process::Process(const std::vector<std::string>& command, const Surroundings& surroundings) {
    std::array<int, 2> out{}, err{};
    if (pipe(out.data()) != 0 || pipe(err.data()) != 0) throw std::runtime_error("no pipe");
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no process");
    if (pid_ == 0) {
        dup2(out[1], STDOUT_FILENO);
        dup2(err[1], STDERR_FILENO);
        for (const int end : {out[0], out[1], err[0], err[1]}) close(end);
        become(command, surroundings);
    }
    close(out[1]);
    close(err[1]);
    out_ = out[0];
    err_ = err[0];
}

Process::~Process() {
    if (pid_ > 0) {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    close(out_);
    close(err_);
}

std::string Process::read_line() {
    std::size_t end = 0;
    while ((end = pending_.find('\n')) == std::string::npos) {
        std::array<char, 4096> buffer{};
        const ssize_t count = read(out_, buffer.data(), buffer.size());
        if (count <= 0) return {};
        pending_.append(buffer.data(), static_cast<std::size_t>(count));
    }
    std::string line = pending_.substr(0, end);
    pending_.erase(0, end + 1);
    return line;
}

void Process::send(int signal) const { kill(pid_, signal); }

Result Process::finish() {
    Result result;
    result.out = std::move(pending_);
    std::array<pollfd, 2> ends{pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
    const std::array<std::string*, 2> texts{&result.out, &result.err};
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        poll(ends.data(), ends.size(), -1);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (ends[i].fd < 0 || ends[i].revents == 0) continue;
            std::array<char, 4096> buffer{};
            const ssize_t count = read(ends[i].fd, buffer.data(), buffer.size());
            if (count > 0)
                texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
            else
                ends[i].fd = -1;
        }
    }
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

Result run(const std::vector<std::string>& command, const Surroundings& surroundings) {
    return Process(command, surroundings).finish();
}

std::vector<std::string> ajar_command(const std::vector<std::string>& arguments) {
    std::vector<std::string> command{AJAR_COMMAND};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return command;
}

Result run_ajar(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    return run(ajar_command(arguments), surroundings);
}

std::string scene_path(const std::string& name) {
    return std::string(AJAR_SOURCE_DIR) + "/scenes/" + name + "/" + name + ".gltf";
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("no file " + file.string());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::vector<std::string> lines(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> result;
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

} // namespace ajar::test
