// Where rays stop: max_trace_level and adc_bailout, and what is behind everything.
#include "tests/image/shading_scenes.h"

using namespace lentray::test;

namespace {

const char* kMirrors =
    "box { <-3, 0, 1.5>, <3, 3, 1.6> pigment { rgb <0.9, 0.9, 1> }"
    " finish { ambient 0.05 diffuse 0.1 reflection 0.8 } }"
    "box { <-3, 0, -7.6>, <3, 4, -7.5> pigment { rgb <1, 0.9, 0.9> }"
    " finish { ambient 0.05 diffuse 0.1 reflection 0.8 } }"
    "sphere { <0, 1, 0>, 0.8 pigment { rgb 0.3 } finish { reflection 0.6 } }"
    "background { rgb <0.3, 0.5, 0.8> }";

SceneText mirrors(const std::string& settings) {
  return staged(kMirrors, "light_source { <-2, 9, -3> rgb 1 }", settings);
}

TEST(ImageShadingDepth, MaxTraceLevel) {
  for (const char* level : {"1", "2", "3", "5", "8"}) {
    EXPECT_TRUE(same_as_stock(mirrors(std::string("max_trace_level ") + level))) << level;
  }
}

TEST(ImageShadingDepth, AdcBailout) {
  for (const char* bailout : {"0.5", "0.3", "0.05", "0"}) {
    EXPECT_TRUE(same_as_stock(mirrors(std::string("max_trace_level 12 adc_bailout ") + bailout)))
        << bailout;
  }
}

TEST(ImageShadingDepth, StraightTransmissionCostsNoLevel) {
  std::string panes;
  for (int i = 0; i < 6; ++i) {
    panes += "box { <-0.5, 0, " + std::to_string(i) + ".0>, <" + std::to_string(0.2 * i + 0.2) +
             ", 2, " + std::to_string(i) + ".2> pigment { rgbf <0.9, 1, 0.9, 0.95> } }";
  }
  EXPECT_TRUE(same_as_stock(staged(panes + "background { rgb <0.3, 0.5, 0.8> }",
                                   "light_source { <-2, 9, -3> rgb 1 }", "max_trace_level 3")));
}

TEST(ImageShadingDepth, GlassWithFewLevels) {
  for (const char* level : {"1", "2", "3", "4"}) {
    EXPECT_TRUE(same_as_stock(
        staged("sphere { <0, 1, 0>, 0.9 pigment { rgbt <1, 1, 1, 0.9> } finish { reflection 0.1 }"
               " interior { ior 1.5 } } background { rgb <0.3, 0.5, 0.8> }",
               "light_source { <-2, 9, -3> rgb 1 }", std::string("max_trace_level ") + level)))
        << level;
  }
}

/// A floor through the bottom of what stands on it, whichever is written first.
TEST(ImageShadingDepth, InfiniteObjectsWinWhereSurfacesCoincide) {
  const std::string box = "box { <-1.5, -1, -1>, <1.5, 0, 1> pigment { rgb <0, 0, 1> } }";
  const std::string floor = "plane { y, 0 pigment { rgb <0.3, 0.8, 0.3> } }";
  for (const std::string& more : {box + floor, floor + box}) {
    SceneText scene = staged(more);
    const std::size_t own = scene.sdl.find("plane { y, 0 pigment { checker");
    scene.sdl.insert(own, "#if (0) ");
    scene.sdl.insert(scene.sdl.find("diffuse 0.7 } }") + 15, " #end");
    EXPECT_TRUE(same_as_stock(scene));
  }
}

TEST(ImageShadingSky, Background) { EXPECT_TRUE(same_as_stock(finished("reflection 0.5"))); }

TEST(ImageShadingSky, SkySphere) {
  EXPECT_TRUE(same_as_stock(staged(
      "sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.7>][1 rgb <0.1, 0.3, "
      "0.9>] } } }"
      "sphere { <0, 1, 0>, 0.9 pigment { rgb 0.2 } finish { reflection 0.6 } }")));
}

TEST(ImageShadingSky, SkySphereOfTwoLayersTurnedAndDimmed) {
  const std::string sky =
      "background { rgb <0.5, 0.1, 0.1> } sky_sphere {"
      " pigment { gradient y color_map { [0 rgbt <0.9, 0.8, 0.7, 0.3>][1 rgb <0.1, 0.3, 0.9>] } }"
      " pigment { checker rgbt <1, 1, 1, 1> rgbf <0.4, 1, 0.4, 0.7> scale 0.2 rotate 30*z }"
      " rotate <20, 10, 5> emission 0.8 }";
  EXPECT_TRUE(same_as_stock(staged(sky)));
  SceneText old = staged(sky);
  old.sdl.replace(0, std::string("#version 3.7;").size(), "#version 3.6;");
  EXPECT_TRUE(same_as_stock(old));
}

}  // namespace
