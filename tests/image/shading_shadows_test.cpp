// Shadows that are coloured, and objects that throw none.
#include "tests/image/shading_scenes.h"

using namespace lentray::test;

namespace {

TEST(ImageShadingShadows, FilterAndTransmit) {
  EXPECT_TRUE(same_as_stock(
      staged("box { <-1.6, 0, -0.5>, <-1.5, 2, 1> pigment { rgbf <1, 0.3, 0.2, 0.9> } }"
             "box { <-0.6, 0, -0.5>, <-0.5, 2, 1> pigment { rgbt <0.2, 0.3, 1, 0.6> } }"
             "box { <0.4, 0, -0.5>, <0.5, 2, 1> pigment { rgbft <0.3, 1, 0.4, 0.5, 0.3> } }"
             "sphere { <1.4, 0.5, 0>, 0.5 pigment { rgb <0.9, 0.9, 0.2> } }")));
}

TEST(ImageShadingShadows, PatternedFilter) {
  EXPECT_TRUE(same_as_stock(
      staged("sphere { <0, 1.5, 0>, 0.9 hollow"
             " pigment { checker rgbf <1, 0.3, 0.2, 0.9> rgb <0.2, 0.2, 0.2> scale 0.3 } }")));
}

TEST(ImageShadingShadows, LayersMultiply) {
  EXPECT_TRUE(same_as_stock(staged(
      "box { <-1, 0.6, -0.5>, <1, 0.7, 1>"
      " texture { pigment { rgbf <1, 0.5, 0.3, 0.8> } }"
      " texture { pigment { checker rgbt <0, 0, 1, 0.9> rgbf <0.5, 1, 0.5, 0.9> scale 0.3 } } }")));
}

TEST(ImageShadingShadows, Caustics) {
  EXPECT_TRUE(
      same_as_stock(staged("sphere { <0, 1, 0>, 0.8 pigment { rgbf <1, 0.9, 0.8, 0.7> }"
                           " interior { ior 1.3 caustics 2 } }")));
}

/// A disc is half of space inside CSG, and yet bounds it by its own flat box: rays that start in
/// that box see all of the rest.
TEST(ImageShadingShadows, OfWhatLeavesItsBounds) {
  EXPECT_TRUE(same_as_stock(
      staged("intersection { sphere { <0, -.5, 0>, 1.4 } disc { 0, -y, 1.5 } translate .3*y"
             " pigment { rgbf <0.8, 1, 0.95, 0.9> } interior { ior 1.3 } }"),
      Grade::match));
}

TEST(ImageShadingShadows, NoShadow) {
  EXPECT_TRUE(
      same_as_stock(staged("sphere { <-0.7, 1, 0>, 0.6 pigment { rgb <0.9, 0.5, 0.2> } no_shadow }"
                           "sphere { <0.8, 1, 0>, 0.6 pigment { rgb <0.2, 0.5, 0.9> } }")));
}

TEST(ImageShadingShadows, NoImageAndNoReflection) {
  EXPECT_TRUE(same_as_stock(
      staged("sphere { <-0.9, 0.8, -0.6>, 0.5 pigment { rgb <0.9, 0.5, 0.2> } no_image }"
             "sphere { <0.9, 0.8, -0.6>, 0.5 pigment { rgb <0.2, 0.5, 0.9> } no_reflection }"
             "box { <-2, 0, 0.8>, <2, 2, 1> pigment { rgb 0.1 } finish { reflection 0.7 } }")));
}

TEST(ImageShadingShadows, NoImageThroughGlassAndInMirrorsBehindGlass) {
  EXPECT_TRUE(same_as_stock(
      staged("box { <-2, 0, -1.6>, <2, 2.5, -1.5> pigment { rgbt <0.9, 1, 0.9, 0.9> }"
             " finish { reflection 0.1 } }"
             "sphere { <-0.9, 0.8, -0.6>, 0.5 pigment { rgb <0.9, 0.5, 0.2> } no_image }"
             "sphere { <0.9, 0.8, -0.6>, 0.5 pigment { rgb <0.2, 0.5, 0.9> } no_reflection }"
             "box { <-2, 0, 0.8>, <2, 2, 1> pigment { rgb 0.1 } finish { reflection 0.7 } }")));
}

TEST(ImageShadingShadows, CsgThrowsTheShadowOfItsSurface) {
  EXPECT_TRUE(same_as_stock(
      staged("difference { box { <-0.8, 0.2, -0.8>, <0.8, 1.8, 0.8> } sphere { <0, 1, 0>, 0.95 }"
             " pigment { rgb <0.7, 0.5, 0.4> } }")));
}

}  // namespace
