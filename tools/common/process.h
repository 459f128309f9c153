// Other programs: run one, wait, keep what it says. POSIX.
// Errors: std::runtime_error if the program cannot be started. Threads: any number.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace lentray::tool {

/// The process that becomes the program: `command[0]` is looked for along PATH, `folder` (empty: ours) is its current
/// one, it reads nothing and writes to `output`, and ends with this thread. In it, `first` runs before. -1, with errno:
/// there is none. Its status is 126 where the folder cannot be entered, 127 where there is no such program.
pid_t start_program(const std::vector<std::string>& command, const std::filesystem::path& folder,
                    int output, const std::function<void()>& first = {});
/// Exit status of what waitpid() says; 128 + n when ended by signal n.
int exit_status(int said);
/// Waits for its end.
int end_of(pid_t process);

struct RunResult {
  int status = 0;  ///< as exit_status() has it
  bool timed_out = false;
  std::string output;  ///< standard output and error, in the order they came
};

/// `command[0]` is looked for along PATH. The current folder of the child is `folder`
/// (empty: ours). seconds 0: no limit.
RunResult run_program(const std::vector<std::string>& command,
                      const std::filesystem::path& folder = {}, double seconds = 0.0);

/// A new empty folder that goes away, with all it holds, with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return m_path; }
  std::filesystem::path operator/(const std::string& name) const { return m_path / name; }

 private:
  std::filesystem::path m_path;
};

/// What there is of a file; empty where it cannot be read.
std::string file_bytes(const std::filesystem::path& path);
/// Whole text files. std::runtime_error if that fails.
std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);
/// The file appears whole or not at all; what stood there before stays until then. core::ImageError.
void write_whole(const std::filesystem::path& place, const std::string& bytes);

}  // namespace lentray::tool
