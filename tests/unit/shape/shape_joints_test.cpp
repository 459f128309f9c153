// Where pieces of a shape join, rays neither pass between them nor meet what is not there.
#include <cmath>

#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

/// How far a ray goes to the only object of a scene; less than 0 if it misses.
double distance_to(const core::Object& object, const core::Ray& ray) {
  core::Hit hit;
  core::HitLists lists;
  return object.nearest(ray, 1e-6, core::Bounds::kInf, hit, {lists, core::RayKind::kShadow}) ? hit.t
                                                                                             : -1.0;
}

TEST(UnitShapeJoints, RaysDoNotPassBetweenThePiecesOfALathe) {
  SceneText text("lathe { cubic_spline 7 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9>,<.2,1> }");
  const core::SceneParts parts = text.build();
  constexpr int kAround = 2000;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2.0 * M_PI * i / kAround;
    const double x = i == 0 ? -0.8 : std::cos(angle), z = i == 0 ? -0.6 : std::sin(angle);
    const auto down = [&](double r) {
      return distance_to(*parts.objects[0], {{x * r, 5, z * r}, {0, -1, 0}});
    };
    ASSERT_GT(down(1.0), 0.0) << i;
    ASSERT_NEAR(down(1.0), down(1.0 - 1e-7), 1e-5) << i;
  }
}

TEST(UnitShapeJoints, RaysHardlyTurnedFromTheAxisMeetWhatThoseAlongItMeet) {
  for (const char* sdl :
       {"sor { 7 <0,-1>,<.5,-.9>,<.9,-.3>,<.3,.2>,<.6,.8>,<.2,1>,<0,1.1> }",
        "lathe { cubic_spline 7 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9>,<.2,1> }"}) {
    SceneText text(sdl);
    const core::SceneParts parts = text.build();
    for (const double tilt : {1e-12, 1e-9, 1e-7}) {
      int different = 0;
      for (int i = 0; i < 900; ++i) {
        const double x = (i % 30 - 14.7) * 0.09, z = (i / 30 - 14.2) * 0.09;
        const double along = distance_to(*parts.objects[0], {{x, 5, z}, {0, -1, 0}});
        const double turned = distance_to(*parts.objects[0], {{x, 5, z}, {tilt, -1, -tilt}});
        different += std::fabs(along - turned) > 1e-4;
      }
      EXPECT_EQ(different, 0) << sdl << ", turned by " << tilt;
    }
  }
}

TEST(UnitShapeJoints, LevelRaysPassALatheThatIsWiderElsewhere) {
  SceneText text("lathe { linear_spline 3 <.2,-1>, <1,0>, <.2,1> }");
  const core::SceneParts parts = text.build();
  for (const double y : {-0.9, -0.5, 0.5, 0.9}) {
    const double r = 1.0 - 0.8 * std::fabs(y);
    for (const auto& [x, meets] : {std::pair{r - 1e-6, true}, {r + 1e-6, false}, {0.99, false}}) {
      EXPECT_EQ(distance_to(*parts.objects[0], {{x, y, -5}, {0, 0, 1}}) > 0.0, meets)
          << x << ' ' << y;
      EXPECT_EQ(distance_to(*parts.objects[0], {{-5, y, x}, {1, 0, 0}}) > 0.0, meets)
          << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace lentray::parser::test
