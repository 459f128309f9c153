// Small scenes in the ways that people write them, against stock: each shows what a scene of somebody's showed first.
#include "tests/support/render.h"

namespace lentray::test {
namespace {

struct WrittenScenesCase {
  const char* name;
  const char* sdl;
  Grade grade = Grade::exact;
};

constexpr const char* kNew = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <.3,.5,-5> look_at 0 right 4/3*x angle 60 }
light_source { <-4,6,-8> 1 }
)";

const WrittenScenesCase kWrittenScenesCases[] = {
    {"directive_before_brace",
     "#local A = #if (1) merge #else union #end { sphere { 0, 1 } sphere { x, 1 } }"
     " object { A pigment { rgb <1,.6,.2> } }"},
    {"hash_before_statements", "#sphere { 0, 1 #pigment { rgb <.3,.7,1> } }"},
    {"declare_without_hash",
     "#declare T = texture { pigment { rgb x } } declare S = sphere { 0, 1 texture { T } } object "
     "{ S }"},
    {"split_union_in_a_merge",
     "merge { sphere { 0, 1 } sphere { x, 1 } pigment { rgb 1 } split_union off }"},
    {"text_escape", "text { ttf \"timrom.ttf\" \"\\u00e9Z\\u0041\" .2, 0 pigment { rgb 1 } }"},
    {"isosurface_that_is_no_number",
     "isosurface { function { sin(z + x) + pow(z, 1.35) } contained_by { box { -2, 2 } }"
     " max_gradient 4 pigment { rgb 1 } finish { ambient 1 } }"},
    {"sky_sphere_too_far",
     "sphere { 0, 1e9 hollow pigment { rgb y } finish { ambient 1 diffuse 0 } } plane { y, -1 "
     "pigment { checker rgb 1 rgb x } }"},
    {"far_box_is_seen",
     "box { -1e8, 1e8 pigment { rgb y } finish { ambient 1 diffuse 0 } hollow } sphere { 0, 1 "
     "pigment { rgb x } }"},
    {"stretched_sky_is_seen",
     "sphere { 0, 1 scale <1e9, 1e8, 1e9> hollow pigment { gradient y scale 2e8 } finish { ambient "
     "1 diffuse 0 } }"},
    {"trace_has_an_end",
     "#declare N = <0,0,0>; #declare S = sphere { 0, 1e9 } #declare B = box { -1e8, 1e8 }"
     " #declare P = trace(S, <0,0,0>, z, N); box { -.5, .5 pigment { rgb vlength(N)*x + y } "
     "translate -x }"
     " #declare P = trace(B, <0,0,0>, z, N); box { -.5, .5 pigment { rgb vlength(N)*x + z } "
     "translate x }"},
    {"height_field_in_a_union_that_is_cut",
     "difference { union { height_field { function 16, 16 { .5 + .4*sin(x*9)*cos(y*9) }"
     " pigment { rgb x } rotate 180*z translate <.5,0,-.5> scale <2,1.2,2> } }"
     " box { <-20,0,-20> <20,4,20> pigment { rgb y } } translate .8*y } plane { y, -1 pigment { "
     "rgb 1 } }"},
    {"text_offset_has_no_z",
     "text { ttf \"cyrvetic.ttf\" \"Tent\" .3, <.1,.05,-.3> pigment { rgb 1 } rotate 30*y "
     "translate -x }"},
};

class ImageWrittenScenes : public ::testing::TestWithParam<WrittenScenesCase> {};

TEST_P(ImageWrittenScenes, AsStock) {
  EXPECT_TRUE(same_as_stock(
      {.sdl = std::string(kNew) + GetParam().sdl, .arguments = {}, .files = {}}, GetParam().grade));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageWrittenScenes, ::testing::ValuesIn(kWrittenScenesCases),
                         [](const auto& row) { return row.param.name; });

// #version 1.0: patterns that stand in a texture without a pigment around them.
TEST(ImageWrittenScenes, BarePatternsOfVersion1) {
  for (const char* pattern : {"marble", "wood", "agate", "leopard", "granite", "gradient y"}) {
    const std::string sdl =
        "#version 1.0\ncamera { location <.1,.2,-5> look_at 0 }\nlight_source { <5,10,-5>, rgb 1 "
        "}\n"
        "sphere { 0, 2 texture { " +
        std::string(pattern) +
        " color_map { [0 red 1 green 1 blue 1] [1 red 1 green 0 blue 0] } ambient 1 diffuse 0 } "
        "}\n";
    EXPECT_TRUE(same_as_stock({.sdl = sdl, .arguments = {}, .files = {}})) << pattern;
  }
}

// The Unicode table of a font comes first with charset utf8, and letters may be any of its.
TEST(ImageWrittenScenes, TextsInUtf8) {
  const std::string sdl =
      std::string(kNew) +
      "global_settings { charset utf8 }\n"
      "text { ttf \"cyrvetic.ttf\" \"a\xC3\xA9\xC3\x9F\" .2, 0 pigment { rgb 1 } translate -x }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .arguments = {}, .files = {}}));
}

}  // namespace
}  // namespace lentray::test
