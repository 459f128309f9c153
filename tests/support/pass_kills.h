// Runs that are killed in the middle of what comes before the picture. Any thread.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "tests/support/render.h"
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

/// `a.pov` in the folder: a run that is killed twenty times and gone on with has the bits of a whole one.
inline void expect_bits_after_kills(const std::string& width, const std::string& height,
                                    const std::filesystem::path& folder) {
  const auto command = [&](std::vector<std::string> more) {
    more.insert(more.begin(),
                {program("lentray").string(), "+Ia.pov", "-V", "-A", "+W" + width, "+H" + height});
    return more;
  };
  ASSERT_EQ(tool::run_program(command({"+Owhole.png", "+WT2"}), folder).status, 0);
  for (int run = 0; run < 20; ++run) {
    ASSERT_TRUE(kill_in_the_middle(command({"+Oa.png", "+C", "+WT1"}), folder))
        << "run " << run << " was over too soon";
  }
  ASSERT_EQ(tool::run_program(command({"+Oa.png", "+C", "+WT2"}), folder).status, 0);
  EXPECT_TRUE(
      same_bits(core::read_image(folder / "a.png"), core::read_image(folder / "whole.png")));
}

}  // namespace lentray::test
