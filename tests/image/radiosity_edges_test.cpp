// Radiosity beside stock where samples are easily wrong: corners, thin walls, other scales, lights on
// surfaces, and air that dims light.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// `size`: of the scene, whose parts and places grow with it.
std::string hall(const std::string& settings, const std::string& more, const char* size) {
  return std::string("#version 3.7;\n#declare Size = ") + size +
         ";\nglobal_settings { assumed_gamma 1 radiosity { " + settings + R"( } }
camera { location <0, 1.2, -4.5> * Size look_at <0, 0.9, 0> * Size angle 50 }
light_source { <1.5, 3, -2> * Size rgb 0.6 }
background { rgb <0.3, 0.4, 0.6> }
#default { finish { diffuse 0.7 } }
union {
  plane { y, 0 pigment { rgb <0.8, 0.8, 0.7> } }
  plane { -z, -2 pigment { rgb <0.7, 0.3, 0.2> } }
  box { <-2.2, 0, -1>, <-1.9, 1.8, 2> pigment { rgb <0.2, 0.7, 0.3> } }
  sphere { <0.2, 0.5, 0.3>, 0.5 pigment { rgb 0.9 } }
  sphere { <1.5, 0.6, 1>, 0.4 pigment { rgb <1, 0.8, 0.4> } finish { emission 2 diffuse 0 } }
  scale Size
}
)" + more;
}

struct Edge {
  const char* name;
  const char* more = "";
  const char* settings = "";
  const char* size = "1";
};
std::ostream& operator<<(std::ostream& out, const Edge& edge) { return out << edge.name; }

class ImageRadiosityEdges : public ::testing::TestWithParam<Edge> {};

TEST_P(ImageRadiosityEdges, IsStocks) {
  const Edge& edge = GetParam();
  SceneText scene;
  scene.sdl = hall(std::string("count 40 error_bound 0.6 recursion_limit 2 ") + edge.settings,
                   edge.more, edge.size);
  scene.width = 80;
  scene.height = 60;
  EXPECT_TRUE(same_as_stock(scene, Grade::exact));
}

constexpr const char* kFog = "fog { distance 6 rgb <0.5, 0.5, 0.6> }";
constexpr const char* kDimAir = "media { absorption 0.15 method 3 samples 8 }";
constexpr const char* kFogInTheWay =
    "fog { distance 6 rgb <0.5, 0.5, 0.6> } light_source { <-1, 2, -2> rgb 0.5 media_attenuation "
    "on }";
constexpr const char* kDimBall =
    "sphere { <-0.8, 0.8, -0.7>, 0.6 pigment { rgbt 1 } "
    "interior { media { absorption <0.5, 1, 2> } } hollow }";

INSTANTIATE_TEST_SUITE_P(
    Each, ImageRadiosityEdges,
    ::testing::Values(
        Edge{"Corners", "box { <-1.9, 0, 1.4>, <-1, 0.8, 2> pigment { rgb 0.8 } }",
             "error_bound 0.3"},
        Edge{"ThinWalls",
             "box { <-1.5, 0, -0.4>, <-0.6, 1.2, -0.398> pigment { rgb <0.9, 0.2, 0.2> } }"
             "box { <-1.5, 0, -0.39>, <-1.498, 1.2, 0.6> pigment { rgb 0.8 } }"},
        Edge{"Small", "", "", "0.01"}, Edge{"Large", "", "", "100"},
        Edge{"VeryLarge", "", "", "1e4"},
        Edge{"LightsOnSurfaces",
             "light_source { <-1.899, 1, 0> rgb 0.3 } light_source { <0.5, 0, -0.6> rgb 0.3 }"},
        Edge{"Fog", kFog}, Edge{"FogGathered", kFog, "media on"}, Edge{"DimAir", kDimAir},
        Edge{"DimAirGathered", kDimAir, "media on"},
        Edge{"BrightAir", "media { scattering { 1, 0.06 } method 3 samples 8 }"},
        Edge{"DimBall", kDimBall}, Edge{"FogInTheWay", kFogInTheWay},
        Edge{"FogInTheWayGathered", kFogInTheWay, "media on"},
        Edge{"DimBallGathered", kDimBall, "media on"},
        Edge{"DimGlass",
             "sphere { <-0.8, 0.8, -0.7>, 0.6 pigment { rgbt 1 } "
             "interior { fade_distance 0.3 fade_power 2 fade_color <0.3, 0.8, 0.3> } }"},
        Edge{"Quality", "", "pretrace_start 1 pretrace_end 1"},
        Edge{"ColoursAndBrightness", "", "gray_threshold 0.7 brightness 1.4"}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
