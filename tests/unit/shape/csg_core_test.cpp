// CSG that asks its core first gives the same answers as without: of rays from afar, from within, along
// common faces, to any length.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/parser/scene_text.h"
#include "tests/unit/shape/plain_shapes.h"

namespace lentray::parser::test {
namespace {

using core::Bounds;
using core::Hit;
using core::Ray;
using core::Vec3;

constexpr const char* kObjects[] = {
    "difference { box { -.7, .7 } sphere { 0, .9 } cylinder { -2*z, 2*z, .3 } }",
    "intersection { sphere { -.5*z, 1.1 } sphere { .5*z, 1.1 } cylinder { -z, z, .8 } }",
    "difference { union { sphere { -.3*x, .7 } cone { .3*x, .7, x + y, .2 } } box { <-2,0,-2>, 2 } "
    "}",
    "difference { cylinder { -y, y, .8 open } box { <-2,.2,-2>, <2,2,0> } }",
    "intersection { box { -1, 1 } box { <-1,-.5,-1>, <1,.5,2> } sphere { 0, 1.2 } clipped_by { "
    "plane { y, .3 } } }",
    "difference { box { -1, 1 } box { <-2,-.8,-.8>, <2,.8,.8> rotate 30*y } box { <-.8,-2,-.8>, "
    "<.8,2,.8> scale <1,1,.01> } box { <-.8,-.8,-2>, <.8,.8,2> } }",
    "difference { cone { -y, 1, y, .4 } sphere { 0, .5 scale <1,2,1> rotate 20*z } cone { -2*y, "
    ".3, "
    "y, .3 } plane { y, -.5 } }",
    "intersection { box { -1, <1,.5,1> } plane { x + y, .5 } cylinder { -y, y, 1.1 } sphere { "
    ".5*y, "
    ".9 inverse } plane { -z, .5 } }",
    "difference { box { -1, <1,.5,1> } box { <-.5,-1,-.5>, .5 } cylinder { <.5,-2,0>, <.5,.5,0>, "
    ".4 } "
    "}",
    "difference { superellipsoid { <.3,.5> } merge { sphere { x, .6 } sphere { .5*y, .6 } } "
    "bounded_by { box { -.9, 1 } } }",
    "intersection { difference { sphere { 0, 1 } cylinder { -2*y, 2*y, .3 } } box { -.8, .8 rotate "
    "20*x } inverse }",
    "merge { sphere { -.4*x, .7 } sphere { .4*x, .7 } cylinder { -y, y, .3 } }",
    "union { sphere { -.4*x, .7 } disc { 0, y, 1 } clipped_by { box { -.6, .9 } } }"};

class UnitCsgCore : public ::testing::TestWithParam<const char*> {};

TEST_P(UnitCsgCore, SparesWorkAlone) {
  const std::string sdl =
      std::string("object { ") + GetParam() + " rotate <0,10,0> translate <.1,0,.2> }";
  SceneText one(sdl), other(sdl);
  const core::SceneParts usual = one.build(), plain = other.build();
  core::HitLists lists;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto point = [&] { return Vec3{normal(random), normal(random), normal(random)}; };
  int met = 0;
  ASSERT_EQ(usual.objects.size(), plain.objects.size());
  for (std::size_t k = 0; k < usual.objects.size(); ++k) {
    const core::Object& shorter = *usual.objects[k];
    const core::PlainObject longer(*plain.objects[k]);
    for (int i = 0; i < 20000; ++i) {
      Vec3 from = point() * (i % 3 == 0 ? 0.4 : 3.0),
           way = normalized(point() - from * (i % 3 == 0 ? 0.0 : 0.7));
      if (i % 5 == 0) from.y = 0.5;  // in a common face
      if (i % 10 == 0) way = normalized(Vec3{way.x, 0.0, way.z});
      const Ray ray{from, way};
      std::vector<Hit> found, expected;
      shorter.all(ray, 1e-6, Bounds::kInf, found, {lists, core::RayKind::kShadow});
      longer.all(ray, 1e-6, Bounds::kInf, expected, {lists, core::RayKind::kShadow});
      const auto nearer = [](const Hit& a, const Hit& b) { return a.t < b.t; };
      std::sort(found.begin(), found.end(), nearer);
      std::sort(expected.begin(), expected.end(), nearer);
      ASSERT_EQ(found.size(), expected.size()) << i;
      for (std::size_t h = 0; h < found.size(); ++h) ASSERT_EQ(found[h].t, expected[h].t) << i;
      met += !found.empty();
      const double to = i % 2 == 0 ? Bounds::kInf : 1.5;
      Hit first, expected_first;
      const bool is_met =
          longer.nearest(ray, 1e-6, to, expected_first, {lists, core::RayKind::kShadow});
      ASSERT_EQ(shorter.nearest(ray, 1e-6, to, first, {lists, core::RayKind::kShadow}), is_met)
          << i;
      ASSERT_EQ(first.t, expected_first.t) << i;
      ASSERT_EQ(shorter.any(ray, 1e-6, to, {lists, core::RayKind::kShadow}), is_met) << i;
    }
  }
  EXPECT_GT(met, 1000);
}

INSTANTIATE_TEST_SUITE_P(Each, UnitCsgCore, ::testing::ValuesIn(kObjects),
                         [](const auto& one) { return std::to_string(one.index); });

}  // namespace
}  // namespace lentray::parser::test
