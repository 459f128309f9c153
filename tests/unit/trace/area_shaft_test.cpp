// What is said to be the only object between a point and an area light is what any of its shadow rays meets, if it
// meets one.
#include "core/trace/area_shaft.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/accel/hierarchy.h"
#include "core/base/processor.h"
#include "core/light/light_ray.h"
#include "core/scene/scene.h"
#include "core/scene/tolerances.h"
#include "core/trace/thread_context.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::core::test::shafts {
namespace {

const char* const kShaftScenes[] = {
    "sphere { <0, 1, 0>, 1 } plane { y, 0 }",
    "box { <-1, 0, -1>, 1 rotate 30*y } sphere { <2, 1, 1>, 0.5 } plane { -z, -4 } plane { <1, "
    "0.2, 0>, -5 }",
    R"(
    sphere { <-2, 1, 0>, 0.7 pigment { rgbf 0.9 } } torus { 1, 0.2 translate <1, 1, 1> } cylinder {
    <2, 0, -2>, <2, 2, -2>, 0.3 no_shadow } plane { y, 0 } disc { <0, 3, 0>, y, 1 })",
    R"(
    #for (I, 0, 6) sphere { <I - 3, 0.5, mod(I, 3)>, 0.4 } #end difference { box { -1, 1 } sphere {
    0, 1.2 } translate <0, 3, 2> } plane { y, -0.5 clipped_by { sphere { 0, 4 } } })",
};

struct Numbers {
  std::mt19937 random{3};
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  Vec3 point(double size) {
    const double x = in(-size, size), y = in(-size, size);
    return {x, y, in(-size, size)};
  }
};

/// Places of surfaces, where shadow rays begin.
bool find_place(const Scene& scene, Numbers& numbers, HitLists& lists, Vec3& place) {
  const Ray ray{numbers.point(6.0) + Vec3(0, 6, 0), normalized(numbers.point(1.0) - Vec3(0, 1, 0))};
  Hit hit;
  if (!scene.hierarchy().nearest(ray, 0.0, 1e7, RayKind::kCamera, hit, lists, nullptr))
    return false;
  place = ray.at(hit.t);
  return true;
}

AreaLight any_light(Numbers& numbers) {
  AreaLight area;
  area.axis1 = numbers.point(1.5);
  area.axis2 = numbers.point(1.5);
  area.size1 = 1 + static_cast<int>(numbers.in(0.0, 5.0));
  area.size2 = 1 + static_cast<int>(numbers.in(0.0, 5.0));
  area.jitter = numbers.in(0.0, 1.0) < 0.7;
  area.circular = numbers.in(0.0, 1.0) < 0.3;
  area.orient = numbers.in(0.0, 1.0) < 0.3;
  return area;
}

TEST(UnitAreaShaft, SaysWhatItsShadowRaysMeet) {
  if (!has_avx2()) GTEST_SKIP();
  int nothing = 0, one = 0, met = 0;
  for (const char* each : kShaftScenes) {
    SCOPED_TRACE(each);
    parser::test::SceneText text(std::string("light_source { <0, 9, 0>, 1 } ") + each);
    const Scene scene(text.build(), {});
    ThreadContext context(scene, false);
    AreaShaft shaft(context);
    const double tolerance = kShadowTolerance * scene.tolerance_scale();
    Numbers numbers;
    for (int i = 0; i < 4000; ++i) {
      Vec3 point;
      if (!find_place(scene, numbers, context.lists, point)) continue;
      const AreaLight area = any_light(numbers);
      const Vec3 position = numbers.point(5.0) + Vec3(0, 7, 0);
      const AreaAxes axes = area_axes(area, normalized(position - point));
      const OnlyObject only = shaft.only_object(point, position, area, axes);
      if (!only.is_known) continue;
      ++(only.object ? one : nothing);
      for (int k = 0; k < 40; ++k) {
        const int u = static_cast<int>(numbers.in(0.0, area.size1)),
                  v = static_cast<int>(numbers.in(0.0, area.size2));
        const Vec3 offset =
            jittered_area_offset(area, axes, u, v, [&] { return numbers.in(0.0, 1.0); });
        const LightRay to = ray_along(position + offset - point);
        const Object* found = scene.hierarchy().any_opaque(
            {point, to.direction}, tolerance, to.distance - tolerance, context.lists, nullptr);
        if (!found) continue;
        ++met;
        ASSERT_EQ(found, only.object) << i;
      }
    }
  }
  EXPECT_GT(nothing, 200);
  EXPECT_GT(one, 200);
  EXPECT_GT(met, 1000);
}

}  // namespace
}  // namespace lentray::core::test::shafts
