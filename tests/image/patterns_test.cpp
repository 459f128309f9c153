// Patterns and pigments against stock, number by number: a scene makes stock print the values of
// `function { pattern { ... } }` and `function { pigment { ... } }` at many points; ours must be the
// same there. Pattern values are doubles on both sides, colours floats.
#include <gtest/gtest.h>

#include "parser/compile/pattern_compiler.h"
#include "tests/image/stock_values.h"
#include "tests/unit/material/material_reading.h"

namespace lentray::parser::test {
namespace {

class ImagePatterns : public ::testing::TestWithParam<const char*> {};

TEST_P(ImagePatterns, HaveTheValuesOfStock) {
  const std::string text = GetParam();
  const auto stock = stock_values("pattern { " + text + " }", "", {"V"});
  const auto ours = our_values(text);
  const auto points = sample_points();
  for (std::size_t i = 0; i < points.size(); ++i) expect_same(ours[i], stock[i], 1e-9, points[i]);
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImagePatterns,
    ::testing::Values(
        "checker", "hexagon", "cubic", "brick", "brick brick_size <1,.5,.7> mortar .1", "cells",
        "gradient <1,2,.5>", "gradient x frequency 3 phase .2", "gradient y sine_wave",
        "gradient z scallop_wave frequency -2", "gradient x cubic_wave", "gradient x poly_wave 2.5",
        "onion", "radial frequency 3", "spherical", "cylindrical", "planar", "boxed", "leopard",
        "quilted control0 .3 control1 .8", "function { x*y - z }", "function { abs(x) + y*y }",
        "bozo", "bozo noise_generator 1", "bozo noise_generator 3", "dents", "granite",
        "granite noise_generator 1", "wrinkles", "wrinkles noise_generator 3", "marble",
        "marble turbulence .7", "wood", "wood turbulence .2", "agate",
        "agate agate_turb .3 noise_generator 1", "spiral1 3 turbulence .1", "spiral2 5", "ripples",
        "ripples frequency .3 phase .6", "waves frequency 2", "crackle", "crackle form <1,0,0>",
        "crackle metric 3 offset .1", "crackle solid", "mandel 50",
        "mandel 30 exponent 3 interior 1, 2 exterior 4, .2", "julia <.36,.25>, 40",
        "magnet 1 mandel 30", "magnet 2 julia <.1,.2> 30", "bozo turbulence 1",
        "gradient x turbulence <.3,.5,.1> octaves 4 lambda 1.8 omega .7 scale 2 rotate <10,20,30>",
        "gradient x scale 2 turbulence .5 translate y", "gradient x warp { turbulence .4 } scale 2",
        "checker warp { repeat 2*x offset <0,.5,0> flip x }",
        "gradient x warp { black_hole <0,0,0>, 3 strength 1.5 falloff 1.2 }",
        "gradient x warp { black_hole .3, .2 repeat 1 turbulence .1 inverse }",
        "gradient x warp { cylindrical }", "gradient y warp { spherical dist_exp 1 orientation y }",
        "gradient x warp { toroidal major_radius 2 }", "gradient <1,1,1> warp { planar x, .3 }",
        "gradient x warp { cubic }"),
    [](const auto& named) { return "n" + std::to_string(named.index); });

struct PigmentCase {
  const char* pigment;
  const char* before = "";
};

class ImagePigments : public ::testing::TestWithParam<PigmentCase> {};

TEST_P(ImagePigments, HaveTheColoursOfStock) {
  const auto [text, before] = GetParam();
  const auto stock = stock_values("pigment { " + std::string(text) + " }", before,
                                  {"V.red", "V.green", "V.blue", "V.filter", "V.transmit"});
  const LooksText read("pigment { " + std::string(text) + " }", before);
  const auto ours = compiled(read.pigment());
  const auto points = sample_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const core::Colour c = ours->colour(points[i]);
    const double all[] = {c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit};
    for (std::size_t k = 0; k < 5; ++k) expect_same(all[k], stock[5 * i + k], 2e-6, points[i]);
  }
}

constexpr PigmentCase kPigments[] = {
    {"rgbft <.1,.2,.3,.4,.5>"},
    {"checker"},
    {"hexagon"},
    {"brick"},
    {"square"},
    {"triangular"},
    {"cubic"},
    {"square rgb 1, rgb .5"},
    {"bozo"},
    {"wood"},
    {"marble"},
    {"agate"},
    {"radial"},
    {"mandel 20"},
    {"granite"},
    {"gradient x color_map { [.2 rgb 1] [.4 rgbf <1,0,0,.5>] [.4 rgb <0,1,0>] [.9 rgbt <0,0,1,1>] "
     "}"},
    {"gradient x color_map { [.6 rgb 1] [.3 rgb <1,0,0>] [.8 rgb <0,1,0>] }"},
    {"gradient x color_map { [0, .3 color rgb 1 color rgb 0] [.3, 1 color red 1 color blue 1] }"},
    {"gradient x color_map { M } rotate 30",
     "#declare M = color_map { [0 rgb .3] [1 rgb <1,0,1>] }"},
    {"gradient x pigment_map { [.3 checker] [.8 gradient y scale .3] } scale 3 rotate z*20"},
    {"bozo turbulence .3 pigment_map { [.3 checker scale .2] [.6 P] }",
     "#declare P = pigment { granite color_map { [0 rgb 1] [1 rgbt <1,0,0,1>] } }"},
    {"checker pigment { gradient x }, pigment { marble turbulence .5 } scale .7"},
    {"average pigment_map { [1 checker] [2 bozo] [.5 rgb <1,2,3>] } scale 2"},
    {"average pigment_map { [checker] [bozo] } translate .3"},
    {"function { x + y*y } color_map { [0 rgb <1,0,0>] [1 rgb <0,0,1>] }"},
    {"P scale 2",
     "#declare P = pigment { wood turbulence .1 color_map { [0 rgb 0] [1 rgb 1] } rotate 10 }"},
    {"object { sphere { 0, 3 } rgb <1,0,0>, rgb <0,0,1> } scale 1.5"},
    {"pigment_pattern { checker rgb <1,0,0>, rgb <0,1,0> } color_map { [0 rgb 0] [1 rgb 1] }"},
};

INSTANTIATE_TEST_SUITE_P(Each, ImagePigments, ::testing::ValuesIn(kPigments),
                         [](const auto& named) { return "n" + std::to_string(named.index); });

}  // namespace
}  // namespace lentray::parser::test
