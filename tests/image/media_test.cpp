// Media against stock. What has no random numbers is stock's to the last digits; the rest is compared
// by means over blocks of pixels.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

const std::string kHead = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,1.2,-6> look_at <0,.4,0> angle 45 }
plane { y, -1 hollow pigment { checker rgb .8 rgb <.3,.4,.7> } finish { ambient .2 diffuse .6 } }
)";
const std::string kLight = "light_source { <3,5,-4>, 1.5 }\n";
const std::string kBall =
    "pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow interior { media { ";

std::string ball(const std::string& media) {
  return kHead + kLight + "sphere { 0, 1.3 " + kBall + media + " } } }\n";
}
std::string air(const std::string& media, const std::string& lights = kLight) {
  return kHead + lights + "sphere { <.8,0,1>, .8 pigment { rgb <.9,.4,.2> } }\nmedia { " + media +
         " }\n";
}

const std::string kDensity = "density { spherical color_map { [0 rgb 0] [1 rgb <1,.8,.5>] } }";

class ImageMedia : public ::testing::TestWithParam<std::pair<const char*, std::string>> {};

TEST_P(ImageMedia, IsStocks) {
  EXPECT_TRUE(same_as_stock({.sdl = GetParam().second,
                             .width = 80,
                             .height = 60,
                             .arguments = {},
                             .bits = 16,
                             .files = {}}));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageMedia,
    ::testing::Values(
        std::pair("absorption", ball("absorption <.3,.6,1>")),
        std::pair("emission", ball("emission <.3,.2,.1>")),
        std::pair("scattering", ball("scattering { 1, <.3,.5,.6> }")),
        std::pair("hazy", ball("scattering { 2, <.3,.5,.6> extinction .5 }")),
        std::pair("murky", ball("scattering { 3, <.3,.5,.6> }")),
        std::pair("rayleigh", ball("scattering { 4, <.3,.5,.6> }")),
        std::pair("henyey_greenstein", ball("scattering { 5, <.3,.5,.6> eccentricity .6 }")),
        std::pair("density", ball("emission .5 absorption .4 samples 20 " + kDensity)),
        std::pair("two_densities",
                  ball("emission .5 " + kDensity + " density { granite scale 2 }")),
        std::pair("levels", ball("emission 1.5 samples 4 aa_level 6 aa_threshold .01 " + kDensity)),
        std::pair("intervals", ball("emission .5 scattering { 1, .4 } intervals 5 samples 3")),
        std::pair("even", ball("method 2 emission .5 samples 7, 7 intervals 3 " + kDensity)),
        std::pair("two_media", ball("emission .3 absorption .2 } media { scattering { 5, .5 "
                                    "eccentricity -.4 } intervals 4")),
        std::pair("air", air("scattering { 1, <.03,.05,.06> } samples 12")),
        std::pair("air_absorbs", air("absorption <.03,.05,.1>")),
        std::pair("spot", air("scattering { 1, .1 } intervals 7 samples 5",
                              "light_source { <-2,4,-1>, 2 spotlight point_at <.5,-1,1> radius 10 "
                              "falloff 20 }\n")),
        std::pair("cylinder", air("scattering { 1, .1 } intervals 9 ratio .7",
                                  "light_source { <-2,4,-1>, 2 cylinder point_at <.5,-1,1> radius "
                                  ".4 falloff .6 }\n")),
        std::pair("two_spots",
                  air("scattering { 4, .1 } intervals 6",
                      "light_source { <-2,4,-1>, 2 spotlight point_at <.5,-1,1> falloff 20 }\n"
                      "light_source { <3,3,1>, <1,.5,.2> spotlight point_at <.5,-1,1> falloff 15 "
                      "}\n")),
        std::pair("not_interacting",
                  air("scattering { 1, .1 }",
                      kLight + "light_source { <-5,5,0>, 1 media_interaction off }\n")),
        std::pair("fill_light", air("scattering { 1, .1 }",
                                    kLight + "light_source { <-5,5,0>, 1 shadowless }\n")),
        std::pair("attenuation", air("absorption <.03,.05,.1>",
                                     "light_source { <3,5,-4>, 3 media_attenuation on }\n") +
                                     "sphere { <-1.4,1,-1>, .7 pigment { rgbf <1,.8,.4,.8> } }\n"),
        std::pair("fog_attenuation",
                  kHead + "light_source { <3,5,-4>, 3 media_attenuation on }\n"
                          "sphere { <-1.4,1,-1>, .7 hollow pigment { rgbf <1,.8,.4,.8> } }\n"
                          "fog { distance 9 rgb <.4,.5,.6> }\n"),
        std::pair("shadow", kHead + kLight + "sphere { <.5,1,0>, .9 " + kBall +
                                "absorption <.3,.9,2> } } }\n"),
        std::pair("shadow_density", kHead + kLight + "sphere { <.5,1,0>, .9 " + kBall +
                                        "absorption <.3,.9,2> density { gradient y "
                                        "color_map { [0 rgb 0] [1 rgb 2] } } } } }\n"),
        std::pair("nested", kHead + kLight + "sphere { 0, 1.3 " + kBall +
                                "emission <.2,.1,0> } } }\n" + "sphere { <.2,.1,0>, .6 " + kBall +
                                "absorption <0,.5,1> } } }\n"),
        std::pair("not_hollow", air("scattering { 1, .1 }") +
                                    "sphere { <-1,.5,-1>, .9 pigment { rgbt .9 } }\n"
                                    "sphere { <-1,.5,-3>, .4 hollow pigment { rgbt .9 } }\n"),
        std::pair("camera_inside", kHead + kLight + "sphere { <0,1,-6>, 4 " + kBall +
                                       "emission <.02,.05,.1> absorption .1 } } }\n"),
        std::pair("light_group", kHead + kLight +
                                     "light_group { light_source { <-3,2,-3>, "
                                     "<1,.2,0> } sphere { 0, 1.3 " +
                                     kBall + "scattering { 1, .4 } } } } global_lights off }\n"),
        std::pair("rainbow",
                  air("scattering { 1, .02 }") +
                      "rainbow { direction z-.2*y angle 30 width 12 distance 20 "
                      "color_map { [0 rgbt <.6,.2,.9,.9>] [1 rgbft <.9,.2,.1,.3,.8>] } }\n"
                      "fog { distance 50 rgb .5 }\n"),
        std::pair("mirror",
                  air("scattering { 1, <.05,.1,.2> }") +
                      "sphere { <-1.2,0,0>, .9 pigment { rgb .1 } finish { reflection .8 } "
                      "}\n")),
    [](const auto& one) { return one.param.first; });

