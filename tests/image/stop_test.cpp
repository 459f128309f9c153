// What ends a run before its time: signals, a full disk, a reader that went away. A clear message,
// the right exit status, and the good picture that stood there survives.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using tool::TemporaryFolder;

/// Each pixel another grey: does not compress.
constexpr const char* kNoise =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    "camera { location <0,0,-3> look_at 0 }\n"
    "plane { z, 0 pigment { cells scale 0.0007 } "
    "finish { ambient 1 diffuse 0 } }\n";

/// Waits for what must come; false if it does not.
bool comes(const std::function<bool()>& it, double seconds = 60.0) {
  for (double waited = 0.0; waited < seconds; waited += 0.02) {
    if (it()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

/// lentray on its own, while the test goes on; its output goes to `log` of the folder.
class Running {
 public:
  Running(std::vector<std::string> arguments, const fs::path& folder, int ignored = 0) {
    arguments.insert(arguments.begin(), program("lentray").string());
    std::vector<char*> words;
    for (std::string& a : arguments) words.push_back(a.data());
    words.push_back(nullptr);
    const std::string in = folder.string(), log = (folder / "log").string();
    m_child = ::fork();
    if (m_child != 0) return;
    const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(out, STDERR_FILENO);
    ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
    // Which nohup, or a shell that runs the tests in the background, has them ignore.
    for (const int number : {SIGHUP, SIGINT, SIGTERM}) ::signal(number, SIG_DFL);
    if (ignored != 0) ::signal(ignored, SIG_IGN);
    if (::chdir(in.c_str()) == 0) ::execv(words[0], words.data());
    ::_exit(127);
  }
  ~Running() {
    if (m_child <= 0) return;
    ::kill(m_child, SIGKILL);
    (void)wait();
  }
  void signal(int number) const { ::kill(m_child, number); }
  /// Exit status, or 128 + the signal that ended it.
  int wait() {
    int status = 0;
    ::waitpid(m_child, &status, 0);
    m_child = 0;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }

 private:
  pid_t m_child = 0;
};

class ImageStop : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "noise.pov", kNoise); }

  /// Temporary files in the folder.
  std::vector<fs::path> parts() const {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(m_folder.path())) {
      const std::string name = entry.path().filename().string();
      if (name.find(".part") != std::string::npos) out.push_back(entry.path());
    }
    return out;
  }

  /// A picture that takes long, from when its file has been begun.
  std::vector<std::string> slow(const std::string& output) const {
    return {"noise.pov", "+W9000", "+H9000", "+WT2", "Band_Height=4", "-V", "+O" + output};
  }
  bool begun() const {
    return comes([&] { return !parts().empty() && fs::file_size(parts()[0]) > 0; });
  }

  tool::RunResult render(const std::string& output, const std::string& before = "",
                         const std::string& after = "") const {
    return tool::run_program({"/bin/sh", "-c",
                              before + " '" + program("lentray").string() +
                                  "' noise.pov +W300 +H200 -V +O" + output + " " + after},
                             m_folder.path());
  }

  std::string text(const std::string& name) const { return tool::read_text(m_folder / name); }

  TemporaryFolder m_folder;
};

class ImageStopSignal : public ImageStop,
                        public ::testing::WithParamInterface<std::pair<int, const char*>> {};

TEST_P(ImageStopSignal, LeavesTheOldPictureAndNothingElse) {
  const auto& [number, name] = GetParam();
  tool::write_text(m_folder / name, "an older picture");
  Running run(slow(name), m_folder.path());
  ASSERT_TRUE(begun());
  const auto then = std::chrono::steady_clock::now();
  run.signal(number);
  EXPECT_EQ(run.wait(), 2) << text("log");
  EXPECT_LT(std::chrono::steady_clock::now() - then, std::chrono::seconds(20));
  // A slow machine may have come to keep a journal by then, and says so before.
  EXPECT_TRUE(text("log").ends_with("lentray: stopped; the picture was not written\n"))
      << text("log");
  EXPECT_EQ(text(name), "an older picture");
  EXPECT_EQ(parts().size(), 0u);
}
INSTANTIATE_TEST_SUITE_P(Signals, ImageStopSignal,
                         ::testing::Values(std::pair{SIGINT, "a.png"}, std::pair{SIGINT, "a.tif"},
                                           std::pair{SIGINT, "a.exr"}, std::pair{SIGTERM, "a.png"},
                                           std::pair{SIGHUP, "a.png"}));

