#include "tools/common/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/base/ignored_error.h"
#include "core/image/file_swap.h"
#include "core/image/writer.h"
#include "core/image/written_bytes.h"

namespace lentray::tool {

namespace fs = std::filesystem;

namespace {

/// Reads until the other end closes; false when the time is over.
bool read_all(int from, double seconds, std::string& into) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  char buffer[4096];
  for (;;) {
    int wait_ms = -1;
    if (seconds > 0.0) {
      const double left = seconds - std::chrono::duration<double>(Clock::now() - start).count();
      if (left <= 0.0) return false;
      wait_ms = static_cast<int>(left * 1000.0) + 1;
    }
    pollfd ready{from, POLLIN, 0};
    const int count = ::poll(&ready, 1, wait_ms);
    if (count == 0) return false;
    if (count < 0 && errno == EINTR) continue;
    const ssize_t got = ::read(from, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    into.append(buffer, static_cast<std::size_t>(got));
  }
}

}  // namespace

pid_t start_program(const std::vector<std::string>& command, const fs::path& folder, int output,
                    const std::function<void()>& first) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process != 0) return process;
  // Async-signal-safe calls, but for what `first` does.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);       // it must not outlive whoever waits for it,
  if (::getppid() != parent) ::_exit(127);  // nor stay if that one ended before the call
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  if (first) first();
  if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

int exit_status(int said) { return WIFSIGNALED(said) ? 128 + WTERMSIG(said) : WEXITSTATUS(said); }

int end_of(pid_t process) {
  int said = 0;
  while (::waitpid(process, &said, 0) < 0 && errno == EINTR) {
  }
  return exit_status(said);
}

RunResult run_program(const std::vector<std::string>& command, const fs::path& folder,
                      double seconds) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    throw std::runtime_error(std::string("cannot make a pipe: ") + std::strerror(errno));
  }
  const pid_t child = start_program(command, folder, ends[1]);
  const int error = errno;
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    throw std::runtime_error("cannot start '" + command[0] + "': " + std::strerror(error));
  }
  RunResult result;
  result.timed_out = !read_all(ends[0], seconds, result.output);
  if (result.timed_out) ::kill(child, SIGKILL);
  ::close(ends[0]);
  result.status = end_of(child);
  if ((result.status == 126 || result.status == 127) && result.output.empty()) {
    throw std::runtime_error("cannot start '" + command[0] + "': is it installed?");
  }
  return result;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "lentray-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("cannot make a folder like " + pattern + ": " + std::strerror(errno));
  }
  m_path = pattern;
}

TemporaryFolder::~TemporaryFolder() { fs::remove_all(m_path, core::ignored_error()); }

std::string file_bytes(const fs::path& path) {
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (file) bytes << file.rdbuf();
  return std::move(bytes).str();
}

std::string read_text(const fs::path& path) {
  if (::access(path.c_str(), R_OK) != 0 || fs::is_directory(path)) {
    throw std::runtime_error("cannot read '" + path.string() + "'");
  }
  return file_bytes(path);
}

void write_text(const fs::path& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) {
    const std::string why = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    throw std::runtime_error("cannot write '" + path.string() + "'" + why);
  }
}

void write_whole(const fs::path& place, const std::string& bytes) {
  core::FileSwap swap(place);
  if (const std::string why = core::count_written(bytes.size()); !why.empty())
    throw core::ImageError("cannot write " + core::shown_place(place) + ": " + why);
  std::ofstream file(swap.temporary(), std::ios::binary);
  file << bytes;
  file.close();
  if (!file)
    throw core::ImageError("cannot write '" + place.string() + "': " + std::strerror(errno));
  swap.commit();
}

}  // namespace lentray::tool
