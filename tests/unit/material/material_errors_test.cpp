// Messages of the grammar of looks: one test a message.
#include "tests/unit/material/material_reading.h"

namespace lentray::parser::test {
namespace {

struct MaterialErrorsCase {
  const char* name;
  const char* text;
  const char* message;  ///< a part of it
};

class ErrorMaterial : public ::testing::TestWithParam<MaterialErrorsCase> {};

TEST_P(ErrorMaterial, IsToldSo) {
  const std::string message = looks_failure(GetParam().text);
  EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}

constexpr MaterialErrorsCase kCases[] = {
    {"colour_map_without_entries", "pigment { gradient x color_map { } }", "an entry"},
    {"colour_map_with_checker", "pigment { checker color_map { [0 rgb 1] } }",
     "cannot use color_map with checker"},
    {"colour_map_without_pattern", "pigment { rgb 1 color_map { [0 rgb 1] } }",
     "cannot use color_map with no pattern"},
    {"colour_map_with_average", "pigment { average color_map { [0 rgb 1] } }",
     "cannot use color_map with average"},
    {"colour_map_in_normal", "normal { bumps color_map { [0 rgb 1] } }",
     "color_map can only be used in a pigment"},
    {"pigment_map_in_texture", "texture { gradient x pigment_map { [0 rgb 1] } }",
     "pigment_map can only be used in a pigment"},
    {"normal_map_in_pigment", "pigment { gradient x normal_map { [0 bumps] } }",
     "normal_map can only be used in a normal"},
    {"slope_map_in_pigment", "pigment { gradient x slope_map { [0 <0,1>] } }",
     "slope_map can only be used in a normal"},
    {"texture_map_in_pigment", "pigment { gradient x texture_map { [0 pigment { rgb 1 }] } }",
     "texture_map can only be used in a texture"},
    {"quick_color_in_normal", "normal { bumps quick_color rgb 1 }",
     "quick_color can only be used in a pigment"},
    {"bump_size_in_pigment", "pigment { bozo bump_size 1 }",
     "bump_size can only be used in a normal"},
    {"accuracy_in_pigment", "pigment { bozo accuracy 1 }", "accuracy can only be used in a normal"},
    {"facets_in_pigment", "pigment { facets }", "facets can only be used in a normal"},
    {"image_map_in_normal", "normal { image_map { png \"a.png\" } }",
     "image_map can only be used in a pigment"},
    {"normal_map_with_facets", "normal { facets normal_map { [0 bumps] } }",
     "cannot use normal_map with facets"},
    {"average_without_map", "pigment { average }", "average needs a map of pigments"},
    {"texture_pattern_without_map", "texture { gradient x }", "needs a texture_map"},
    {"mortar_without_brick", "pigment { checker mortar 1 }",
     "'mortar' can only be used with brick"},
    {"brick_size_without_brick", "pigment { bozo brick_size 1 }",
     "'brick_size' can only be used with brick"},
    {"agate_turb_without_agate", "pigment { bozo agate_turb 1 }",
     "'agate_turb' can only be used with agate"},
    {"control0_without_quilted", "pigment { bozo control0 1 }",
     "'control0' can only be used with quilted"},
    {"control1_without_quilted", "pigment { bozo control1 1 }",
     "'control1' can only be used with quilted"},
    {"solid_without_crackle", "pigment { bozo solid }", "'solid' can only be used with crackle"},
    {"form_without_crackle", "pigment { bozo form <1,0,0> }",
     "'form' can only be used with crackle"},
    {"metric_without_crackle", "pigment { bozo metric 1 }",
     "'metric' can only be used with crackle"},
    {"offset_without_crackle", "pigment { bozo offset 1 }",
     "'offset' can only be used with crackle"},
    {"coords_without_facets", "normal { bumps coords 1 }", "'coords' can only be used with facets"},
    {"size_without_facets", "normal { bumps size 1 }", "'size' can only be used with facets"},
    {"exterior_without_fractal", "pigment { bozo exterior 1, 1 }",
     "'exterior' can only be used with mandel"},
    {"interior_without_fractal", "pigment { bozo interior 1, 1 }",
     "'interior' can only be used with mandel"},
    {"exponent_without_fractal", "pigment { bozo exponent 3 }",
     "'exponent' can only be used with mandel"},
    {"exterior_type", "pigment { mandel 10 exterior 9, 1 }", "between 0 and 8"},
    {"interior_type", "pigment { mandel 10 interior 7, 1 }", "between 0 and 6"},
    {"fractal_iterations", "pigment { mandel 0 }", "at least one iteration"},
    {"magnet_type", "pigment { magnet 3 mandel 10 }", "of type 1 or 2"},
    {"magnet_kind", "pigment { magnet 1 bozo }", "mandel or julia"},
    {"noise_generator", "pigment { bozo noise_generator 4 }", "noise_generator is 0, 1, 2 or 3"},
    {"tiling_number", "pigment { tiling 28 }", "between 1 and 27"},
    {"pavement_sides", "pigment { pavement number_of_sides 5 }", "3, 4 or 6"},
    {"pavement_tiles", "pigment { pavement number_of_tiles 7 }", "between 1 and 6"},
    {"pavement_pattern", "pigment { pavement number_of_tiles 4 pattern 4 }", "between 1 and 3"},
    {"slope_null", "pigment { slope <0,0,0> }", "both vectors of the slope pattern are null"},
    {"slope_point_at_altitude", "pigment { slope { point_at <0,0,0> altitude y } }",
     "altitude cannot be used with point_at"},
    {"warp_kind", "pigment { bozo warp { bozo } }", "a kind of warp"},
    {"repeat_without_axis", "pigment { bozo warp { repeat <0,0,0> } }", "repeat needs an axis"},
    {"repeat_along_two_axes", "pigment { bozo warp { repeat <1,1,0> } }", "along one axis only"},
    {"image_repeat", "pigment { image_map { function 4, 4 { x } repeat <0,1> } }",
     "greater than 0 both ways"},
    {"image_without_file", "pigment { image_map { } }", "an image file"},
    {"map_entry_without_colour", "pigment { bozo color_map { [0.5] } }", "a color"},
    {"old_map_entry_cut_short", "pigment { bozo color_map { [0, .5 rgb 1] } }", "a second color"},
    {"fresnel_value", "finish { reflection { 1 fresnel 2 } }", "fresnel is on or off"},
    {"layer_over_pattern",
     "texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 1 } } }"
     " texture { pigment { rgb 1 } }",
     "cannot be layered"},
    {"part_of_patterned_texture",
     "texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 1 } } }"
     " pigment { rgb 1 }",
     "no single part"},
    {"tiles_without_texture", "texture { tiles { tile2 texture { pigment { rgb 1 } } } }",
     "the texture of a tile"},
    {"dispersion_samples", "interior { dispersion_samples 1 }", "at least 2"},
    {"media_intervals", "interior { media { intervals 0 } }", "at least one interval"},
    {"media_samples", "interior { media { samples 0 } }", "at least one sample"},
    {"media_sample_order", "interior { media { samples 5, 2 } }", "fewer than the least"},
    {"media_method", "interior { media { method 4 } }", "1, 2 or 3"},
    {"media_aa_threshold", "interior { media { aa_threshold 0 } }", "greater than 0"},
    {"media_aa_level", "interior { media { aa_level 0 } }", "at least 1"},
    {"media_confidence", "interior { media { confidence 1 } }", "less than 1"},
    {"media_eccentricity", "interior { media { scattering { 1, rgb 1 eccentricity .5 } } }",
     "type 5 only"},
};

INSTANTIATE_TEST_SUITE_P(Message, ErrorMaterial, ::testing::ValuesIn(kCases),
                         [](const auto& named) { return std::string(named.param.name); });

TEST(ErrorMaterialDefault, PatternedTexture) {
  EXPECT_NE(looks_failure("",
                          "#default { texture { checker texture { pigment { rgb 1 } } texture {"
                          " pigment { rgb 1 } } } }")
                .find("cannot be a map of textures"),
            std::string::npos);
}

TEST(ErrorMaterialDefault, LayeredTexture) {
  EXPECT_NE(
      looks_failure("",
                    "#declare T = texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } }"
                    " #default { texture { T } }")
          .find("cannot be layered"),
      std::string::npos);
}

TEST(ErrorMaterialWarning, ColourInAnObject) {
  EXPECT_TRUE(LooksText("pigment { rgb 1 } color rgb 1").warned("color in an object"));
}

TEST(ErrorMaterialWarning, ZeroRoughness) {
  EXPECT_TRUE(LooksText("pigment { rgb 1 } finish { roughness 0 }").warned("roughness is 0"));
}

TEST(ErrorMaterialWarning, FractalExponent) {
  EXPECT_TRUE(LooksText("pigment { mandel 10 exponent 40 }").warned("from 2 to 33"));
}

TEST(ErrorMaterialWarning, NarrowBlackHoleBlock) {
  EXPECT_TRUE(
      LooksText("pigment { bozo warp { black_hole 0, 1 repeat <1,1,1> } }").warned("too small"));
}

}  // namespace
}  // namespace lentray::parser::test