// A reading stops by itself: what it has read so far is still written down. The program is not
// ended from outside.
TEST_F(ImageStop, AReadingStopsInOrder) {
  tool::write_text(m_folder / "reads.pov", "#while (1) #end\n");
  Running run({"reads.pov", "-V", "-GA", "Dependencies_File=d.json"}, m_folder.path());
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  run.signal(SIGTERM);
  EXPECT_EQ(run.wait(), 2) << text("log");
  EXPECT_EQ(text("log"), "lentray: stopped; the picture was not written\n");
  EXPECT_NE(text("d.json").find("reads.pov"), std::string::npos);
}

// Building and a dear pixel are not asked whether they should stop; they are ended.
TEST_F(ImageStop, WhateverItIsAtTheRunEndsSoon) {
  tool::write_text(m_folder / "reads.pov", "#while (1) #end\n");
  tool::write_text(
      m_folder / "dear.pov",
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location -5*z look_at 0 }\n"
      "#for (I, 1, 8) light_source { <3, 5, -5>*I, 1 area_light x, y, 9000, 9000 } #end\n"
      "plane { y, -1 pigment { rgb 1 } } sphere { 0, 1 pigment { rgbt .5 } }\n");
  tool::write_text(m_folder / "builds.pov",
                   "#version 3.7; #include \"functions.inc\"\n"
                   "height_field { function 9900, 9900 { f_noise3d(x*50, y*50, 0) + "
                   "f_noise3d(x*99, y, 1) } pigment { rgb 1 } }\n");
  tool::write_text(m_folder / "a.png", "an older picture");
  for (const char* scene : {"reads.pov", "builds.pov", "dear.pov"}) {
    Running run({scene, "+W40", "+H30", "-V", "-GA", "+Oa.png"}, m_folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const auto then = std::chrono::steady_clock::now();
    run.signal(SIGTERM);
    EXPECT_EQ(run.wait(), 2) << scene << text("log");
    EXPECT_LT(std::chrono::steady_clock::now() - then, std::chrono::seconds(10)) << scene;
    EXPECT_NE(text("log").find("stopped; the picture was not written"), std::string::npos)
        << scene << text("log");
    EXPECT_EQ(text("a.png"), "an older picture");
    EXPECT_EQ(parts().size(), 0u) << scene;
  }
}

TEST_F(ImageStop, TheTimeEndsWhateverItIsAt) {
  tool::write_text(m_folder / "reads.pov", "#while (1) #end\n");
  tool::write_text(m_folder / "a.png", "an older picture");
  for (const char* scene : {"reads.pov", "noise.pov"}) {
    const auto then = std::chrono::steady_clock::now();
    Running run({scene, "+W9000", "+H9000", "-V", "+Oa.png", "Max_Time=1"}, m_folder.path());
    EXPECT_EQ(run.wait(), 2) << scene << text("log");
    const auto taken = std::chrono::steady_clock::now() - then;
    EXPECT_GT(taken, std::chrono::milliseconds(900)) << scene;
    EXPECT_LT(taken, std::chrono::seconds(10)) << scene;
    EXPECT_NE(text("log").find("the time is over (Max_Time); the picture was not written"),
              std::string::npos)
        << scene << text("log");
    EXPECT_EQ(text("a.png"), "an older picture");
    EXPECT_EQ(parts().size(), 0u) << scene;
  }
}

TEST_F(ImageStop, ARunWhoseTimeIsOverIsGoneOnWith) {
  const std::vector<std::string> words{"noise.pov", "+W2400",  "+H2000",        "-V",
                                       "+WT2",      "+Oa.png", "Band_Height=64"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  // The first run is too short for any machine; each next one has twice as long.
  int runs = 0, status = 2;
  for (double seconds = 0.1; status == 2 && runs < 16; ++runs, seconds *= 2.0) {
    const std::string limit = "Max_Time=" + std::to_string(seconds) + "s";
    status = Running(with({"+C", limit}), m_folder.path()).wait();
  }
  EXPECT_EQ(status, 0) << text("log");
  EXPECT_GT(runs, 1);
  const std::string parts_joined = text("a.png");
  fs::remove(m_folder / "a.png");
  EXPECT_EQ(Running(with({}), m_folder.path()).wait(), 0);
  EXPECT_TRUE(text("a.png") == parts_joined);
}

TEST_F(ImageStop, AKilledRunLeavesTheOldPictureAndTheNextClearsUp) {
  tool::write_text(m_folder / "a.png", "an older picture");
  Running run(slow("a.png"), m_folder.path());
  ASSERT_TRUE(begun());
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), 128 + SIGKILL);
  EXPECT_EQ(text("a.png"), "an older picture");
  ASSERT_EQ(parts().size(), 1u);
  EXPECT_EQ(parts()[0].filename().string().rfind(".a.png.lentray-", 0), 0u) << parts()[0];
  const auto next = render("a.png");
  EXPECT_EQ(next.status, 0) << next.output;
  EXPECT_EQ(core::read_image(m_folder / "a.png").width, 300u);
  EXPECT_EQ(parts().size(), 0u);
}

