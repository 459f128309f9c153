// The photons that are shot beside those that stock saves (`save_file`), one for one: places, colours and
// directions. And that files go both ways.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/photon/photon_file.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

struct PhotonScene {
  const char* name;
  const char* settings;
  const char* sdl;
};
std::ostream& operator<<(std::ostream& out, const PhotonScene& s) { return out << s.name; }

std::string text_of(const PhotonScene& scene, const std::string& file) {
  return std::string(
             "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 10 photons { ") +
         scene.settings + " " + file +
         " } }\ncamera { location <0, 4, -8> look_at 0 }\n"
         "plane { y, -1 pigment { rgb 1 } }\n" +
         scene.sdl;
}

core::PhotonMaps saved(const PhotonScene& scene, bool by_stock) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", text_of(scene, "save_file \"out.ph\""));
  std::vector<std::string> arguments{"+Iscene.pov", "+Oout.png", "+W8", "+H6", "-A", "-D", "+WT1"};
  if (by_stock) {
    arguments.insert(arguments.begin(), "povray");
    tool::run_program(arguments, folder.path(), 60.0);
  } else {
    const tool::RunResult run = run_lentray(arguments, folder.path());
    EXPECT_EQ(run.status, 0) << run.output;
  }
  EXPECT_TRUE(fs::exists(folder / "out.ph"));
  return core::read_photon_file(tool::read_text(folder / "out.ph"));
}

/// Far away roundings of single precision count, and of what went from surface to surface many times.
bool is_same_place(const core::Photon& a, const core::Photon& b) {
  constexpr double kSlack = 1e-5;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double size = std::max(1.0f, std::fabs(a.place[axis]));
    if (!(std::fabs(a.place[axis] - b.place[axis]) <= kSlack * size)) return false;
  }
  return true;
}

void expect_same(const std::vector<core::Photon>& ours, const std::vector<core::Photon>& stock) {
  ASSERT_EQ(ours.size(), stock.size());
  std::size_t elsewhere = 0, other_colour = 0, other_way = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    elsewhere += is_same_place(ours[i], stock[i]) ? 0 : 1;
    other_colour += ours[i].rgbe == stock[i].rgbe ? 0 : 1;
    other_way +=
        ours[i].latitude == stock[i].latitude && ours[i].longitude == stock[i].longitude ? 0 : 1;
  }
  EXPECT_LE(elsewhere, ours.size() / 200);
  EXPECT_EQ(other_colour, 0u);
  EXPECT_LE(other_way, ours.size() / 1000);
}

class ImagePhotonFile : public ::testing::TestWithParam<PhotonScene> {};

