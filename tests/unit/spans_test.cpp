// Blocks of rays, places and shadow queries: each answer has the bits of the one that is asked for
// alone.
#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

#include "camera/lenticular.h"
#include "camera/orthographic.h"
#include "camera/perspective.h"
#include "core/accel/hierarchy.h"
#include "core/trace/thread_context.h"
#include "shadow/tester_factory.h"
#include "tests/unit/plain_camera.h"
#include "tests/unit/random_objects.h"
#include "tests/unit/scene_text.h"

namespace lentray::test {
namespace {

bool spans_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool spans_same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
bool spans_same_bits(const Vec3& a, const Vec3& b) {
  return spans_same_bits(a.x, b.x) && spans_same_bits(a.y, b.y) && spans_same_bits(a.z, b.z);
}

/// Of a picture of 60 x 40 pixels, some of them beside it.
std::vector<PixelPlace> places() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  std::vector<PixelPlace> all;
  for (std::int32_t row = -2; row < 42; row += 3) {
    for (std::int32_t column = -2; column < 62; ++column) {
      all.push_back({column, row, part(random), part(random), part(random)});
    }
  }
  return all;
}

/// How many pixels show something.
std::size_t expect_same_rays(const camera::Camera& camera) {
  const std::vector<PixelPlace> asked = places();
  std::vector<PlaceRay> all(asked.size());
  camera.rays(asked, all);
  std::size_t shown = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    Ray one;
    const bool shows = camera.ray_at(asked[i], one);
    EXPECT_EQ(all[i].shows, shows) << camera.name() << " " << i;
    if (!shows) continue;
    ++shown;
    EXPECT_TRUE(spans_same_bits(all[i].ray.origin, one.origin) &&
                spans_same_bits(all[i].ray.direction, one.direction))
        << camera.name() << " " << i;
  }
  return shown;
}

TEST(UnitSpans, RaysOfPlaces) {
  const std::size_t all = places().size();
  EXPECT_EQ(expect_same_rays(camera::Perspective(camera::plain_camera(), 60, 40)), all);
  EXPECT_EQ(expect_same_rays(camera::Orthographic(camera::plain_camera(), 60, 40)), all);
}

TEST(UnitSpans, RaysOfALensSheetWithDarkPixels) {
  camera::LensParameters lens;
  lens.pitch = 6.0;
  const std::size_t shown = expect_same_rays(camera::Lenticular(lens, {}, 60, 40));
  EXPECT_GT(shown, 0u);
  EXPECT_LT(shown, places().size());
}

TEST(UnitSpans, NearestHits) {
  SceneMaker maker({"spans", 10.0, 1.0, {0, 0, 0}, 20.0, true, true});
  const Objects objects = maker.objects(200);
  std::vector<NearestQuery> queries;
  for (int i = 0; i < 2000; ++i) {
    queries.push_back(
        {maker.ray(), 0.01 * i, i % 3 == 0 ? 15.0 : Bounds::kInf, static_cast<RayKind>(i % 4)});
  }
  HitArena arena;
  for (const auto accelerator : {Accelerator::kBvh, Accelerator::kGrid, Accelerator::kList}) {
    const Hierarchy tree(objects, accelerator);
    // What was found before does not stay.
    std::vector<Hit> all(queries.size(), Hit{1.0, nullptr, objects.front().get(), {}, 0});
    tree.nearest(queries, all, arena, nullptr);
    std::size_t found = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const NearestQuery& q = queries[i];
      Hit one;
      const bool hit = tree.nearest(q.ray, q.t_min, q.t_max, q.kind, one, arena, nullptr);
      ASSERT_EQ(all[i].object != nullptr, hit) << i;
      if (!hit) continue;
      ++found;
      ASSERT_EQ(all[i].object, one.object);
      ASSERT_EQ(all[i].leaf, one.leaf);
      ASSERT_EQ(all[i].shape.element, one.shape.element);
      ASSERT_TRUE(spans_same_bits(all[i].t, one.t) &&
                  spans_same_bits(all[i].shape.t, one.shape.t) &&
                  spans_same_bits(all[i].shape.u, one.shape.u) &&
                  spans_same_bits(all[i].shape.v, one.shape.v))
          << i;
    }
    EXPECT_GT(found, queries.size() / 10);
    EXPECT_LT(found, queries.size());
  }
}

TEST(UnitSpans, VisibilitiesWithEveryCache) {
  parser::test::SceneText text(
      "light_source { <0,20,0>, 1 } plane { y, -3 pigment { rgb 1 } } #declare I = 0; "
      "#while (I < 40) sphere { <mod(I, 8)*2 - 7, mod(I, 3), I/4 - 5>, .6 "
      "pigment { rgbf <.9, .5, .7, (mod(I, 5) = 0)*.8> } } #declare I = I + 1; #end");
  const Scene scene(text.build(), {});
  std::mt19937 random(4);
  std::uniform_real_distribution<double> along(-8.0, 8.0);
  std::vector<ShadowQuery> queries;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    ShadowQuery query;
    const Vec3 from{along(random), -2.9, along(random)};
    const Vec3 way = Vec3{0, 20, 0} - from;
    query.distance = length(way);
    query.ray = {from, normalized(way)};
    query.column = i % 60;
    query.row = i / 60;
    query.depth = 1 + static_cast<int>(i % 3);
    query.tree_place = 1u << (i % 3);
    queries.push_back(query);
  }
  for (const std::string_view name : shadow::tester_names()) {
    ThreadContext context(scene, false), other(scene, false);
    const auto factory = shadow::make_tester_factory(name);
    const auto scalar = factory->make(context), span = factory->make(other);
    std::vector<Visibility> all(queries.size());
    span->visibilities(queries, all);
    std::size_t blocked = 0, filtered = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Visibility one = scalar->visibility(queries[i]);
      ASSERT_TRUE(spans_same_bits(all[i].filter.r, one.filter.r) &&
                  spans_same_bits(all[i].filter.g, one.filter.g) &&
                  spans_same_bits(all[i].filter.b, one.filter.b))
          << name << " " << i;
      ASSERT_EQ(all[i].blocker, one.blocker) << name << " " << i;
      if (one.blocker)
        ++blocked;
      else if (one.filter != Rgb(1.0f))
        ++filtered;
    }
    EXPECT_GT(blocked, 100u) << name;
    EXPECT_GT(filtered, 10u) << name;
  }
}

}  // namespace
}  // namespace lentray::test
