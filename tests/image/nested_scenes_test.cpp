// Objects and looks that a loop puts into each other: a recursion kept in one identifier.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/render.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

const char* const kNestedHead = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,0,-8> look_at 0 }
light_source { <10,20,-30> rgb 1 }
)";

/// What is declared, what each of `levels` turns makes of it, and what shows it.
std::string nested_scene(const std::string& first, const std::string& turn,
                         const std::string& shown, int levels) {
  return kNestedHead + ("#declare A = " + first) + "\n#for (I,1," + std::to_string(levels) +
         ") #declare A = " + turn + " #end\n" + shown;
}

const char* const kNestedBall = "sphere { 0, 0.2 pigment { rgb <1,.5,.3> } }";
const std::string kNestedMore =
    "sphere { <3*sin(I/20),2*cos(I/17),I/900>, .1 pigment { rgb <.3,.6,1> } }";

TEST(ImageNestedScenes, ElevenHundredAsInStock) {
  for (const std::string& turn :
       {"union { object { A } " + kNestedMore + " }", "merge { object { A } " + kNestedMore + " }",
        "union { object { A } " + kNestedMore + " rotate 0.1*y }"}) {
    SceneText scene;
    scene.sdl = nested_scene(kNestedBall, turn, "object { A }", 1100);
    scene.width = 60;
    scene.height = 45;
    EXPECT_TRUE(same_as_stock(scene)) << turn;
  }
}

TEST(ImageNestedScenes, ThousandsOfLevels) {
  const std::string cases[][3] = {
      {kNestedBall, "union { object { A } " + kNestedMore + " rotate 0.1*y }", "object { A }"},
      {kNestedBall, "merge { object { A } " + kNestedMore + " }", "object { A }"},
      {kNestedBall, "sphere { 0, 1 pigment { object { A } } }", "object { A }"},
      {"pigment { rgb x }", "pigment { gradient x pigment_map { [0 A] [1 rgb y] } }",
       "sphere { 0, 1 pigment { A } }"},
      {"texture { pigment { rgb x } }",
       "texture { gradient x texture_map { [0 A] [1 pigment { rgb y }] } }",
       "sphere { 0, 1 texture { A } }"},
  };
  for (const auto& [first, turn, shown] : cases) {
    const tool::TemporaryFolder folder;
    tool::write_text(folder / "scene.pov", nested_scene(first, turn, shown, 5'000));
    const tool::RunResult result =
        run_lentray({"+Iscene.pov", "+Oscene.png", "+W12", "+H9", "-D"}, folder.path());
    EXPECT_EQ(result.status, 0) << turn << "\n" << result.output;
  }
}

TEST(ImageNestedScenes, DeepMerges) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov",
                   nested_scene(kNestedBall, "merge { object { A } " + kNestedMore + " }",
                                "object { A }", 25'000));
  const tool::RunResult result =
      run_lentray({"+Iscene.pov", "+Oscene.png", "+W12", "+H9", "-D"}, folder.path());
  EXPECT_EQ(result.status, 0) << result.output;
}

}  // namespace
}  // namespace lentray::test