TEST_P(ImagePhotonFile, IsStocks) {
  const core::PhotonMaps stock = saved(GetParam(), true), ours = saved(GetParam(), false);
  EXPECT_GT(stock.surface.size(), 50u);
  expect_same(ours.surface, stock.surface);
  expect_same(ours.media, stock.media);
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImagePhotonFile,
    ::testing::Values(
        PhotonScene{"Lens", "spacing .05",
                    "light_source { <3, 10, -4> rgb <1, .9, .7> }"
                    "sphere { .5*y, 1 pigment { rgbf <.9, 1, .8, .9> } finish { reflection .1 } "
                    "interior { ior 1.5 } photons { target refraction on reflection on } }"},
        PhotonScene{"ParallelTurnedBox", "spacing .05",
                    "light_source { <3, 10, -4> rgb 1 parallel point_at 0 }"
                    "box { -.7, .7 rotate <20, 30, 10> translate .5*y pigment { rgbt 1 } "
                    "interior { ior 1.33 } photons { target 1.5 refraction on collect off } }"},
        PhotonScene{"CountSpotFading", "count 9000 jitter 0 autostop 0",
                    "light_source { <3, 10, -4> rgb 1 spotlight radius 8 falloff 12 tightness 3 "
                    "point_at 0 fade_distance 8 fade_power 2 }"
                    "light_source { <-3, 6, -4> rgb x photons { refraction on reflection off } }"
                    "union { sphere { -x, .7 } cylinder { <1, -.5, 0>, <1.2, .9, .4>, .4 } "
                    "split_union off pigment { rgbf 1 } interior { ior 1.4 fade_distance .5 "
                    "fade_power 2 fade_color <.2, .9, .3> } finish { reflection .2 } "
                    "photons { target reflection on refraction on } "
                    "rotate 30*y }"},
        PhotonScene{"AreaLight", "spacing .1",
                    "light_source { <3, 8, -4> rgb 1 area_light 2*x, 2*z, 3, 4 "
                    "photons { area_light } }"
                    "difference { sphere { 0, 1 } box { <-2, .2, -2>, <2, 2, 2> } rotate 25*x "
                    "pigment { rgbf 1 } interior { ior 1.5 } "
                    "photons { target refraction on reflection on } }"},
        PhotonScene{"PassThroughCollect", "spacing .06",
                    "light_source { <0, 10, 0> rgb 1 }"
                    "box { <-3, 2, -3>, <3, 2.1, 3> pigment { rgbf <1, .5, .5, 1> } "
                    "photons { pass_through } }"
                    "sphere { .5*y, .7 pigment { rgbf 1 } interior { ior 1.5 } "
                    "photons { target refraction on reflection on } }"
                    "box { <-.5, -1, 1>, <.5, 0, 2> pigment { rgb z } photons { collect off } }"},
        PhotonScene{"NestedLightWithin", "spacing .2",
                    "light_source { <.2, .3, .1> rgb 1 }"
                    "sphere { .5*y, 1 pigment { rgbf 1 } interior { ior 1.5 } "
                    "photons { target refraction on } }"
                    "sphere { .5*y, .6 pigment { rgbf 1 } interior { ior 1.2 } "
                    "photons { target reflection on refraction on } }"},
        PhotonScene{"CylinderNoShadowLimits", "spacing .05 max_trace_level 3 adc_bailout .1",
                    "light_source { <0, 6, -2> rgb 1 cylinder radius .5 falloff 1 tightness 1 "
                    "point_at 0 parallel }"
                    "sphere { .1, .6 pigment { rgb x } finish { reflection 1 } no_shadow }"
                    "merge { sphere { x, .5 } sphere { 1.4*x, .5 } pigment { rgbf 1 } "
                    "finish { reflection .3 } interior { ior 1.3 } "
                    "photons { target refraction on reflection on } }"},
        PhotonScene{"LayersFresnelBumps", "spacing .06",
                    "light_source { <2, 10, -3> rgb 1 }"
                    "sphere { .2*y, .8 texture { pigment { rgbf <.9, .8, .7, .8> } "
                    "normal { bumps .3 scale .2 } } texture { pigment { rgbf <1, .9, 1, .9> } "
                    "finish { reflection { .1, .6 fresnel metallic 1 } conserve_energy } } "
                    "interior { ior 1.5 } photons { target refraction on reflection on } }"},
        PhotonScene{"Media", "spacing .1 media 60, 1",
                    "light_source { <2, 10, -3> rgb 1 }"
                    "sphere { 0, 3 hollow pigment { rgbt 1 } photons { pass_through } interior { "
                    "media { scattering { 1, .1 } method 3 samples 4 } } }"
                    "sphere { .2*y, .8 pigment { rgbf 1 } interior { ior 1.5 } "
                    "photons { target refraction on reflection on } }"}),
    [](const auto& one) { return std::string(one.param.name); });

const PhotonScene kPlain{"Plain", "spacing .05",
                         "light_source { <3, 10, -4> rgb 1 }"
                         "sphere { .5*y, 1 pigment { rgbf 1 } interior { ior 1.5 } "
                         "photons { target refraction on } }"};

/// Light that splits into bands comes to the same places; the bands' colours are near stock's.
TEST(ImagePhotonShooting, DispersionShootsAsManyAsStock) {
  const PhotonScene scene{"Dispersion", "spacing .05",
                          "light_source { <3, 10, -4> rgb 1 }"
                          "sphere { .5*y, 1 pigment { rgbf 1 } interior { ior 1.5 dispersion 1.05 "
                          "dispersion_samples 5 } photons { target refraction on } }"};
  const core::PhotonMaps stock = saved(scene, true), ours = saved(scene, false);
  ASSERT_EQ(ours.surface.size(), stock.surface.size());
  std::size_t elsewhere = 0;
  for (std::size_t i = 0; i < ours.surface.size(); ++i)
    elsewhere += is_same_place(ours.surface[i], stock.surface[i]) ? 0 : 1;
  EXPECT_LE(elsewhere, ours.surface.size() / 100);
  const auto power = [](const core::PhotonMaps& maps) {
    core::Rgb sum;
    for (const core::Photon& photon : maps.surface) sum += core::power_of(photon);
    return sum;
  };
  const core::Rgb all = power(ours), wanted = power(stock);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(all[c] / wanted[c], 1.0f, 0.02f) << c;
}

