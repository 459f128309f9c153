// Descriptions as JSON: everything that a scene says, by name, in numbers that read back the same.
#include "parser/dump/scene_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

using Json = nlohmann::ordered_json;

Json dumped(const std::string& text) {
  SceneText read(text);
  const std::string printed = scene_json(read.scene, read.sources()).dump(1);
  return Json::parse(printed);
}

TEST(UnitDump, DefaultsAreLeftOut) {
  const Json scene = dumped("sphere { <1, 2, 3>, 4 }");
  const Json& object = scene["objects"][0]["object"];
  EXPECT_EQ(object["keyword"], "sphere");
  EXPECT_EQ(object["shape"]["centre"], Json::array({1, 2, 3}));
  EXPECT_EQ(object["shape"]["radius"], 4);
  EXPECT_FALSE(object.contains("no_shadow"));
  EXPECT_FALSE(object.contains("transform"));
  EXPECT_FALSE(scene.contains("camera"));
  const std::string where = object["where"];
  EXPECT_EQ(where.substr(where.rfind(".pov")), ".pov:1:51");
}

TEST(UnitDump, NumbersAreRound) {
  const Json scene = dumped(
      "sphere { <.1, 1/3, 1e300>, 1e-300 pigment { rgb <.1, .7, .3> } }\nbackground { rgb .9 }");
  const Json& object = scene["objects"][0]["object"];
  EXPECT_EQ(object["shape"]["centre"].dump(), "[0.1,0.3333333333333333,1e+300]");
  EXPECT_EQ(object["shape"]["radius"].get<double>(), 1e-300);
  // Colours are single precision: 0.1f is told as 0.1.
  EXPECT_EQ(object["texture"]["layers"][0]["pigment"]["colour"].dump(), "[0.1,0.7,0.3,0.0,0.0]");
  EXPECT_EQ(scene["background"].dump(), "[0.9,0.9,0.9,0.0,0.0]");
}

TEST(UnitDump, WhatJsonHasNoNumberFor) {
  SceneText read("sphere { 0, 1 }");
  read.scene.global.mm_per_unit = std::numeric_limits<double>::infinity();
  read.scene.atmosphere_ior = std::nan("");
  const Json scene = scene_json(read.scene, read.sources());
  EXPECT_EQ(scene["global"]["mm_per_unit"], "infinity");
  EXPECT_EQ(scene["atmosphere_ior"], "nan");
}

