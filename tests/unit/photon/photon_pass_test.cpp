// The pass that shoots photons: the same photons on any number of threads and when it is gone on with,
// autostop, the most that are kept, and scenes that shoot none.
#include "core/pass/photon_pass.h"

#include <gtest/gtest.h>

#include <atomic>
#include <sstream>
#include <string>
#include <vector>

#include "core/pass/pass_list.h"
#include "core/photon/photon_file.h"
#include "core/photon/photon_map.h"
#include "core/photon/rings.h"
#include "core/scene/scene.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

const char* const kGlass =
    "light_source { <3, 10, -4> 1 } plane { y, -1 pigment { rgb 1 } }"
    "sphere { 0, 1 pigment { rgbf 1 } finish { reflection .1 } interior { ior 1.5 } "
    "photons { target refraction on reflection on } }"
    "torus { 2, .1 pigment { rgb 1 } finish { reflection .9 } "
    "photons { target reflection on } }";

std::string scene_of(const std::string& settings, const std::string& rest = kGlass) {
  return "global_settings { photons { " + settings + " } } " + rest;
}

/// Records in memory; those there were are recalled first.
class PhotonRecords final : public core::PassLedger {
 public:
  void begin(std::size_t) override { m_recalled = 0; }
  bool recall(std::string& record) override {
    if (m_recalled == kept.size()) return false;
    record = kept[m_recalled++];
    return true;
  }
  void keep(std::string_view record) override {
    kept.emplace_back(record);
    m_recalled = kept.size();
  }
  void finish() override {}
  std::vector<std::string> kept;

 private:
  std::size_t m_recalled = 0;
};

struct Shot {
  std::vector<core::Photon> surface, media;
  core::PhotonReport report;
};

Shot shoot(const std::string& sdl, unsigned threads, core::PassLedger* ledger = nullptr,
           std::uint64_t most = core::PhotonPass::kMostPhotons) {
  SceneText text(sdl);
  const core::Scene scene(text.build(), {});
  core::Illumination light;
  core::PhotonPass pass(scene, light, most);
  core::PassList list;
  list.add(pass);
  EXPECT_TRUE(list.run({.threads = threads, .ledger = ledger}));
  return {light.photons->surface.tree().photons(), light.photons->media.tree().photons(),
          pass.report()};
}

TEST(UnitPhotonPass, TheSameOnAnyNumberOfThreads) {
  const std::string media =
      std::string(kGlass) +
      "sphere { 0, 3 hollow pigment { rgbt 1 } photons { pass_through } interior { media { "
      "scattering { 1, .1 } } } }";
  const std::string sdl = scene_of("spacing .05 media 20", media);
  const Shot one = shoot(sdl, 1);
  EXPECT_GT(one.surface.size(), 1000u);
  EXPECT_GT(one.media.size(), 1000u);
  for (const unsigned threads : {2u, 5u}) {
    const Shot many = shoot(sdl, threads);
    EXPECT_EQ(many.surface, one.surface);
    EXPECT_EQ(many.media, one.media);
    EXPECT_EQ(many.report.shot, one.report.shot);
  }
}

TEST(UnitPhotonPass, IsGoneOnWith) {
  const std::string sdl = scene_of("spacing .05");
  PhotonRecords all;
  const Shot whole = shoot(sdl, 1, &all);
  ASSERT_GT(all.kept.size(), 40u);
  for (const std::size_t cut : {std::size_t{0}, std::size_t{7}, all.kept.size() / 2}) {
    PhotonRecords some;
    some.kept.assign(all.kept.begin(), all.kept.begin() + static_cast<std::ptrdiff_t>(cut));
    const Shot again = shoot(sdl, 2, &some);
    EXPECT_EQ(again.surface, whole.surface);
    EXPECT_EQ(again.report.shot, whole.report.shot);
    EXPECT_EQ(some.kept, all.kept);
  }
}

TEST(UnitPhotonPass, AutostopEndsWhereTheTargetDoes) {
  const std::string ring =
      "light_source { <0, 10, 0> 1 parallel point_at 0 } plane { y, -1 pigment { rgb 1 } }"
      "cylinder { -y, y, .3 pigment { rgbf 1 } interior { ior 1.5 } "
      "photons { target refraction on } }";
  const auto shot = [&](const char* settings) {
    return shoot(scene_of(settings, ring), 2).report.shot;
  };
  // Half of the ball's edge, 1.04 from the middle, and all of it.
  EXPECT_LT(shot("spacing .02 autostop 0"), shot("spacing .02 autostop .5"));
  EXPECT_LT(shot("spacing .02"), shot("spacing .02 autostop 1"));
  EXPECT_EQ(shot("spacing .02"), shot("spacing .02 autostop .5"));
}

TEST(UnitPhotonPass, KeepsNoMoreThanTheMost) {
  const Shot few = shoot(scene_of("spacing .02"), 2, nullptr, 500);
  EXPECT_TRUE(few.report.is_full);
  EXPECT_GE(few.surface.size(), 500u);
  EXPECT_LT(few.surface.size(), 500u + 16u * core::RingCutter::kMost);
  EXPECT_FALSE(shoot(scene_of("spacing .2"), 2).report.is_full);
}

TEST(UnitPhotonPass, CancelsSoon) {
  SceneText text(scene_of("spacing .005"));
  const core::Scene scene(text.build(), {});
  core::Illumination light;
  core::PhotonPass pass(scene, light);
  core::PassList list;
  list.add(pass);
  const std::atomic<bool> cancel{true};
  EXPECT_FALSE(list.run({.threads = 2, .cancel = &cancel}));
  EXPECT_EQ(light.photons, nullptr);
}

TEST(UnitPhotonFile, IsWrittenAndRead) {
  Shot shot = shoot(scene_of("spacing .1"), 1);
  std::ostringstream out;
  core::write_photon_file(out, shot.surface, shot.media);
  for (core::Photon& photon : shot.surface) photon.hidden_by = 0;  // found anew when it is read
  const core::PhotonMaps read = core::read_photon_file(out.str());
  EXPECT_EQ(read.surface, shot.surface);
  EXPECT_TRUE(read.media.empty());
}

struct NoShot {
  const char* settings;
  const char* rest;
  const char* why;
};

TEST(UnitPhotonPass, ThereIsNoneWhereNoneCanBeShot) {
  const char* const target = "sphere { 0, 1 photons { target refraction on } }";
  const std::string lit = std::string("light_source { 9*y 1 } ") + target;
  const std::string dark = std::string("light_source { 9*y 1 shadowless } ") + target;
  const NoShot cases[] = {
      {"spacing 0", lit.c_str(), "their spacing must be greater than 0"},
      {"spacing .1", "light_source { 9*y 1 } sphere { 0, 1 }", "no object is a target"},
      {"spacing .1", dark.c_str(), "there is no light that shoots them"},
      {"spacing .1", "light_source { 9*y 1 } sphere { 0, 1 photons { target } }",
       "neither targets nor lights have reflection or refraction"},
  };
  for (const NoShot& one : cases) {
    SceneText text(scene_of(one.settings, one.rest));
    EXPECT_FALSE(text.build().settings.photons);
    EXPECT_TRUE(text.warned(std::string("no photons are shot: ") + one.why)) << one.why;
  }
  SceneText fine(scene_of("spacing .1", lit));
  EXPECT_TRUE(fine.build().settings.photons);
  EXPECT_FALSE(fine.warned("no photons are shot"));
}

}  // namespace
}  // namespace lentray::parser::test
