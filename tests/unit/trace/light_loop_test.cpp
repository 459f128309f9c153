// The light loop's steps: what is collected of a point, and that shadow rays of many points may be
// asked in any order.
#include "core/trace/light_loop.h"

#include <gtest/gtest.h>

#include <bit>
#include <memory>
#include <random>
#include <vector>

#include "shadow/tester_factory.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::test {
namespace {

using namespace core;

/// The side of a plane that is lit.
struct LightLoopFacing {
  Vec3 normal;
  bool may_face(const LightSource& source, const Vec3& to) const {
    return !source.surely_behind(to, normal);
  }
  bool faces(const LightSource&, const Vec3& direction) const {
    return dot(normal, direction) > 0.0;
  }
};

struct LightLoopSum {
  const Vec3& normal;
  std::vector<std::uint32_t> order;
  Rgb sum{};
  bool may_show(const IncomingLight&) const { return true; }
  void receive(const IncomingLight& light) {
    order.push_back(light.source->index);
    sum += light.colour * static_cast<float>(dot(normal, light.ray.direction));
  }
};

/// A point with what a block of points keeps of it.
struct LightLoopPoint {
  Vec3 place, normal;
  LightsAtPoint known;
  std::vector<IncomingLight> incoming;
  std::uint64_t key;
};

std::vector<LightLoopPoint> light_loop_points(std::size_t count, const Scene& scene) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> along(-8.0, 8.0), turn(-1.0, 1.0);
  std::vector<LightLoopPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place{along(random), -2.9, along(random)};
    const Vec3 normal = normalized({turn(random), 1.0, turn(random)});
    points.push_back({place, normal, LightsAtPoint(scene.lights().size()), {}, i});
  }
  return points;
}

void collect_light(const LightLoop& loop, const Scene& scene, LightLoopPoint& p) {
  p.incoming.resize(scene.lights().size());
  IncomingLight* const begin = p.incoming.data();
  IncomingLight* const end =
      loop.collect(p.place, {scene.global_lights()}, LightLoopFacing{p.normal}, begin);
  p.incoming.resize(static_cast<std::size_t>(end - begin));
}

TEST(UnitLightLoop, CollectsWhatMayReachAPointInTheListsOrder) {
  parser::test::SceneText text(
      "light_source { <0,9,0>, rgb <1,.5,.2> } light_source { <0,-9,0>, 1 }"
      "light_source { <5,9,0>, rgb .7 shadowless } light_source { <40,9,0>, 1 spotlight point_at "
      "<40,0,0> radius 5 falloff 8 } light_source { <0,8,6>, rgb 0 } light_source { <0,9,6>, rgb "
      "<.1,.2,.3> } sphere { <0,3,0>, 1 pigment { rgb 1 } }");
  const Scene scene(text.build(), {});
  ThreadContext context(scene, false);
  const auto tester = shadow::make_tester_factory("off")->make(context);
  const LightLoop loop(context, *tester, true);
  LightLoopPoint p{{0, 0, 0}, {0, 1, 0}, LightsAtPoint(scene.lights().size()), {}, 0};
  collect_light(loop, scene, p);
  ASSERT_EQ(p.incoming.size(), 3u) << "not those behind, beside the cone, or black";
  // The first stands behind the sphere.
  EXPECT_EQ(p.incoming[0].source->index, 0u);
  EXPECT_EQ(p.incoming[0].colour, Rgb(1.0f, 0.5f, 0.2f));
  EXPECT_EQ(p.incoming[0].ray.distance, 9.0);
  EXPECT_EQ(p.incoming[0].ray.direction, Vec3(0, 1, 0));
  EXPECT_EQ(p.incoming[1].source->index, 2u);
  EXPECT_EQ(p.incoming[2].source->index, 5u);
  EXPECT_EQ(p.incoming[2].colour, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(context.counters.lights[0].rays, 0u) << "nothing is asked";
}

TEST(UnitLightLoop, ShadowRaysOfManyPointsInAnyOrder) {
  parser::test::SceneText text(
      "light_source { <0,20,0>, rgb <.9,.8,.7> } light_source { <9,14,3>, .5 area_light 2*x, 2*z, "
      "5, 5 adaptive 1 jitter } light_source { <-9,9,3>, rgb <.2,.3,.9> spotlight point_at "
      "<0,-3,0> radius 20 falloff 40 } light_source { <3,15,-9>, .3 shadowless } light_source { "
      "<0,12,9>, .6 projected_through { disc { <0,9,7>, y, 3 } } } light_source { <-3,18,3>, .4 "
      "parallel point_at 0 fade_distance 9 fade_power 2 } plane { y, -3 pigment { rgb 1 } } "
      "#declare I = 0; #while (I < 40) sphere { <mod(I, 8)*2 - 7, mod(I, 3), I/4 - 5>, .6 "
      "pigment { rgbf <.9, .5, .7, (mod(I, 5) = 0)*.8> } } #declare I = I + 1; #end");
  const Scene scene(text.build(), {});
  for (const std::string_view name : shadow::tester_names()) {
    ThreadContext context(scene, false), other(scene, false);
    const auto factory = shadow::make_tester_factory(name);
    const auto one_by_one = factory->make(context), block = factory->make(other);
    LightLoop plain(context, *one_by_one, true), loop(other, *block, true);
    std::vector<LightLoopPoint> points = light_loop_points(500, scene);
    for (LightLoopPoint& p : points) collect_light(loop, scene, p);
    for (std::uint32_t light = static_cast<std::uint32_t>(scene.lights().size()); light-- > 0;) {
      for (auto p = points.rbegin(); p != points.rend(); ++p) {
        for (IncomingLight& incoming : p->incoming) {
          if (incoming.source->index != light) continue;
          ShadowQuery query = loop.query_at({p->place, 1, 1, InteriorsId::kOpen, p->key});
          loop.ask(incoming, query, p->known);
        }
      }
    }
    std::size_t lit = 0, shadowed = 0;
    for (LightLoopPoint& p : points) {
      LightLoopSum sum{p.normal, {}};
      for (const IncomingLight& incoming : p.incoming) LightLoop::resolve(incoming, sum);
      LightLoopSum want{p.normal, {}};
      plain.at({p.place, 1, 1, InteriorsId::kOpen, p.key}, {scene.global_lights()}, p.known,
               LightLoopFacing{p.normal}, want);
      ASSERT_EQ(sum.order, want.order) << name;
      ASSERT_EQ(std::bit_cast<std::uint32_t>(sum.sum.r), std::bit_cast<std::uint32_t>(want.sum.r));
      ASSERT_EQ(std::bit_cast<std::uint32_t>(sum.sum.g), std::bit_cast<std::uint32_t>(want.sum.g));
      ASSERT_EQ(std::bit_cast<std::uint32_t>(sum.sum.b), std::bit_cast<std::uint32_t>(want.sum.b));
      lit += sum.order.size();
      shadowed += p.incoming.size() - sum.order.size();
    }
    EXPECT_GT(lit, points.size()) << name;
    EXPECT_GT(shadowed, points.size() / 10) << name;
  }
}

}  // namespace
}  // namespace lentray::test