/// Of two lights and a target, through two media: the random numbers go on from unit to unit.
TEST(ImagePhotonShooting, PhotonsInMediaLieWhereStocksDo) {
  const PhotonScene scene{
      "TwoInMedia", "spacing .12 media 20, 1.5",
      "light_source { <2, 10, -3> rgb 1 } light_source { <-4, 8, -3> rgb x }"
      "sphere { 0, 3 hollow pigment { rgbt 1 } photons { pass_through } interior { "
      "media { scattering { 1, .1 } method 3 samples 4 density { bozo scale .5 } } } }"
      "sphere { .2*y, .8 pigment { rgbf 1 } interior { ior 1.5 } "
      "photons { target refraction on reflection on } }"};
  const core::PhotonMaps stock = saved(scene, true), ours = saved(scene, false);
  EXPECT_GT(stock.media.size(), 500u);
  expect_same(ours.media, stock.media);
}

TEST(ImagePhotonShooting, LoadedPhotonsAreThoseThatWereSaved) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "shot.pov", text_of(kPlain, "save_file \"a.ph\""));
  tool::write_text(folder / "loaded.pov", text_of(kPlain, "load_file \"a.ph\""));
  for (const char* name : {"shot", "loaded"}) {
    const auto run = run_lentray({std::string("+I") + name + ".pov",
                                  std::string("+O") + name + ".png", "+W60", "+H45", "-A", "-D"},
                                 folder.path());
    ASSERT_EQ(run.status, 0) << run.output;
  }
  EXPECT_TRUE(
      same_bits(core::read_image(folder / "loaded.png"), core::read_image(folder / "shot.png")));
}

TEST(ImagePhotonShooting, StatisticsTellOfThem) {
  SceneText plain;
  plain.sdl = text_of(kPlain, "");
  const auto all = lentray_statistics(plain);
  EXPECT_GT(all["photons"]["shot"].get<int>(), 100);
  EXPECT_GT(all["photons"]["surface"].get<int>(), 100);
  EXPECT_EQ(all["passes"][0]["name"], "photons");
}

TEST(ImagePhotonShooting, AFileThatCannotBeSavedIsAWarning) {
  const tool::TemporaryFolder folder;
  const PhotonScene dark{"Dark", "spacing .05",
                         "light_source { <3, 10, -4> rgb 1 } sphere { .5*y, 1 pigment { rgb 1 } "
                         "photons { target reflection on } }"};
  tool::write_text(folder / "scene.pov", text_of(dark, "save_file \"a.ph\""));
  const auto run = run_lentray({"+Iscene.pov", "+Oa.png", "+W8", "+H6", "-D"}, folder.path());
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.output.find("there are no photons to save"), std::string::npos) << run.output;
  EXPECT_FALSE(fs::exists(folder / "a.ph"));
}

/// Of each why.
TEST(ImagePhotonShooting, PhotonsThatCannotBeSavedSayWhy) {
  const tool::TemporaryFolder folder;
  fs::create_directory(folder / "folder");
  const auto said = [&](const std::string& name, const std::string& before) {
    tool::write_text(folder / "scene.pov", text_of(kPlain, "save_file \"" + name + "\""));
    const std::string command =
        before + "exec \"" + program("lentray").string() + "\" +Iscene.pov +Oa.png +W8 +H6 -D -V";
    return tool::run_program({"sh", "-c", command}, folder.path(), 60.0).output;
  };
  for (const auto& [name, before, why] :
       {std::array<std::string, 3>{"nowhere/a.ph", "", "the folder 'nowhere' does not exist"},
        {"folder", "", "a folder has that name"},
        {"scene.pov/a.ph", "", "'scene.pov' is not a folder"},
        {"a.ph", "trap '' XFSZ; ulimit -f 8; ", "not saved: cannot write 'a.ph': File too large"},
        {"/dev/full", "", "not saved: cannot write '/dev/full': No space left on device"}}) {
    const std::string all = said(name, before);
    EXPECT_NE(all.find(why), std::string::npos) << all;
  }
  EXPECT_FALSE(fs::exists(folder / "a.ph"));
}

}  // namespace
}  // namespace lentray::test
