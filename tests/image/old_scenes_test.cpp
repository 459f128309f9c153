// What old scenes depend on: colour maps that layers share with other textures until #version 3.1, and
// noise_generator said again in a copy. References are rendered live by stock POV-Ray.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

std::string world(const std::string& version, const std::string& objects) {
  return "#version " + version +
         ";\n"
         "#declare Bands = color_map { [0 rgbf <.3, .7, .9, .8>] [.5 rgbf <.9, .4, .3, .5>]\n"
         "  [1 rgbft <.8, .9, .2, .6, .2>] }\n"
         "#declare Base = texture { pigment { rgb <.7, .6, .3> } }\n"
         "#declare Glaze = texture { pigment { gradient y color_map { Bands } scale .6 } }\n"
         "camera { location <.2, 1.1, -6.3> look_at <0, .1, 0> angle 42 }\n"
         "light_source { <-5, 7, -6> rgb 1 }\nbackground { rgb <.4, .8, .6> }\n" +
         objects;
}
const std::string kCoated = "sphere { <-1.1, .2, 0>, .95 texture { Base } texture { Glaze } }\n";
const std::string kPane = "box { <.2, -.8, 0>, <1.9, 1.1, .12> texture { Glaze } }\n";

struct OldScene {
  std::string name, version, objects;
};

class ImageOldScenes : public ::testing::TestWithParam<OldScene> {};

TEST_P(ImageOldScenes, AsStock) {
  const auto& [name, version, objects] = GetParam();
  EXPECT_TRUE(same_as_stock({.sdl = world(version, objects)}, Grade::exact)) << objects;
}

const std::vector<OldScene> kSharedMaps = {
    {"CoatThenPane", "3.1", kCoated + kPane},
    {"PaneThenCoat", "3.1", kPane + kCoated},
    {"ScaledCopy", "3.0",
     kCoated + "box { <.2, -.8, 0>, <1.9, 1.1, .12> texture { Glaze scale .5 rotate 30*z } }\n"},
    {"OnlyTheMap", "3.1",
     kCoated + "box { <.2, -.8, 0>, <1.9, 1.1, .12> pigment { bozo color_map { Bands } } }\n"},
    {"PigmentMap", "3.1",
     "#declare Mixed = pigment { gradient x pigment_map { [.3 rgbf <.9, .5, .4, .7>]\n"
     "  [.7 bozo color_map { Bands } scale .2] } }\n"
     "sphere { <-1.1, .2, 0>, .95 texture { Base } texture { pigment { Mixed } } }\n"
     "box { <.2, -.8, 0>, <1.9, 1.1, .12> pigment { Mixed rotate 90*z } }\n"},
    {"DeclaredLayers", "3.1",
     "#declare Both = texture { Base } texture { Glaze }\n" + kPane +
         "sphere { <-1.1, .2, 0>, .95 texture { Both } }\n"},
    {"PlainColour", "3.1",
     "#declare Clear = texture { pigment { rgbf <.9, .5, .4, .7> } }\n"
     "sphere { <-1.1, .2, 0>, .95 texture { Base } texture { Clear } }\n"
     "box { <.2, -.8, 0>, <1.9, 1.1, .12> texture { Clear } }\n"},
    {"Checker", "3.1",
     "#declare Tiles = texture { pigment { checker rgbf <.9, .5, .4, .7>, rgbf <.3, .6, .9, .6>\n"
     "  scale .4 } }\nsphere { <-1.1, .2, 0>, .95 texture { Base } texture { Tiles } }\n"
     "box { <.2, -.8, 0>, <1.9, 1.1, .12> texture { Tiles } }\n"},
    {"MapChangedAfterwards", "3.1",
     kCoated +
         "#declare Bands = color_map { [0 rgbf <.3, .7, .9, .8>] [1 rgbf <.9, .4, .3, .5>] }\n"
         "box { <.2, -.8, 0>, <1.9, 1.1, .12> pigment { gradient y color_map { Bands } } }\n"},
    {"PaneAlone", "3.1", kPane},
    {"NewerScene", "3.5", kCoated + kPane},
    {"VersionRaisedForThePane", "3.1", kCoated + "#version 3.5;\n" + kPane},
    {"VersionRaisedForTheCoat", "3.1", "#version 3.5;\n" + kCoated + "#version 3.1;\n" + kPane}};

const std::string kBalls[2] = {"sphere { <-1.1, .2, 0>, 1 pigment { ",
                               "sphere { <1.1, .2, 0>, 1 pigment { "};
OldScene noise(const std::string& name, const std::string& declared, const std::string& first,
               const std::string& second) {
  return {name, "3.7",
          "#declare Grain = pigment { " + declared + " color_map { [0 rgb .1] [1 rgb 1] } }\n" +
              kBalls[0] + first + " } }\n" + kBalls[1] + second + " } }\n"};
}
const std::vector<OldScene> kNoises = {
    noise("OneThenTwo", "bozo noise_generator 1", "Grain scale .4 noise_generator 2",
          "Grain scale .4"),
    noise("TwoThenOne", "granite noise_generator 2", "Grain noise_generator 1", "Grain"),
    noise("ThreeThenOne", "wrinkles noise_generator 3", "Grain noise_generator 1",
          "Grain noise_generator 2"),
    noise("WithinOneStatement", "bozo noise_generator 1 scale .3 noise_generator 2", "Grain",
          "Grain noise_generator 0"),
    noise("TurbulenceOfAWarp", "marble turbulence .6 noise_generator 2",
          "Grain noise_generator 1 scale .5", "Grain scale .5"),
    noise("TheSameAgain", "bozo noise_generator 1", "Grain noise_generator 1 scale .4",
          "Grain scale .4"),
    noise("OnlyInTheCopy", "bozo", "Grain noise_generator 1 scale .4",
          "Grain noise_generator 3 scale .4")};

const auto kNameOf = [](const auto& one) { return one.param.name; };
INSTANTIATE_TEST_SUITE_P(SharedMaps, ImageOldScenes, ::testing::ValuesIn(kSharedMaps), kNameOf);
INSTANTIATE_TEST_SUITE_P(Noises, ImageOldScenes, ::testing::ValuesIn(kNoises), kNameOf);

}  // namespace
}  // namespace lentray::test
