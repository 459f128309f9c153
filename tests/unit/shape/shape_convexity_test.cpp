// Rays that leave a surface of which Convexity says so do not meet the object again: of shapes however
// they are placed, inverse or clipped, and of intersections.
#include <gtest/gtest.h>

#include <random>

#include "core/object/leaf.h"
#include "tests/unit/parser/scene_text.h"
#include "tests/unit/shape/shape_cases.h"

namespace lentray::parser::test {
namespace {

using core::Bounds;
using core::Convexity;
using core::Ray;

struct Seen {
  int sure = 0, met = 0;
};

/// So many rays from without to a scene's only object, and on from what they meet, at all angles to the normal.
Seen leave(const std::string& sdl, int rays) {
  constexpr double kTolerance = 1e-5, kOfSlope = 1e-3;
  SceneText text(sdl, with_fonts());
  const core::SceneParts parts = text.build();
  const core::Object& object = *parts.objects.at(0);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto point = [&] { return Vec3{normal(random), normal(random), normal(random)}; };
  core::HitLists lists;
  Seen seen;
  for (int i = 0; i < rays; ++i) {
    const Vec3 from = normalized(point()) * 9.0, way = normalized(point() * 0.6 - from);
    core::Hit hit;
    if (!object.nearest({from, way}, 1e-6, Bounds::kInf, hit, {lists, core::RayKind::kShadow}))
      continue;
    const Convexity convexity = hit.leaf->convexity();
    if (convexity == Convexity::kNone || !object.lies_in_parts()) continue;
    const Vec3 p = from + way * hit.t;
    Vec3 out = hit.leaf->normal(p, hit.shape);
    if (dot(out, way) > 0.0) {
      if (!(convexity == Convexity::kFlat && &object == hit.leaf)) continue;
      out = -out;
    }
    for (int j = 0; j < 8; ++j) {
      // Some at hardly any angle to the surface.
      Vec3 along = normalized(point());
      const double share = dot(along, out);
      if (j % 2 == 0) along = normalized(along - out * (share - 0.002));
      if (dot(along, out) < 0.0) along = -along;
      if (!(dot(along, out) > kOfSlope)) continue;
      ++seen.sure;
      seen.met += object.any({p, along}, kTolerance, Bounds::kInf, {lists, core::RayKind::kShadow});
    }
  }
  return seen;
}

class UnitShapeConvexity : public ::testing::TestWithParam<ShapeCase> {
 protected:
  static void expect_that_rays_do_not_come_back(int rays);
};
/// The same by more rays.
class SlowShapeConvexity : public UnitShapeConvexity {};

void UnitShapeConvexity::expect_that_rays_do_not_come_back(int rays) {
  const auto seen = [rays](const std::string& sdl) { return leave(sdl, rays); };
  for (const auto& placing : kPlacings) {
    const std::string shape = std::string("object { ") + GetParam().sdl + " " + placing.sdl + " ";
    const Seen plain = seen(shape + "}");
    EXPECT_EQ(plain.met, 0) << placing.name << " of " << plain.sure;
    EXPECT_EQ(seen(shape + "inverse }").met, 0) << placing.name;
    EXPECT_EQ(seen(shape + "clipped_by { plane { <1,2,1>, .2 } } }").met, 0) << placing.name;
    EXPECT_EQ(seen("difference { " + shape + "} sphere { <.5,.6,-.4>, .8 } }").met, 0)
        << placing.name;
    EXPECT_EQ(seen("intersection { " + shape +
                   "} box { <-.8,-.7,-.3>, .9 inverse } cylinder { -y, y, .9 } }")
                  .met,
              0)
        << placing.name;
    EXPECT_EQ(seen("difference { box { -1, .8 } " + shape + "} }").met, 0) << placing.name;
    EXPECT_EQ(seen("difference { sphere { 0, 1.2 } union { " + shape +
                   "scale .6 } sphere { <.9,.6,-.4>, .3 } } }")
                  .met,
              0)
        << placing.name;
    EXPECT_EQ(seen("merge { " + shape + "} sphere { <.9,.6,-.4>, .8 } }").sure, 0) << placing.name;
  }
}

TEST_P(UnitShapeConvexity, RaysThatLeaveDoNotComeBack) { expect_that_rays_do_not_come_back(1000); }
TEST_P(SlowShapeConvexity, RaysThatLeaveDoNotComeBack) { expect_that_rays_do_not_come_back(4000); }

std::vector<ShapeCase> quick_ones() {
  std::vector<ShapeCase> cases;
  for (const ShapeCase& one : kShapeCases) {
    const std::string name = one.name;
    if (!one.surface && !name.starts_with("julia") && !name.starts_with("iso"))
      cases.push_back(one);
  }
  return cases;
}

std::string convexity_name(const ::testing::TestParamInfo<ShapeCase>& one) {
  return one.param.name;
}

INSTANTIATE_TEST_SUITE_P(Each, UnitShapeConvexity, ::testing::ValuesIn(quick_ones()),
                         convexity_name);
INSTANTIATE_TEST_SUITE_P(Each, SlowShapeConvexity, ::testing::ValuesIn(quick_ones()),
                         convexity_name);

TEST(UnitShapeConvexityOf, SimpleShapesAndIntersectionsIsKnown) {
  for (const char* sdl :
       {"sphere { 0, 1 }", "sphere { 0, 1 scale <1,.3,2> }", "box { -1, 1 rotate 30 }",
        "cone { -y, 1, y, .2 }", "cylinder { -y, y, 1 }", "superellipsoid { <.3,.5> }",
        "ovus { .8, .45 }", "disc { 0, y, 1, .3 }", "difference { box { -1, 1 } sphere { -z, 1 } }",
        "intersection { sphere { 0, 1 } difference { box { -.9, .9 } sphere { -z, .4 } } }"}) {
    EXPECT_GT(leave(sdl, 4000).sure, 500) << sdl;
  }
  for (const char* sdl :
       {"torus { 1, .3 }", "superellipsoid { <2.6,2.2> }",
        "smooth_triangle { -x, -z, x, -z, y, <1,0,-1> }",
        "merge { sphere { 0, 1 } sphere { x, 1 } }",
        "intersection { sphere { 0, 1 } merge { sphere { 0, .8 } sphere { x, .8 } } }"}) {
    EXPECT_EQ(leave(sdl, 4000).sure, 0) << sdl;
  }
}

}  // namespace
}  // namespace lentray::parser::test
