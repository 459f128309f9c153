// Photons as they are kept, found and gathered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/photon/c_random.h"
#include "core/photon/photon.h"
#include "core/photon/photon_map.h"
#include "core/photon/photon_tree.h"
#include "core/trace/random_key.h"

namespace lentray::core::photon_test {
namespace {

/// Photons on a floor, or in a cube, that come from above.
std::vector<Photon> scattered(std::size_t count, bool on_floor) {
  std::vector<Photon> photons;
  RandomSequence random(7, RandomSequence::Use::kFilm);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.next(), z = random.next(), y = on_floor ? 0.0 : random.next();
    photons.push_back(make_photon({x, y, z}, {x, y + 2.0, z}, Rgb(0.01f)));
  }
  return photons;
}

Vec3 place_of(const Photon& p) { return {p.place[0], p.place[1], p.place[2]}; }

std::set<std::uint32_t> numbers(const FoundPhotons& found) {
  std::set<std::uint32_t> all;
  for (const FoundPhotons::One& one : found) all.insert(one.number);
  return all;
}

TEST(UnitPhoton, PowerKeepsItsGreatestChannelToAPart256) {
  for (const float scale : {1e-6f, 0.003f, 1.0f, 17.0f}) {
    const Rgb power = Rgb(1.0f, 0.5f, 0.01f) * scale;
    const Rgb kept = unpacked(packed(power));
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(kept[i], power[i]);
      EXPECT_GE(kept[i], power[i] - power.r / 127.0f);
    }
  }
  EXPECT_EQ(packed(Rgb(1.0f, 0.5f, 0.0f)), (std::array<std::uint8_t, 4>{128, 64, 0, 251}));
  EXPECT_EQ(packed(Rgb(0.0f)), (std::array<std::uint8_t, 4>{0, 0, 0, 0}));
  EXPECT_TRUE(unpacked(packed(Rgb(1e-33f))).is_black());
}

TEST(UnitPhoton, ComesFromWhereItCameFrom) {
  for (const Vec3& from : {Vec3(1, 2, 3), Vec3(-1, 2, -3), Vec3(-2, -0.5, 0.1), Vec3(0, 5, 0),
                           Vec3(0, -5, 0), Vec3(-3, 0, 0)}) {
    const Photon photon = make_photon({0.5, 0.25, 1.0}, Vec3(0.5, 0.25, 1.0) + from, Rgb(1.0f));
    EXPECT_GT(dot(way_back(photon), normalized(from)), 0.998);
    EXPECT_NEAR(length(way_back(photon)), 1.0, 1e-12);
  }
}

TEST(UnitPhoton, RandomNumbersAreTheLibrarys) {
  CRandom random;
  EXPECT_EQ(random.next(), 1804289383u);
  EXPECT_EQ(random.next(), 846930886u);
  EXPECT_EQ(random.next(), 1681692777u);
}

class UnitPhotonTree : public ::testing::TestWithParam<bool> {};

/// But for the one that makes room, and those that a tree hides (see PhotonTree).
TEST_P(UnitPhotonTree, FindsTheNearest) {
  const PhotonTree tree(scattered(5000, GetParam()), PhotonTree::Order::kOfShooting);
  const Vec3 normal(0.0, 1.0, 0.0);
  std::size_t wanted = 0, missed = 0;
  FoundPhotons found;
  RandomSequence random(3, RandomSequence::Use::kFilm);
  for (int i = 0; i < 300; ++i) {
    const Vec3 point(random.next(), GetParam() ? 0.0 : random.next(), random.next());
    const PhotonSearch search{point, GetParam() ? &normal : nullptr, i % 2 ? 0.05 : 0.3, 60};
    tree.find(search, found);
    std::vector<double> distances;
    for (const Photon& photon : tree.photons()) {
      const Vec3 way = place_of(photon) - point;
      double d = length_squared(way);
      if (search.normal) d += 16.0 * std::fabs(dot(way, normal)) * d;
      if (d < search.radius * search.radius) distances.push_back(d);
    }
    std::sort(distances.begin(), distances.end());
    const std::size_t most = std::min<std::size_t>(distances.size(), 60);
    EXPECT_LE(found.size(), most);
    EXPECT_GE(found.size() + 3, most);
    wanted += most;
    const double rim = most == 60 ? distances[most - 1] : search.radius * search.radius;
    std::size_t near = 0;
    for (const FoundPhotons::One& one : found) {
      EXPECT_LT(one.distance, search.radius * search.radius);
      EXPECT_LE(std::sqrt(one.distance), found.radius());
      near += one.distance <= rim ? 1 : 0;
    }
    missed += most - near;
  }
  EXPECT_GT(wanted, 1000u);
  EXPECT_LT(missed, wanted / 100);
}

