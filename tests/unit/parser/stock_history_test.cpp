// Which placements keep steps: usual ones none.
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using StockHistoryKind = PlacementStep::Kind;

std::vector<StockHistoryKind> kinds(const char* text) {
  const SceneText s(text);
  std::vector<StockHistoryKind> out;
  for (const PlacementStep& step : *s.object(0).transform->steps) out.push_back(step.kind);
  return out;
}

TEST(UnitParserHistory, UsualPlacementsKeepNoSteps) {
  for (const char* text :
       {"sphere { 0, 1 }", "sphere { 0, 1 translate x rotate y*30 scale 2 translate z }",
        "box { -1, 1 rotate 30 scale <1, 2, 3> matrix <1,1,0, 0,1,0, 0,0,1, 0,0,0> rotate 30 }",
        "union { sphere { 0, 1 } box { 0, 1 } scale <1, 2, 3> rotate 30 translate x }",
        "quadric { <1,1,1>, 0, 0, -1 scale <1, 2, 3> translate x }"}) {
    EXPECT_TRUE(kinds(text).empty()) << text;
  }
}

TEST(UnitParserHistory, ABallEndsOnce) {
  const SceneText s(
      "sphere { 0, 1 translate x scale <1, 2, 1> rotate 30 matrix <1,1,0, 0,1,0, 0,0,1, 0,0,0> }");
  const PlacementSteps& steps = *s.object(0).transform->steps;
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].kind, StockHistoryKind::kBefore);
  EXPECT_EQ(steps[0].transform.point({}), core::Vec3(1, 0, 0));
}

TEST(UnitParserHistory, TurnsOfACsgAreKeptFromTheSecondOn) {
  EXPECT_EQ(kinds("union { sphere { 0, 1 } box { 0, 1 } rotate 30 translate x rotate 40 scale 2 "
                  "rotate 50 }"),
            (std::vector{StockHistoryKind::kBefore, StockHistoryKind::kTransform,
                         StockHistoryKind::kTransform}));
}

TEST(UnitParserHistory, ClipsOfAQuadricAreKeptAsTheyStood) {
  const SceneText s(
      "quadric { <1,0,1>, 0, 0, -1 translate x clipped_by { box { -1, 1 } } translate y }");
  const PlacementSteps& steps = *s.object(0).transform->steps;
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].kind, StockHistoryKind::kClips);
  EXPECT_EQ(steps[0].transform.point({}), core::Vec3(1, 0, 0));
  ASSERT_EQ(steps[0].clips.size(), 1u);
  EXPECT_TRUE(steps[0].clips[0]->transform->is_identity());
  EXPECT_EQ(s.object(0).rare->clipped_by[0]->transform->point({}), core::Vec3(0, 1, 0));
  EXPECT_EQ(steps[1].kind, StockHistoryKind::kTransform);
}

}  // namespace
}  // namespace lentray::parser::test
