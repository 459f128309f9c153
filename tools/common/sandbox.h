// The system's own bounds for a process, beneath whatever rules it keeps itself: Landlock for files, and a filter of
// system calls (seccomp). They hold for the calling thread and all that it starts later, and cannot be taken back.
// Linux. Errors: none thrown. To be called while the process has one thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lentray::tool {

/// Files, and folders with all below. What is not there is passed over.
struct SandboxPlaces {
  std::vector<std::filesystem::path> reads;
  std::vector<std::filesystem::path>
      writes;  ///< also read; files are made, renamed and removed there
};

/// Files elsewhere are no longer opened, made, renamed or removed. What the system lacks; empty: it holds.
std::string bound_files(const SandboxPlaces& places);

/// No programs are run, no sockets made, no other processes looked into, no modes and owners changed. What the system
/// lacks; empty: it holds.
std::string bound_calls();

}  // namespace lentray::tool