TEST(UnitDump, SharedDescriptionsStandOnce) {
  // 2^20 spheres if each stood for itself.
  const Json scene = dumped(
      "#declare O = sphere { 0, 1 } #declare I = 0;\n#while (I < 20) #declare O = union { object { "
      "O } "
      "object { O translate x } } #declare I = I + 1; #end\nobject { O }");
  EXPECT_LT(scene.dump().size(), 100'000u);
  EXPECT_NE(scene.dump().find("same_as"), std::string::npos);
}

TEST(UnitDump, TextThatIsNoUtf8) {
  SceneText read("sphere { 0, 1 }");
  read.scene.global.photons.emplace();
  read.scene.global.photons->save_file = "\xe4.ph";
  const std::string printed =
      scene_json(read.scene, read.sources()).dump(1, ' ', false, Json::error_handler_t::replace);
  EXPECT_TRUE(Json::accept(printed));
}

struct Said {
  const char* sdl;
  const char* pointer;  ///< into the JSON
  const char* value;    ///< as printed
};

class UnitDumpSays : public ::testing::TestWithParam<Said> {};

TEST_P(UnitDumpSays, WhatTheSceneSays) {
  const Json scene = dumped(GetParam().sdl);
  const Json::json_pointer pointer(GetParam().pointer);
  ASSERT_TRUE(scene.contains(pointer)) << scene.dump(1);
  EXPECT_EQ(scene[pointer].dump(), GetParam().value) << scene.dump(1);
}

/// Defaults are left out: what stock does, not what its manual says.
INSTANTIATE_TEST_SUITE_P(
    PhotonDefaults, UnitDumpSays,
    ::testing::Values(Said{"global_settings { photons { autostop .5 expand_thresholds .2, 35 } }",
                           "/global/photons", "{}"},
                      Said{"global_settings { photons { autostop 0 } }", "/global/photons/autostop",
                           "0.0"},
                      Said{"global_settings { photons { expand_thresholds .2, 40 } }",
                           "/global/photons/expand_min", "40"}));

#define LENTRAY_MEDIA(words) \
  "sphere { 0, 1 hollow interior { media { density { rgb 1 } " words " } } }"
// Statements of which the rendering comes later are kept whole.
INSTANTIATE_TEST_SUITE_P(
    Kept, UnitDumpSays,
    ::testing::Values(
        Said{LENTRAY_MEDIA("method 2"), "/objects/0/object/interior/media/0/method", "2"},
        Said{LENTRAY_MEDIA("intervals 4"), "/objects/0/object/interior/media/0/intervals", "4"},
        Said{LENTRAY_MEDIA("samples 3, 7"), "/objects/0/object/interior/media/0/max_samples", "7"},
        Said{LENTRAY_MEDIA("confidence .8"), "/objects/0/object/interior/media/0/confidence",
             "0.8"},
        Said{LENTRAY_MEDIA("variance .02"), "/objects/0/object/interior/media/0/variance", "0.02"},
        Said{LENTRAY_MEDIA("ratio .7"), "/objects/0/object/interior/media/0/ratio", "0.7"},
        Said{LENTRAY_MEDIA("jitter .3"), "/objects/0/object/interior/media/0/jitter", "0.3"},
        Said{LENTRAY_MEDIA("aa_level 5"), "/objects/0/object/interior/media/0/aa_level", "5"},
        Said{LENTRAY_MEDIA("aa_threshold .3"), "/objects/0/object/interior/media/0/aa_threshold",
             "0.3"},
        Said{LENTRAY_MEDIA("absorption .3"), "/objects/0/object/interior/media/0/absorption",
             "[0.3,0.3,0.3]"},
        Said{LENTRAY_MEDIA("emission .3"), "/objects/0/object/interior/media/0/emission",
             "[0.3,0.3,0.3]"},
        Said{LENTRAY_MEDIA("collect off"), "/objects/0/object/interior/media/0/ignore_photons",
             "true"},
        Said{LENTRAY_MEDIA("scattering { 5, .3 eccentricity .2 extinction .4 }"),
             "/objects/0/object/interior/media/0/scattering",
             R"({"type":5,"colour":[0.3,0.3,0.3],"eccentricity":0.2,"extinction":0.4})"},
        Said{"media { emission 1 } sphere { 0, 1 }", "/atmosphere_media/0/emission",
             "[1.0,1.0,1.0]"},
        Said{
            "global_settings { radiosity { count 50, 900 nearest_count 6, 2 recursion_limit 3 } }",
            "/global/radiosity",
            R"({"count":50,"direction_pool":900,"nearest_count":6,"nearest_count_adaptive":2,"recursion_limit":3})"},
        Said{"global_settings { radiosity { always_sample on normal on media on subsurface on } }",
             "/global/radiosity",
             R"({"always_sample":true,"media":true,"normal":true,"subsurface":true})"},
        Said{
            "global_settings { radiosity { adc_bailout .02 brightness 2 error_bound 1 "
            "gray_threshold .5 "
            "low_error_factor .6 maximum_reuse .3 minimum_reuse .02 max_sample 4 pretrace_start .1 "
            "pretrace_end .05 } }",
            "/global/radiosity",
            R"({"adc_bailout":0.02,"brightness":2.0,"error_bound":1.0,"gray_threshold":0.5,"low_error_factor":0.6,"maximum_reuse":0.3,"minimum_reuse":0.02,"max_sample":4.0,"pretrace_start":0.1,"pretrace_end":0.05})"},
        Said{
            "global_settings { photons { spacing .1 count 9 gather 5, 50 media 3, 2 jitter .2 "
            "autostop .1 "
            "adc_bailout .3 max_trace_level 4 expand_thresholds .3, 41 radius 1, 2, 3, 4 save_file "
            "\"p\" } }",
            "/global/photons",
            R"({"spacing":0.1,"jitter":0.2,"autostop":0.1,"expand_increase":0.3,"adc_bailout":0.3,"radius":1.0,"radius_multiplier":2.0,"media_radius":3.0,"media_radius_multiplier":4.0,"media_factor":2.0,"count":9,"gather_min":5,"gather_max":50,"expand_min":41,"media_steps":3,"max_trace_level":4,"save_file":"p"})"},
        Said{"global_settings { subsurface { samples 20, 30 radiosity on } }", "/global/subsurface",
             R"({"samples_diffuse":20,"samples_single":30,"radiosity":true})"},
        Said{"sphere { 0, 1 finish { subsurface { translucency .3 anisotropy .2 } } }",
             "/objects/0/object/texture/layers/0/finish/subsurface",
             R"({"translucency":[0.3,0.3,0.3],"anisotropy":[0.2,0.2,0.2]})"},
        Said{
            "sphere { 0, 1 photons { target .5 reflection on refraction off collect off "
            "pass_through } }",
            "/objects/0/object/photons",
            R"({"given":true,"target":true,"density":0.5,"refraction":false,"reflection":true,"pass_through":true,"collect":false})"},
        Said{"light_source { 0 1 photons { reflection on area_light } }",
             "/objects/0/object/shape/light/photons",
             R"({"given":true,"reflection":true,"area_light":true})"},
        Said{"sphere { 0, 1 radiosity { importance .5 } no_radiosity }",
             "/objects/0/object/radiosity_importance", "0.5"},
        Said{"#default { radiosity { importance .5 } } sphere { 0, 1 }",
             "/objects/0/default_importance", "0.5"},
        Said{"camera { aperture .5 blur_samples 9 focal_point z confidence .8 variance .01 }",
             "/camera/aperture", "0.5"},
        Said{"light_source { 0 1 projected_through { box { 0, 1 } } }",
             "/objects/0/object/shape/light/projected_through/keyword", "\"box\""},
        Said{
            "julia_fractal { <.1,.2,.3,.4> hypercomplex exp max_iteration 5 precision 9 slice "
            "<0,0,1,1>, .2 }",
            "/objects/0/object/shape",
            R"({"parameter":[0.1,0.2,0.3,0.4],"slice":[0.0,0.0,1.0,1.0],"slice_distance":0.2,"precision":9.0,"max_iteration":5,"hypercomplex":true,"function":"exp"})"}));

}  // namespace
}  // namespace lentray::parser::test
