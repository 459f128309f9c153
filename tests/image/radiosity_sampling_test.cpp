// Radiosity with several rays a pixel: those beside its centre see all samples, where stock's see those before
// them, so pictures are held to stock's own noise (core/image/compare.h).
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "tests/support/render.h"
#include "tests/support/stock_noise.h"

namespace lentray::test {
namespace {

struct ManyRays {
  const char* name;
  std::vector<std::string> options;
  const char* camera = "";
  const char* settings = "";
};
std::ostream& operator<<(std::ostream& out, const ManyRays& one) { return out << one.name; }

std::string porch(const ManyRays& one) {
  return std::string("#version 3.7; global_settings { assumed_gamma 1 radiosity { count 40 ") +
         "error_bound 0.6 recursion_limit 2 " + one.settings + R"( } }
camera { location <0, 1.2, -4.5> look_at <0, 0.9, 0> angle 50 )" +
         one.camera + R"( }
light_source { <1.5, 3, -2> rgb 0.6 }
background { rgb <0.3, 0.4, 0.6> }
#default { finish { diffuse 0.7 } }
plane { y, 0 pigment { rgb <0.8, 0.8, 0.7> } }
plane { -z, -2 pigment { rgb <0.7, 0.3, 0.2> } }
box { <-2.2, 0, -1>, <-1.9, 1.8, 2> pigment { rgb <0.2, 0.7, 0.3> } }
box { <0.9, 0, -1.2>, <1.5, 0.3, -0.6> pigment { checker rgb 0.9 rgb <0.2, 0.2, 0.8> scale 0.1 } }
sphere { <0.2, 0.5, 0.3>, 0.5 pigment { rgb 0.9 } }
sphere { <1.5, 0.6, 1>, 0.4 pigment { rgb <1, 0.8, 0.4> } finish { emission 2 diffuse 0 } }
)";
}

class ImageRadiosityManyRays : public ::testing::TestWithParam<ManyRays> {};

TEST_P(ImageRadiosityManyRays, AreWithinStocksNoise) {
  SceneText scene;  // of 80 x 60 pixels
  scene.sdl = porch(GetParam());
  scene.arguments = GetParam().options;
  EXPECT_TRUE(within_stocks_noise(scene));
}

constexpr const char* kAperture = "aperture 0.1 focal_point <0.2, 0.5, 0> blur_samples 40";

INSTANTIATE_TEST_SUITE_P(
    Each, ImageRadiosityManyRays,
    ::testing::Values(ManyRays{"Antialiased", {"+A0.1", "+R2", "-J"}},
                      ManyRays{"AntialiasedInSteps", {"+A0.1", "+AM2", "+R2", "-J"}},
                      ManyRays{"Blurred", {"-A"}, kAperture},
                      ManyRays{"AlwaysSampling", {"+A0.1", "+R2", "-J"}, "", "always_sample on"}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