TEST(ImageMediaQuality, TheyAreLeftOutBelowNine) {
  const std::string sdl = air("scattering { 1, .1 }") + "sphere { <-1,1,0>, .8 " + kBall +
                          "absorption <.3,.6,1> } } }\n";
  for (const char* quality : {"+Q8", "+Q9"}) {
    EXPECT_TRUE(same_as_stock(
        {.sdl = sdl, .width = 60, .height = 45, .arguments = {quality}, .files = {}}));
  }
}

/// Samples just outside a wall, nearer than the distance from which blockers count for surfaces.
TEST(ImageMediaWalls, LetNoLightThrough) {
  const StoredImage seen =
      lentray_render({.sdl = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { orthographic location <0,0,-.6> direction z right 1*x up 1*y }
light_source { 0, 1 }
box { <-.6,-.6,-.5>, <.6,.6,.6> hollow pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
media { scattering { 1, 5 extinction 0 } method 1 intervals 1 samples 400,400 }
)",
                      .width = 24,
                      .height = 18,
                      .arguments = {},
                      .bits = 16,
                      .files = {}});
  for (std::uint32_t row = 0; row < seen.height; ++row) {
    for (std::uint32_t column = 0; column < seen.width; ++column) {
      ASSERT_EQ(seen.samples[seen.place(column, row, 0)], 0) << column << " " << row;
    }
  }
}

/// What is random has a warning, and means over blocks of pixels like stock's.
TEST(ImageMediaNoise, IsStocksInTheMean) {
  const SceneText scene{
      .sdl = ball("method 1 intervals 6 samples 4 scattering { 1, <.3,.5,.6> } "
                  "density { bozo scale .3 color_map { [.3 rgb 0] [.7 rgb 2] } }"),
      .width = 96,
      .height = 64,
      .arguments = {},
      .files = {}};
  const StoredImage ours = lentray_render(scene), stock = stock_render(scene);
  EXPECT_GT(core::compare(ours, stock, core::Columns::all(ours.width)).beyond_1, 100u);  // noise
  constexpr std::uint32_t kBlock = 16;
  for (std::uint32_t y = 0; y < scene.height; y += kBlock) {
    for (std::uint32_t x = 0; x < scene.width; x += kBlock) {
      double a = 0.0, b = 0.0;
      for (std::uint32_t j = y; j < y + kBlock; ++j) {
        for (std::uint32_t i = x; i < x + kBlock; ++i) {
          a += ours.samples[ours.place(i, j, 0)];
          b += stock.samples[stock.place(i, j, 0)];
        }
      }
      EXPECT_NEAR(a / (kBlock * kBlock), b / (kBlock * kBlock), 2.5) << x << " " << y;
    }
  }
}

/// A sheet is sampled by rays whose way no camera of stock's own has; its views have one.
class ImageMediaSheets : public ::testing::TestWithParam<std::string> {};

TEST_P(ImageMediaSheets, AreStocks) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "media.pov", GetParam());
  const tool::RunResult result = run_diff({(folder / "media.pov").string(), "Lenticular=On",
                                           "Lens_Pixels=6", "+W120", "+H60", "--grade", "match"},
                                          folder.path());
  EXPECT_EQ(result.status, 0) << result.output;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ImageMediaSheets,
    ::testing::Values(ball("emission .5 absorption .4 samples 20 " + kDensity),
                      air("scattering { 1, <.03,.05,.06> } samples 12"),
                      ball("scattering { 5, <.3,.5,.6> eccentricity .4 } intervals 3")));

}  // namespace
}  // namespace lentray::test