TEST_P(UnitPhotonTree, BucketsFindWhatStepsFind) {
  const PhotonTree tree(scattered(20000, GetParam()), PhotonTree::Order::kOfShooting);
  const Vec3 normal(0.0, 1.0, 0.0);
  FoundPhotons fast, slow;
  RandomSequence random(5, RandomSequence::Use::kFilm);
  int others = 0;
  constexpr int kSearches = 2000;
  for (int i = 0; i < kSearches; ++i) {
    PhotonSearch search{{random.next(), GetParam() ? 0.0 : random.next(), random.next()},
                        GetParam() ? &normal : nullptr,
                        0.01 + 0.1 * random.next(),
                        100};
    tree.find(search, fast);
    search.one_by_one = true;
    tree.find(search, slow);
    others += numbers(fast) == numbers(slow) ? 0 : 1;
  }
  EXPECT_LE(others, kSearches / 200);
}

TEST_P(UnitPhotonTree, EveryProcessorFindsTheSame) {
  const auto photons = scattered(5000, GetParam());
  const PhotonTree tree(photons, PhotonTree::Order::kOfShooting);
  const PhotonTree portable(photons, PhotonTree::Order::kOfShooting, true);
  const Vec3 normal(0.6, 0.8, 0.0);
  FoundPhotons one, other;
  RandomSequence random(7, RandomSequence::Use::kFilm);
  for (std::size_t most = 1; most < 150; ++most) {
    const PhotonSearch search{{random.next(), GetParam() ? 0.0 : random.next(), random.next()},
                              GetParam() ? &normal : nullptr,
                              0.5 * random.next(),
                              most};
    tree.find(search, one);
    portable.find(search, other);
    EXPECT_EQ(one.radius(), other.radius());
    ASSERT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end(),
                           [](const auto& a, const auto& b) {
                             return a.number == b.number && a.distance == b.distance;
                           }));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, UnitPhotonTree, ::testing::Values(true, false),
                         [](const auto& one) { return one.param ? "OnFloor" : "InCube"; });

TEST(UnitPhotonMap, FewPhotonsAreSoughtFartherOff) {
  PhotonSettings settings;
  settings.radius = 0.02;
  std::vector<Photon> photons = scattered(20000, true);
  const auto density = photons.size();
  const auto light = make_photon_light({.surface = photons, .media = {}}, settings);
  EXPECT_EQ(light->surface.radius(), 0.02);
  const Vec3 up(0.0, 1.0, 0.0);
  FoundPhotons found, spare;
  // As dense farther off: about 25 are within .02, 226 within .06.
  light->surface.gather({0.5, 0.0, 0.5}, &up, found, spare);
  EXPECT_EQ(found.radius(), 0.02);
  settings.gather_min = 60;
  const auto eager = make_photon_light({.surface = photons, .media = {}}, settings);
  eager->surface.gather({0.5, 0.0, 0.5}, &up, found, spare);
  EXPECT_EQ(found.size(), 100u);
  EXPECT_NEAR(found.radius(), std::sqrt(100.0 / (3.1416 * static_cast<double>(density))), 0.004);
  // Nothing there, and all far off are more than few: nothing.
  eager->surface.gather({-0.03, 0.0, 0.5}, &up, found, spare);
  EXPECT_EQ(found.size(), 0u);
}

TEST(UnitPhotonMap, TheRadiusHoldsAsManyAsAreWanted) {
  const auto light = make_photon_light(
      {.surface = scattered(20000, true), .media = scattered(20000, false)}, PhotonSettings{});
  const double expected = std::sqrt(100.0 / (3.1416 * 20000.0));
  EXPECT_GT(light->surface.radius(), 0.9 * expected);
  EXPECT_LT(light->surface.radius(), 5.0 * expected);  // thin places at the edge enlarge it
  const double in_media = 2.0 * std::cbrt(3.0 * 100.0 / (4.0 * 3.1416 * 20000.0));
  EXPECT_GT(light->media.radius(), 0.9 * in_media);
  EXPECT_LT(light->media.radius(), 12.0 * in_media);
}

TEST(UnitPhotonMap, PhotonsAtOnePlaceGiveNoRadius) {
  const std::vector<Photon> same(500, make_photon({1, 2, 3}, {1, 5, 3}, Rgb(1.0f)));
  const auto light = make_photon_light({.surface = same, .media = {}}, PhotonSettings{});
  EXPECT_TRUE(std::isfinite(light->surface.radius()));
}

}  // namespace
}  // namespace lentray::core::photon_test
