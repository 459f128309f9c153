// Other programs: run one, wait, keep what it says. POSIX.
// Errors: std::runtime_error if the program cannot be started. Threads: any number.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lentray::tool {

struct RunResult {
  int status = 0;  ///< exit status; 128 + n when ended by signal n
  bool timed_out = false;
  std::string output;  ///< standard output and error, in the order they came
};

/// `command[0]` is looked for along PATH. The current folder of the child is `folder`
/// (empty: ours). seconds 0: no limit.
RunResult run_program(const std::vector<std::string>& command,
                      const std::filesystem::path& folder = {}, double seconds = 0.0);

/// In a child, after fork: it does not outlive its parent. Async-signal-safe.
void end_with(pid_t parent);

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

/// Whole text files. std::runtime_error if that fails.
std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);
/// The file appears whole or not at all; what stood there before stays until then. core::ImageError.
void write_whole(const std::filesystem::path& place, const std::string& bytes);

}  // namespace lentray::tool
