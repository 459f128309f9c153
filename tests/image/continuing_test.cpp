// Going on with pictures and animations (+C), and INI files that ask for a run again. Kills at any moment:
// tests/compat/continuing.py.
#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

/// Takes some seconds, of which the first are without the journal.
const char* const kSlow = R"(#version 3.7; global_settings { assumed_gamma 1 }
INCLUDE
camera { location <0, 1, -6> look_at 0 }
light_source { <-9, 12, -9> 1 area_light 4*x, 4*z, Lamps, Lamps jitter }
sphere { <2*clock - 1, 0, 0>, 1 pigment { Colour } }
plane { y, -1 pigment { checker rgb 1, rgb 0.3 } }
)";

struct ImageContinuing : testing::Test {
  void SetUp() override {
    std::string text = kSlow;
    text.replace(text.find("INCLUDE"), 7, "#include \"colour.inc\"");  // no header of ours
    tool::write_text(folder / "scene.pov", text);
    tool::write_text(folder / "colour.inc", "#declare Colour = rgb <1,.5,.2>;\n");
  }
  tool::RunResult render(std::vector<std::string> more, const std::string& lamps = "2") {
    more.insert(more.begin(), {"scene.pov", "+W80", "+H60", "-D", "Declare=Lamps=" + lamps});
    return run_lentray(more, folder.path());
  }
  /// A run that is stopped after two seconds, well before its end.
  void begin() {
    const tool::RunResult run =
        tool::run_program({"timeout", "-s", "KILL", "2.2", program("lentray").string(), "scene.pov",
                           "+W400", "+H300", "-D", "Declare=Lamps=60"},
                          folder.path(), 60.0);
    ASSERT_NE(run.status, 0);
    ASSERT_TRUE(fs::exists(folder / "scene.png.lentray-state")) << run.output;
    ASSERT_FALSE(fs::exists(folder / "scene.png"));
  }
  /// With +C, in what is as it was but for the arguments.
  std::string refused(const std::string& lamps, std::vector<std::string> more) {
    more.insert(more.begin(),
                {"scene.pov", "+W400", "+H300", "-D", "+C", "Declare=Lamps=" + lamps});
    const tool::RunResult run = run_lentray(more, folder.path());
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_TRUE(fs::exists(folder / "scene.png.lentray-state"));
    EXPECT_FALSE(fs::exists(folder / "scene.png"));
    return run.output;
  }

  tool::TemporaryFolder folder;
};

TEST_F(ImageContinuing, OtherScenesAndOptionsAreRefused) {
  begin();
  EXPECT_NE(
      refused("61", {}).find("begun with Declare=Lamps=60, and now there is Declare=Lamps=61"),
      std::string::npos);
  EXPECT_NE(refused("60", {"+A"}).find("Antialias=Off, and now there is Antialias=On"),
            std::string::npos);
  EXPECT_NE(refused("60", {"+K1"}).find("clock"), std::string::npos);
  tool::write_text(folder / "colour.inc", "#declare Colour = rgb <1,.5,.3>;\n");
  EXPECT_NE(refused("60", {}).find("colour.inc has changed"), std::string::npos);
  // Without +C it is made anew, and what was kept is gone.
  ASSERT_EQ(render({}).status, 0);
  EXPECT_FALSE(fs::exists(folder / "scene.png.lentray-state"));
}

TEST_F(ImageContinuing, APictureThatIsThereIsKeptAsInStock) {
  ASSERT_EQ(render({}).status, 0);
  const auto first = fs::last_write_time(folder / "scene.png");
  const tool::RunResult again = render({"+C"});
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.output.find("there already"), std::string::npos) << again.output;
  EXPECT_EQ(fs::last_write_time(folder / "scene.png"), first);
}

TEST_F(ImageContinuing, MissingFramesAreMade) {
  ASSERT_EQ(render({"+KFF3"}).status, 0);
  const StoredImage second = core::read_image(folder / "scene2.png");
  fs::remove(folder / "scene2.png");
  const auto third = fs::last_write_time(folder / "scene3.png");
  ASSERT_EQ(render({"+KFF3", "+C"}).status, 0);
  EXPECT_TRUE(same_bits(core::read_image(folder / "scene2.png"), second));
  EXPECT_EQ(fs::last_write_time(folder / "scene3.png"), third);
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    EXPECT_EQ(entry.path().string().find("lentray-state"), std::string::npos) << entry.path();
  }
}

TEST_F(ImageContinuing, FramesOfAChangedSceneAreNotMixed) {
  // The third frame fails: the first two say that they are finished.
  tool::write_text(folder / "colour.inc",
                   "#declare Colour = rgb 1;\n#if (frame_number = 3) #error \"stop\" #end\n");
  ASSERT_EQ(render({"+KFF3"}).status, 1);
  ASSERT_TRUE(fs::exists(folder / "scene2.png"));
  tool::write_text(folder / "colour.inc", "#declare Colour = rgb 0.5;\n");
  const tool::RunResult mixed = render({"+KFF3", "+C"});
  EXPECT_EQ(mixed.status, 1);
  EXPECT_NE(mixed.output.find("colour.inc has changed"), std::string::npos) << mixed.output;
  EXPECT_FALSE(fs::exists(folder / "scene3.png"));
}

TEST_F(ImageContinuing, AnIniFileAsksForTheSamePicture) {
  ASSERT_EQ(render({"+A0.1", "+R2", "+KFF2", "+GIagain.ini"}).status, 0);
  const StoredImage first = core::read_image(folder / "scene2.png");
  fs::remove(folder / "scene2.png");
  const tool::RunResult again = run_lentray({"again.ini"}, folder.path());
  ASSERT_EQ(again.status, 0) << again.output;
  EXPECT_TRUE(same_bits(core::read_image(folder / "scene2.png"), first));
}

}  // namespace
}  // namespace lentray::test
