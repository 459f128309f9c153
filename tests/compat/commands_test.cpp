// Commands of INI files around a still, as stock runs them. povray.conf must allow them, so each run sees one
// of its own in place of the system's, in a namespace of its own; where that cannot be, the tests are skipped.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConf = "/etc/povray/3.7/povray.conf";

struct Outcome {
  int status = 0;
  std::string log, console;
  bool has_picture = false;
};

/// In an own namespace `program` renders the scene as the INI lines say. Commands write to "log".
Outcome run(const std::string& program, const std::string& shellout, const std::string& scene,
            const std::string& ini) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", scene);
  tool::write_text(folder / "all.ini", "Input_File_Name=scene.pov\n" + ini);
  tool::write_text(folder / "conf", "[Shellout Security]\n" + shellout + "\n");
  const std::string script = std::string("mount --bind conf ") + kConf + " && HOME=$PWD exec " +
                             program + " all.ini +W4 +H4 -D -V +Oout.png";
  const tool::RunResult result =
      tool::run_program({"unshare", "-rm", "sh", "-c", script}, folder.path(), 60.0);
  return {result.status, fs::exists(folder / "log") ? tool::read_text(folder / "log") : "",
          result.output, fs::exists(folder / "out.png")};
}

class CompatCommands : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string probe = std::string("mount --bind /dev/null ") + kConf;
    if (tool::run_program({"unshare", "-rm", "sh", "-c", probe}).status != 0)
      GTEST_SKIP() << "no namespace for another povray.conf";
  }
};

constexpr const char* kScene =
    "#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }\n";
constexpr const char* kLentrayProgram = LENTRAY_BIN_DIR "/lentray";
const std::string kAllReturns =
    "Pre_Scene_Command=echo prescene %o %w %h >> log\nPre_Frame_Command=echo preframe %n %k >> "
    "log\n"
    "Post_Frame_Command=echo postframe %o >> log\nPost_Scene_Command=echo postscene %o %n >> log\n"
    "User_Abort_Command=echo abort >> log\nFatal_Error_Command=echo fatal >> log\n";

TEST_F(CompatCommands, SequenceAsStock) {
  for (const char* scene : {kScene, "no scene\n"}) {
    const Outcome ours = run(kLentrayProgram, "allowed", scene, kAllReturns),
                  stock = run("povray", "allowed", scene, kAllReturns);
    EXPECT_EQ(ours.log, stock.log) << ours.console;
    EXPECT_EQ(ours.status, stock.status);
    EXPECT_EQ(ours.has_picture, stock.has_picture);
  }
}

// U is left out: stock ends with status 1 where the manual and Lentray have 2. After Post_Scene_Command F leaves stock with
// status 0, the manual and Lentray with 1.
TEST_F(CompatCommands, ActionsAsStock) {
  for (const char* kind : {"Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene"}) {
    for (const char* action : {"S", "!S", "A", "Q", "F"}) {
      const std::string ini =
          kAllReturns + kind + "_Command=false\n" + kind + "_Return=" + action + "\n";
      const Outcome ours = run(kLentrayProgram, "allowed", kScene, ini),
                    stock = run("povray", "allowed", kScene, ini);
      SCOPED_TRACE(std::string(kind) + " " + action);
      EXPECT_EQ(ours.log, stock.log) << ours.console;
      EXPECT_EQ(ours.status, std::string(action) == "F" ? 1 : stock.status);
    }
  }
}

TEST_F(CompatCommands, Abort) {
  const Outcome ours = run(kLentrayProgram, "allowed", kScene,
                           kAllReturns + "Pre_Frame_Command=false\nPre_Frame_Return=U\n");
  EXPECT_EQ(ours.status, 2);
  EXPECT_EQ(ours.log, "prescene out.png 4 4\nabort\n");
  const Outcome fatal = run(kLentrayProgram, "allowed", kScene,
                            kAllReturns +
                                "Pre_Frame_Command=false\nPre_Frame_Return=U\nUser_Abort_Command="
                                "false\nUser_Abort_Return=F\n");
  EXPECT_EQ(fatal.status, 1);
  EXPECT_EQ(fatal.log, "prescene out.png 4 4\nfatal\n");
}

// The scene may be what a command makes.
TEST_F(CompatCommands, MakesTheScene) {
  const Outcome ours = run(kLentrayProgram, "allowed", "#include \"made.inc\"\n",
                           "Pre_Frame_Command=echo 'sphere { 0, 1 }' > made.inc\n");
  EXPECT_EQ(ours.status, 0) << ours.console;
}

TEST_F(CompatCommands, ForbiddenIsAWarningBeforeRendering) {
  const Outcome ours = run(kLentrayProgram, "forbidden", kScene, kAllReturns);
  EXPECT_EQ(ours.status, 0);
  EXPECT_EQ(ours.log, "");
  EXPECT_TRUE(ours.has_picture);
  EXPECT_TRUE(ours.console.starts_with("warning: Pre_Scene_Command, ")) << ours.console;
  EXPECT_NE(ours.console.find(std::string("'allowed' below [Shellout Security] in ") + kConf),
            std::string::npos)
      << ours.console;
}

}  // namespace
}  // namespace lentray::test
