// The inverse of an intersection is the merge of the inverses, with surfaces that are no solids too.
// Stock keeps to the intersection's box and cuts off what of the merge lies beyond it.
#include "tests/unit/parser/scene_text.h"
#include "tests/unit/shape/geometry_help.h"

namespace lentray::parser::test {
namespace {

class UnitShapeInverse : public ::testing::TestWithParam<const char*> {};

TEST_P(UnitShapeInverse, OfAnIntersectionIsTheMergeOfInverses) {
  const std::string one = GetParam(), ball = "sphere { 0, .8 ";
  SceneText inverse("intersection { " + one + " } " + ball + "} inverse }");
  SceneText merge("merge { " + one + " inverse } " + ball + "inverse } }");
  const core::SceneParts a = inverse.build(), b = merge.build();
  core::HitLists lists;
  core::geometry_test::Random random(4);
  int beyond = 0;
  for (int i = 0; i < 400; ++i) {
    const core::Ray ray = random.ray(4.0, 0.7);
    core::Hit found, expected;
    const bool meets = a.objects[0]->nearest(ray, 1e-6, core::Bounds::kInf, found,
                                             {lists, core::RayKind::kShadow});
    ASSERT_EQ(meets, b.objects[0]->nearest(ray, 1e-6, core::Bounds::kInf, expected,
                                           {lists, core::RayKind::kShadow}));
    if (!meets) continue;
    EXPECT_EQ(found.t, expected.t);
    beyond += std::fabs(ray.at(found.t).y) > 0.5;
  }
  EXPECT_GT(beyond, 50);  // of the ball, where the other is not
}

INSTANTIATE_TEST_SUITE_P(
    Each, UnitShapeInverse,
    ::testing::Values(
        "triangle { <-1,0,-1>, <1,0,-1>, <0,0,1>", "disc { 0, y, 1",
        "parametric { function { u } function { .1*u*v } function { v } <-1,-1>, <1,1>"
        " contained_by { box { <-1,-.2,-1>, <1,.2,1> } } max_gradient 2 accuracy .05"));

}  // namespace
}  // namespace lentray::parser::test
