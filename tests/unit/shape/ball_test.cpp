// The balls of shapes and of CSG: what they turn away surely misses, and they hold all that rays
// meet once nothing but the surfaces themselves is asked.
#include <random>

#include "tests/unit/parser/scene_text.h"
#include "tests/unit/shape/plain_shapes.h"
#include "tests/unit/shape/shape_cases.h"

namespace lentray::parser::test {
namespace {

using core::Ball;
using core::Bounds;
using core::Ray;

class Rays {
 public:
  Vec3 point(double reach) {
    return Vec3{m_even(m_random), m_even(m_random), m_even(m_random)} * reach;
  }
  Ray between(const Vec3& a, const Vec3& b) { return {a, normalized(b - a)}; }

 private:
  std::mt19937 m_random{11};
  std::uniform_real_distribution<double> m_even{-1.0, 1.0};
};

TEST(UnitBall, TurnsAwayWhatMissesAndNothingElse) {
  Rays rays;
  const Vec3 centre{3.0, -2.0, 5.0};
  const double radius = 0.7;
  const Ball ball(centre, radius);
  int missed = 0, met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 through = centre + rays.point(1.2),
               from = centre + rays.point(i % 2 == 0 ? 3.0 : 3e4);
    const Ray ray = rays.between(from, through);
    const Vec3 to = centre - ray.origin;
    const double t = dot(to, ray.direction) / dot(ray.direction, ray.direction);
    const double distance = length(ray.at(t) - centre);
    if (i % 2 == 0 && distance > radius * 1.001) {
      EXPECT_TRUE(ball.is_missed_by(ray)) << distance;
    }
    if (distance < radius) {
      EXPECT_FALSE(ball.is_missed_by(ray)) << distance;
    }
    ++(distance < radius ? met : missed);
  }
  EXPECT_GT(missed, 3000);
  EXPECT_GT(met, 3000);
}

TEST(UnitBall, CutsALineToWhatIsInIt) {
  Rays rays;
  const Vec3 centre{3.0, -2.0, 5.0};
  const double radius = 0.7;
  const Ball ball(centre, radius);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 through = centre + rays.point(1.2),
               from = centre + rays.point(i % 2 == 0 ? 3.0 : 3e4);
    const Ray ray{from, (through - from) * 0.37};
    double lo = -Bounds::kInf, hi = Bounds::kInf;
    const bool is_met = ball.cut(ray, lo, hi);
    if (length(through - centre) < radius) {
      ASSERT_TRUE(is_met);
    }
    if (!is_met) continue;
    ++met;
    for (const double t : {lo, hi})
      EXPECT_NEAR(length(ray.at(t) - centre), radius, i % 2 == 0 ? 1e-4 : 2e-2);
    const double t = 1.0 / 0.37;
    EXPECT_EQ(t > lo && t < hi, length(through - centre) < ball.radius())
        << length(through - centre);
  }
  EXPECT_GT(met, 3000);
}

TEST(UnitBall, OfNothingAndOfAllTurnsNothingAway) {
  const Ray ray{{0, 0, -5}, {1, 0, 0}};
  EXPECT_FALSE(Ball().is_missed_by(ray));
  EXPECT_FALSE(Ball::around(Bounds()).is_missed_by(ray));
  EXPECT_FALSE(Ball::around(Bounds::everything()).is_missed_by(ray));
  EXPECT_TRUE(Ball({0, 0, 0}, 4.9).is_missed_by(ray));
  EXPECT_FALSE(Ball({0, 0, 0}, 5.0).is_missed_by(ray));
}

TEST(UnitBall, OfImagesHoldsTheImage) {
  const core::Transform place = core::Transform::scaling({2.0, 0.5, 1.5})
                                    .then(core::Transform::rotation({20, 50, 70}))
                                    .then(core::Transform::translation({4, 5, 6}));
  const core::Matrix shear = {{{1, .4, 0}, {0, 1, .7}, {.2, 0, 1}, {1, 2, 3}}};
  Rays rays;
  for (const core::Transform& t : {place, core::Transform::matrix(shear)}) {
    const Bounds box{{-1, -2, 0}, {3, 1, .5}};
    const Ball around_box = ball_around(box, t), of_ball = transformed(Ball({1, 2, 3}, 2.0), t);
    for (int i = 0; i < 5000; ++i) {
      const Vec3 p = rays.point(1.0);
      const Vec3 in_box = box.centre() + scaled(p, (box.hi - box.lo) * 0.5);
      EXPECT_LE(length(t.point(in_box) - around_box.centre()), around_box.radius());
      const Vec3 on_ball = Vec3{1, 2, 3} + normalized(p) * 2.0;
      EXPECT_LE(length(t.point(on_ball) - of_ball.centre()), of_ball.radius());
    }
  }
}

class UnitBallOfShape : public ::testing::TestWithParam<ShapeCase> {};

/// Alone, cut, and in CSG: rays through and past it meet nothing outside the ball.
TEST_P(UnitBallOfShape, HoldsAllThatIsMet) {
  const std::string one = std::string("object { ") + GetParam().sdl;
  const std::string placed = " rotate <30, 40, 50> scale <1, .6, 1.3> translate <2, 1, -3> }";
  const std::string cutter = " sphere { .3, .8 } }";
  for (const std::string& sdl :
       {one + " }", one + placed, "difference { " + one + " }" + cutter,
        "difference { sphere { .3, .8 } " + one + " } }", "intersection { " + one + " }" + cutter,
        "merge { " + one + " }" + cutter, one + " clipped_by { sphere { .2, .7 } } }",
        one + " bounded_by { sphere { .2, .7 } } }"}) {
    SceneText text(sdl, with_fonts());
    const core::SceneParts parts = text.build();
    ASSERT_EQ(parts.objects.size(), 1u) << sdl;
    core::Object& object = *parts.objects[0];
    const Ball ball = object.ball(), solid = object.solid_ball();
    const Bounds box = object.bounds();
    if (!box.is_finite() || !ball.is_finite()) continue;
    const core::PlainObject plain(object);
    const Vec3 middle = box.centre();
    const double reach = length(box.hi - box.lo);
    Rays rays;
    core::HitLists lists;
    std::vector<core::Hit> found;
    for (int i = 0; i < 1500; ++i) {
      const Ray ray =
          rays.between(middle + rays.point(2.0 * reach), middle + rays.point(0.6 * reach));
      found.clear();
      plain.all(ray, 1e-6, Bounds::kInf, found, {lists, core::RayKind::kShadow});
      for (const core::Hit& hit : found) {
        EXPECT_FALSE(ball.is_missed_by(ray)) << sdl;
        // What extends beyond bounded_by is met by rays that pass through that, and a parametric's
        // search may end far along its ray.
        if (dynamic_cast<const core::Gated*>(&object) ||
            GetParam().name == std::string_view("parametric"))
          continue;
        EXPECT_LE(length(ray.at(hit.t) - ball.centre()), ball.radius()) << sdl;
      }
      const Vec3 p = middle + rays.point(reach);
      if (solid.is_finite() && plain.inside(p)) {
        EXPECT_LE(length(p - solid.centre()), solid.radius()) << sdl;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, UnitBallOfShape, ::testing::ValuesIn(kShapeCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::parser::test
