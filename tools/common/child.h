// A program that runs beside this one: started, looked after, ended. What it says goes into a file. It ends with this
// process, however that ends. Linux.
// Errors: std::runtime_error if it cannot be started. One thread, which must stay: children end with it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parser/files/opened_file.h"

namespace lentray::tool {

struct Launch {
  std::vector<std::string> command;  ///< command[0] is looked for along PATH
  std::filesystem::path folder;      ///< the current folder there
  std::shared_ptr<const parser::Descriptor>
      held;                   ///< what `folder` is the handle of, where it is one
  std::filesystem::path log;  ///< standard output and error, from the beginning of the file
  std::function<int()> work;  ///< instead of a command: its exit status
  double cpu_limit =
      0.0;  ///< seconds of processor time after which it is ended by SIGXCPU, rounded up; 0: none
};

struct Ended {
  int status =
      0;  ///< exit status; 128 + n: ended by signal n; 126: the folder cannot be entered, 127: no such program
  double wall = 0.0, cpu = 0.0;  ///< seconds; cpu with all that it ran
  std::uint64_t memory = 0;      ///< bytes, the most that one of them held
};

class Child {
 public:
  explicit Child(const Launch& launch);
  ~Child();  ///< ends it at once if it runs
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void ask_to_stop() const;  ///< SIGTERM to all that it runs
  void kill() const;
  /// Once it has ended.
  std::optional<Ended> ended();
  double seconds() const;                ///< since its start
  std::uint64_t resident_bytes() const;  ///< of it and what it runs

 private:
  pid_t m_pid = -1;
  std::chrono::steady_clock::time_point m_start;
};

/// Blocks the signals that wait_for_news() waits for, in this thread. Children get them.
void hold_signals();
/// Waits for a child's end or a signal that asks to stop. The signal's number; 0: none of these.
int wait_for_news(std::chrono::milliseconds most);

}  // namespace lentray::tool
