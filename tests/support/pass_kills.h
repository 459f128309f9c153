// Runs that are killed in the middle of what comes before the picture. Any thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "tools/common/child.h"

namespace lentray::test {

/// Kills a run that writes `a.png` as soon as it has kept more of its passes. False: it came to its
/// end.
inline bool kill_in_the_middle(const std::vector<std::string>& command,
                               const std::filesystem::path& folder) {
  const std::filesystem::path part = folder / "a.png.lentray-passes.part";
  const auto size = [&] {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(part, error);
    return error ? 0 : bytes;
  };
  const std::uintmax_t before = size();
  tool::Launch launch;
  launch.command = command;
  launch.folder = folder;
  launch.log = folder / "log";
  tool::Child child(launch);
  while (size() <= before) {
    if (child.ended()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  child.kill();
  while (!child.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return true;
}

}  // namespace lentray::test