TEST_F(ImageStop, TwoRunsOfOnePictureDoNotDisturbEachOther) {
  Running long_run(slow("a.png"), m_folder.path());
  ASSERT_TRUE(begun());
  const auto next = render("a.png");
  EXPECT_EQ(next.status, 0) << next.output;
  EXPECT_EQ(core::read_image(m_folder / "a.png").width, 300u);
  EXPECT_EQ(parts().size(), 1u) << "the first one's file";
}

TEST_F(ImageStop, SignalsThatAreIgnoredStaySo) {
  // As nohup starts a program.
  Running run({"noise.pov", "+W2000", "+H2000", "-V", "+Oa.png", "Band_Height=4"}, m_folder.path(),
              SIGHUP);
  ASSERT_TRUE(begun());
  run.signal(SIGHUP);
  EXPECT_EQ(run.wait(), 0) << text("log");
  EXPECT_EQ(core::read_image(m_folder / "a.png").width, 2000u);
}

class ImageStopDisk : public ImageStop, public ::testing::WithParamInterface<const char*> {};

TEST_P(ImageStopDisk, FullAtAnyPlace) {
  const std::string name = GetParam();
  const auto good = render(name);
  ASSERT_EQ(good.status, 0) << good.output;
  const std::string before = text(name);
  // POSIX counts blocks of 512 bytes. The last one is met only when the file is closed.
  const std::size_t blocks = before.size() / 512;
  ASSERT_GT(blocks, 20u);
  for (const std::size_t limit : {std::size_t{0}, std::size_t{1}, blocks / 2, blocks - 1, blocks}) {
    if (limit == blocks && before.size() % 512 == 0) continue;
    const auto full = render(name, "ulimit -f " + std::to_string(limit) + ";");
    EXPECT_EQ(full.status, 1) << limit << " of " << blocks << " blocks: " << full.output;
    // A run of more than a second has kept what is done, and says so before.
    EXPECT_TRUE(full.output.ends_with("lentray: cannot write '" + name + "': File too large\n"))
        << full.output;
    EXPECT_TRUE(text(name) == before) << "the good picture was touched";
    EXPECT_EQ(parts().size(), 0u);
  }
  const auto fits = render(name, "ulimit -f " + std::to_string(blocks + 1) + ";");
  EXPECT_EQ(fits.status, 0) << fits.output;
}
INSTANTIATE_TEST_SUITE_P(Types, ImageStopDisk, ::testing::Values("a.png", "a.tif", "a.exr"));

TEST_F(ImageStop, AFullDeviceHasItsReason) {
  const auto picture = render("/dev/full");
  EXPECT_EQ(picture.status, 1);
  EXPECT_EQ(picture.output, "lentray: cannot write '/dev/full': No space left on device\n");
  const auto out = render("-", "", "> /dev/full");
  EXPECT_EQ(out.status, 1);
  EXPECT_EQ(out.output, "lentray: cannot write to standard output: No space left on device\n");
}

TEST_F(ImageStop, AReaderThatWentAway) {
  const auto result =
      tool::run_program({"/bin/sh", "-c",
                         "export TMPDIR=\"$PWD\"; { '" + program("lentray").string() +
                             "' noise.pov +W600 +H400 +FN16 -V +O-; echo status $? >&2; } | :"},
                        m_folder.path());
  EXPECT_NE(result.output.find("cannot write to standard output: Broken pipe"), std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("status 1"), std::string::npos) << result.output;
  EXPECT_EQ(parts().size(), 0u);
}

}  // namespace
}  // namespace lentray::test
