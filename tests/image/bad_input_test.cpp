// Bad input: a clear message, an exit status, and the good picture that stood there survives.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using tool::RunResult;
using tool::TemporaryFolder;

constexpr const char* kGood =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    "camera { location <0,0,-3> look_at 0 }\n"
    "light_source { <5,5,-5> rgb 1 }\n"
    "sphere { 0, 1 pigment { rgb 1 } }\n";

/// A folder with a good scene and its picture, a.png, to be hurt.
class BadInput : public ::testing::Test {
 protected:
  void SetUp() override {
    put("good.pov", kGood);
    const RunResult result = render("good.pov");
    ASSERT_EQ(result.status, 0) << result.output;
    m_before = tool::read_text(m_folder / "a.png");
    ASSERT_FALSE(m_before.empty());
  }

  void put(const std::string& name, const std::string& text) {
    tool::write_text(m_folder / name, text);
  }

  RunResult render(const std::string& scene, const std::vector<std::string>& more = {},
                   double seconds = 60.0) {
    std::vector<std::string> arguments{"+I" + scene, "+Oa.png", "+W40", "+H30", "-V"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_lentray(arguments, m_folder.path(), seconds);
  }

  /// It failed in good order, said all of `words`, and harmed nothing.
  void expect_refused(const RunResult& result, const std::vector<std::string>& words) {
    EXPECT_EQ(result.status, 1) << result.output;  // the user's error; 3 would be ours
    EXPECT_FALSE(result.timed_out);
    for (const std::string& word : words) {
      EXPECT_NE(result.output.find(word), std::string::npos) << "'" << word << "' is missing in:\n"
                                                             << result.output;
    }
    expect_unharmed();
  }

  void expect_unharmed() {
    EXPECT_EQ(tool::read_text(m_folder / "a.png"), m_before) << "the good picture was touched";
    for (const auto& entry : fs::directory_iterator(m_folder.path())) {
      EXPECT_EQ(entry.path().string().find(".part"), std::string::npos)
          << "left behind: " << entry.path();
    }
  }

  TemporaryFolder m_folder;
  std::string m_before;
};

TEST_F(BadInput, MissingScene) { expect_refused(render("nothing.pov"), {"nothing.pov"}); }

TEST_F(BadInput, SceneIsAFolder) {
  fs::create_directory(m_folder / "folder.pov");
  expect_refused(render("folder.pov"), {"folder.pov"});
}

TEST_F(BadInput, MissingInclude) {
  put("bad.pov", std::string("#version 3.7;\n#include \"missing.inc\"\n") + kGood);
  expect_refused(render("bad.pov"), {"missing.inc", "bad.pov:2"});
}

TEST_F(BadInput, ParseErrorInIncludeInsideMacro) {
  put("shapes_of_mine.inc",
      "#macro Twin(Where)\n"
      "  sphere { Where, 1 }\n"
      "  sphere { Where + 2*x 1 pigmnt { rgb 1 } }\n"
      "#end\n");
  put("bad.pov", std::string(kGood) + "#include \"shapes_of_mine.inc\"\nTwin(<0,0,4>)\n");
  // Where it is, and the way there.
  expect_refused(render("bad.pov"), {"shapes_of_mine.inc:3", "bad.pov:7", "Twin", "^"});
}

TEST_F(BadInput, SizeNought) {
  expect_refused(render("good.pov", {"+W0"}), {"0"});
  expect_refused(render("good.pov", {"+H0"}), {"0"});
  expect_refused(render("good.pov", {"Width=-5"}), {"-5"});
  expect_refused(render("good.pov", {"+Wmany"}), {"many"});
}

TEST_F(BadInput, SizeAbsurd) {
  const RunResult result = render("good.pov", {"+W2000000000", "+H2000000000"}, 20.0);
  expect_refused(result, {"2000000000"});
  expect_refused(render("good.pov", {"+W99999999999999999999999"}, 20.0), {"9999999"});
}

TEST_F(BadInput, UnwritableOutput) {
  expect_refused(render("good.pov", {"+Onowhere/b.png"}), {"nowhere"});
  expect_refused(render("good.pov", {"+Ogood.pov/b.png"}), {"good.pov"});
}

TEST_F(BadInput, UnwritableStatistics) {
  expect_refused(render("good.pov", {"+Ob.png", "Statistics_File=nowhere/s.json"}), {"nowhere"});
}

TEST_F(BadInput, UnknownOption) {
  expect_refused(render("good.pov", {"Lens_Pichs=2"}), {"Lens_Pichs"});
  expect_refused(render("good.pov", {"Lenticular=On", "Lens_Pixels=0"}), {"pixel"});
}

TEST_F(BadInput, KilledWhileRendering) {
  put("big.pov", std::string(kGood) +
                     "#for (I, 0, 400) sphere { <mod(I,20)/10-1, floor(I/20)/10-1, 2>, 0.06 "
                     "pigment { rgb 1 } finish { reflection 0.8 } } #end\n");
  const RunResult result = render("big.pov", {"+W6000", "+H6000", "+WT1"}, 0.5);
  EXPECT_TRUE(result.timed_out) << "too fast to be killed";
  EXPECT_EQ(tool::read_text(m_folder / "a.png"), m_before);
}

/// What cannot be written is said, whatever it is and wherever it goes.
TEST_F(BadInput, NothingIsLostSilently) {
  const std::string lentray = "'" + program("lentray").string() + "' +Igood.pov +W40 +H30 -V ";
  for (const std::string what : {"--dump", "--explain", "--help", "--version", "--dump-rays=-",
                                 "+O-", "+GA/dev/full +Ob.png", "+GS/dev/full +Ob.png",
                                 "Statistics_File=/dev/full +Ob.png", "+GI/dev/full +Ob.png"}) {
    const bool to_output = what.find("/dev/full") == std::string::npos;
    for (const std::string where : {">/dev/full", ">&-"}) {
      if (!to_output && where == ">&-") continue;
      const RunResult result = tool::run_program(
          {"/bin/sh", "-c", lentray + what + (to_output ? " " + where : "")}, m_folder.path());
      EXPECT_EQ(result.status, 1) << what << where << result.output;
      EXPECT_NE(result.output.find("cannot write"), std::string::npos)
          << what << where << result.output;
    }
  }
  for (const char* other : {"lentray-diff", "lentray-model", "lentray-grouping"}) {
    if (!fs::exists(program(other))) continue;  // the study's may be left out
    const RunResult result = tool::run_program(
        {"/bin/sh", "-c", "'" + program(other).string() + "' --help >/dev/full"}, m_folder.path());
    EXPECT_EQ(result.status, 1) << other << result.output;
    EXPECT_NE(result.output.find("cannot write"), std::string::npos) << other << result.output;
  }
}

/// No file of the program gets the number of a stream that is closed.
TEST_F(BadInput, ClosedStreamsAreNotFiles) {
  const RunResult result = tool::run_program(
      {"/bin/sh", "-c",
       "'" + program("lentray").string() + "' +Igood.pov +Ob.png +W40 +H30 +V <&- >&- 2>&-"},
      m_folder.path());
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(tool::read_text(m_folder / "b.png") == m_before);
}

TEST_F(BadInput, DiffSaysErrorsWithStatusTwo) {
  const auto status = [&](const std::vector<std::string>& arguments) {
    return run_diff(arguments, m_folder.path()).status;
  };
  EXPECT_EQ(status({"nothing.pov"}), 2);
  EXPECT_EQ(status({"a.png", "nothing.png"}), 2);
  EXPECT_EQ(status({"good.pov", "--grade", "good"}), 2);
  EXPECT_EQ(status({"good.pov", "--frobnicate"}), 2);
  put("bad.pov", "#version 3.7;\nsphere { <0,0,0> 1 pigmen }\n");
  EXPECT_EQ(status({"bad.pov"}), 2);
  EXPECT_EQ(status({"a.png", "a.png", "--no-pictures"}), 0);
}

constexpr const char* kSkyAlone =
    "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.2,.4,.6> }\n";

SceneText clear_discs(int count) {
  return {.sdl = kSkyAlone +
                 ("camera { location -3*z look_at 0 }\n#for (I, 1, " + std::to_string(count) +
                  ") disc { z*I/10000, z, 50 pigment { rgbt 1 } } #end\n"),
          .width = 4,
          .height = 3};
}

// Clear surfaces are no levels of max_trace_level; stock's stack overflows here.
TEST(ImageBadInput, ClearSurfacesBehindOneAnotherMayBeMany) {
  EXPECT_TRUE(same_bits(lentray_render(clear_discs(49'999)),
                        lentray_render({.sdl = kSkyAlone, .width = 4, .height = 3})));
}

TEST(ImageBadInput, BehindMoreClearSurfacesItIsDark) {
  const TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", clear_discs(50'000).sdl);
  const RunResult result = run_lentray({"+Iscene.pov", "+Oscene.png", "+W4", "+H3"}, folder.path());
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_NE(result.output.find("12 rays met 50000 surfaces behind one another"), std::string::npos)
      << result.output;
  const StoredImage picture = core::read_image(folder / "scene.png");
  EXPECT_TRUE(same_bits(
      picture,
      lentray_render({.sdl = "#version 3.7; background { rgb 0 }\n", .width = 4, .height = 3})));
}

}  // namespace
}  // namespace lentray::test
