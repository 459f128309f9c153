// The rules of radiosity, each on its own, against numbers that a second program computed from the
// formulae (Halton's, MT19937's) and against cases worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/irradiance/directions.h"
#include "core/irradiance/irradiance_cache.h"
#include "core/irradiance/pretrace.h"
#include "core/irradiance/sample.h"
#include "core/irradiance/sample_store.h"
#include "core/irradiance/settings.h"

using namespace lentray::core;

namespace {

constexpr double kNear = 1e-12;

void expect_near(const Vec3& a, const Vec3& b, double tolerance = kNear) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

DirectionCycle cycle_of(std::size_t length) {
  return DirectionCycle(
      std::make_shared<const std::vector<Vec3>>(cosine_weighted_directions(length)));
}

std::vector<Vec3> directions_about(DirectionCycle& cycle, const Vec3& normal, unsigned rays) {
  GatherDirections directions(cycle, normal, normal, rays);
  std::vector<Vec3> all(rays);
  for (Vec3& direction : all) EXPECT_TRUE(directions.next(direction));
  return all;
}

/// On the plane y = 0, one unit from anything else.
IrradianceSample floor_sample(const Vec3& point = {}) {
  IrradianceSample sample;
  sample.point = point;
  sample.normal = {0.0, 1.0, 0.0};
  sample.light = Rgb(0.5f, 0.25f, 1.0f);
  sample.radius = 1.0f;
  sample.nearest = 0.5f;
  sample.quality = 1.0f;
  return sample;
}

ReuseQuery floor_query(const Vec3& point, double error_bound = 0.5, bool smooth = false) {
  return {point, {0.0, 1.0, 0.0}, error_bound, smooth};
}

}  // namespace

TEST(UnitIrradiance, DirectionsAreHaltonsPoints) {
  const auto directions = cosine_weighted_directions(1600);
  ASSERT_EQ(directions.size(), 1600u);
  expect_near(directions[0], {-0.3535533905932736, 0.7071067811865476, 0.6123724356957946});
  expect_near(directions[1], {-0.2500000000000002, 0.8660254037844386, -0.4330127018922192});
  expect_near(directions[1599], {-0.08282043731081871, 0.9953505192895616, -0.04917437252924277});
  double mean_height = 0.0;
  for (const Vec3& d : directions) mean_height += d.y / 1600.0;
  EXPECT_NEAR(mean_height, 2.0 / 3.0, 1e-3) << "cosine-weighted";
}

TEST(UnitIrradiance, GathersTakeTheNextOfTheCycle) {
  DirectionCycle cycle = cycle_of(7);
  const auto all = cosine_weighted_directions(7);
  const Vec3 up(0.0, 1.0, 0.0);
  expect_near(directions_about(cycle, up, 5).back(), all[4]);
  const auto second = directions_about(cycle, up, 5);
  expect_near(second[0], all[5]);
  expect_near(second[1], all[6]);
  expect_near(second[2], all[0]);
  expect_near(directions_about(cycle, -up, 1)[0], -all[3]);
}

TEST(UnitIrradiance, DirectionsLieAboutTheNormal) {
  const Vec3 pattern = cosine_weighted_directions(1)[0];
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, 0, 1), normalized(Vec3(1, -2, 0.5)),
                             normalized(Vec3(0.1, 0.2, -3))}) {
    DirectionCycle cycle = cycle_of(1);
    const Vec3 direction = directions_about(cycle, normal, 1)[0];
    EXPECT_NEAR(length(direction), 1.0, kNear);
    EXPECT_NEAR(dot(direction, normal), pattern.y, kNear);
  }
  DirectionCycle cycle = cycle_of(1);
  // x: normal x z, z: x x normal.
  expect_near(directions_about(cycle, {1, 0, 0}, 1)[0], {pattern.y, -pattern.x, pattern.z});
  DirectionCycle again = cycle_of(1);
  // x: normal x y, as the normal is near z.
  expect_near(directions_about(again, {0, 0, 1}, 1)[0], {-pattern.x, pattern.z, pattern.y});
}

TEST(UnitIrradiance, NoDirectionGoesBehindTheSurface) {
  DirectionCycle cycle = cycle_of(1600);
  const Vec3 up(0.0, 1.0, 0.0), bent = normalized(Vec3(1.0, 0.5, 0.3));
  GatherDirections directions(cycle, up, bent, 100);
  Vec3 direction;
  Vec3 mean;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(directions.next(direction));
    EXPECT_GT(direction.y, 0.0);
    mean += direction;
  }
  EXPECT_FALSE(directions.about_surface());
  EXPECT_GT(dot(normalized(mean), bent), 0.9);
}

TEST(UnitIrradiance, WithoutDirectionsInFrontTheSurfacesOwnNormalCounts) {
  DirectionCycle cycle = cycle_of(1600);
  const Vec3 up(0.0, 1.0, 0.0);
  GatherDirections directions(cycle, up, -up, 10);  // turned away altogether
  Vec3 direction;
  ASSERT_TRUE(directions.next(direction));
  EXPECT_TRUE(directions.about_surface());
  EXPECT_GT(direction.y, 0.0);
}

TEST(UnitIrradiance, RulesOfDepths) {
  RadiositySettings settings;
  settings.count = 50;
  settings.nearest_count = 7;
  settings.brightness = 1.5;
  EXPECT_EQ(rules_at(settings, 0).rays, 50u);
  EXPECT_EQ(rules_at(settings, 1).rays, 25u);
  EXPECT_EQ(rules_at(settings, 2).rays, 12u);
  EXPECT_EQ(rules_at(settings, 9).rays, 5u);
  EXPECT_EQ(rules_at(settings, 0).wanted, 7.0);
  EXPECT_EQ(rules_at(settings, 1).wanted, 2.0);
  EXPECT_EQ(rules_at(settings, 2).wanted, 1.0);
  EXPECT_EQ(rules_at(settings, 3).error_factor, 8.0);
  EXPECT_DOUBLE_EQ(rules_at(settings, 1).gather_weight, 0.5625);
  EXPECT_NEAR(rules_at(settings, 30).gather_weight, settings.adc_bailout, 1e-9);
  std::vector<int> levels;
  for (int depth = 0; depth < 4; ++depth) levels.push_back(rules_at(settings, depth).gather_level);
  EXPECT_EQ(levels, (std::vector<int>{1, 3, 4, 6}));
}

TEST(UnitIrradiance, ReuseFallsWithDistance) {
  IrradianceSample sample = floor_sample();
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({})), 1.0);
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({0.1, 0, 0})), 0.8);
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({0.0, 0, 0.4})), 1.0 - 0.4 / 0.5);
  EXPECT_EQ(reuse_weight(sample, floor_query({0.5, 0, 0})), 0.0);
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({0.1, 0, 0}, 1.0)), 0.9);
  // Smoothly: 1 - 2t^2, and 2(1 - t)^2 from the middle on.
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({0.1, 0, 0}, 0.5, true)), 0.92);
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({0.25, 0, 0}, 0.5, true)), 0.5);
  EXPECT_NEAR(reuse_weight(sample, floor_query({0.4, 0, 0}, 0.5, true)), 0.08, kNear);
  // Next to nothing is nothing.
  EXPECT_EQ(reuse_weight(sample, floor_query({0.4999, 0, 0})), 0.0);
}

TEST(UnitIrradiance, ReuseIsLessTowardsTheNearestThing) {
  IrradianceSample sample = floor_sample();
  sample.to_nearest = {1.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({0.1, 0, 0})), 1.0 - 0.1 / 0.5 / 0.5);
  EXPECT_DOUBLE_EQ(reuse_weight(sample, floor_query({-0.1, 0, 0})), 0.8);
  EXPECT_EQ(reuse_weight(sample, floor_query({0.3, 0, 0})), 0.0);
}

TEST(UnitIrradiance, ReuseFallsAsSurfacesTurn) {
  const IrradianceSample sample = floor_sample();
  const double angle = 0.1;
  ReuseQuery turned = floor_query({});
  turned.normal = {std::sin(angle), std::cos(angle), 0.0};
  const double error = 2.0 * std::sqrt(1.0 - std::cos(angle));
  EXPECT_NEAR(reuse_weight(sample, turned), 1.0 - error / 0.5, kNear);
}

TEST(UnitIrradiance, SamplesBehindThePlaceDoNotCount) {
  const IrradianceSample sample = floor_sample();
  // Seen from a place below, a sample's surface may be what shades it.
  EXPECT_EQ(reuse_weight(sample, floor_query({0.0, -0.1, 0.0})), 0.0);
  EXPECT_GT(reuse_weight(sample, floor_query({0.0, 0.1, 0.0})), 0.0);
  // Fading in from a cosine of -0.05 to 0.
  const double cosine = -0.025, distance = 0.1;
  const Vec3 place(distance * std::sqrt(1.0 - cosine * cosine), distance * cosine, 0.0);
  EXPECT_NEAR(reuse_weight(sample, floor_query(place)), 0.8 * 0.5, 1e-9);
}

TEST(UnitIrradiance, StoreSumsWhatIsNear) {
  RadiositySettings settings;
  settings.error_bound = 0.5;
  SampleStore store(settings, 0);
  store.add(floor_sample({0.0, 0.0, 0.0}));
  IrradianceSample dark = floor_sample({0.2, 0.0, 0.0});
  dark.light = Rgb(0.0f);
  dark.quality = 0.5f;
  store.add(dark);
  store.add(floor_sample({100.0, 0.0, 0.0}));
  const ReuseQuery query = floor_query({0.1, 0.0, 0.0});
  const Reuse both = store.find(query);
  EXPECT_DOUBLE_EQ(both.weight, 0.8 + 0.8 * 0.5);
  EXPECT_NEAR(both.light.r, 0.5 * 0.8 / 1.2, 1e-6);
  EXPECT_DOUBLE_EQ(store.find(query, 1).weight, 0.8) << "the first sample alone";
  EXPECT_EQ(store.find(query, 0).weight, 0.0);
  EXPECT_EQ(store.find(floor_query({50.0, 0.0, 0.0})).weight, 0.0);
}

TEST(UnitIrradiance, StoreAgreesWithASearchOfAllSamples) {
  RadiositySettings settings;
  settings.error_bound = 0.4;
  SampleStore store(settings, 0);
  std::vector<IrradianceSample> all;
  for (int i = 0; i < 400; ++i) {
    IrradianceSample sample =
        floor_sample({std::fmod(i * 0.618, 1.0) * 4 - 2, 0.0, std::fmod(i * 0.414, 1.0) * 4 - 2});
    sample.radius = 0.05f + 0.002f * static_cast<float>(i);
    all.push_back(sample);
    store.add(sample);
  }
  for (int i = 0; i < 100; ++i) {
    const ReuseQuery query = floor_query(
        {std::fmod(i * 0.318, 1.0) * 4 - 2, 0.0, std::fmod(i * 0.77, 1.0) * 4 - 2}, 0.4);
    double sum = 0.0;
    for (const IrradianceSample& sample : all) sum += reuse_weight(sample, query);
    EXPECT_NEAR(store.find(query).weight, sum, 1e-12);
  }
}

TEST(UnitIrradiance, DeepSamplesAreSeenFromTheirCellAlone) {
  RadiositySettings settings;
  settings.error_bound = 0.5;
  SampleStore store(settings, 1);
  // The box of half side 0.5 x 2 / 8 = 0.125 fits a cell of side 0.25, which reaches from
  // -0.125 to 0.375 about the sample's place in it.
  store.add(floor_sample({0.125, 0.125, 0.125}));
  ReuseQuery query = floor_query({0.36, 0.125, 0.125}, 1.0);
  EXPECT_GT(store.find(query).weight, 0.0);
  query.point.x = 0.39;
  EXPECT_EQ(store.find(query).weight, 0.0);
  EXPECT_GT(reuse_weight(floor_sample({0.125, 0.125, 0.125}), query), 0.0)
      << "by the rule of reuse";
}

TEST(UnitIrradiance, LevelsOfThePretrace) {
  RadiositySettings settings;
  settings.pretrace_start = 0.125;
  settings.pretrace_end = 0.0625;
  auto levels = pretrace_levels(settings, 48, 48);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].spacing, 6.0);
  EXPECT_EQ(levels[1].spacing, 3.0);
  settings.pretrace_end = 0.001;  // never less than a pixel
  levels = pretrace_levels(settings, 160, 120);
  ASSERT_EQ(levels.size(), 6u);
  EXPECT_EQ(levels[0].spacing, 20.0);
  EXPECT_EQ(levels[5].spacing, 1.0);
}

TEST(UnitIrradiance, PlacesOfThePretrace) {
  RadiositySettings settings;
  settings.pretrace_start = 0.125;
  settings.pretrace_end = 0.0625;
  const auto levels = pretrace_levels(settings, 48, 48);
  const auto blocks = pretrace_blocks(48, 48);
  ASSERT_EQ(blocks.size(), 4u);
  const JitterCycle cycle;
  JitterRun first_run(cycle, levels[0], blocks[0]);
  const auto first = pretrace_places(levels[0], blocks[0], {}, first_run);
  ASSERT_EQ(first.size(), 36u);
  EXPECT_NEAR(first[0].column, 3.935389873571694, 1e-9);
  EXPECT_NEAR(first[0].row, 3.929777067620307, 1e-9);
  EXPECT_NEAR(first[35].column, 32.8174623218365, 1e-9);
  EXPECT_NEAR(first[35].row, 32.37374520674348, 1e-9);
  JitterRun last_run(cycle, levels[1], blocks[3]);
  const auto last = pretrace_places(levels[1], blocks[3], {}, last_run);
  ASSERT_EQ(last.size(), 25u);
  EXPECT_NEAR(last[24].column, 47.141681568231434, 1e-9);
  EXPECT_NEAR(last[24].row, 46.010190221015364, 1e-9);
}

TEST(UnitIrradiance, PartsThatAskForNothingAreLeft) {
  EXPECT_FALSE(goes_on({9, 0, 0.0}, 0));
  EXPECT_TRUE(goes_on({8, 0, 0.0}, 0)) << "too few places to tell";
  EXPECT_TRUE(goes_on({9, 1, 100.0}, 0));
  // With a second number of nearest_count those that have found enough are left, too.
  EXPECT_TRUE(goes_on({9, 4, 7.9}, 2));
  EXPECT_FALSE(goes_on({9, 4, 8.0}, 2));
}

TEST(UnitIrradiance, BlocksAreCutAsPlacesLieCloser) {
  PretraceBlock block{{32, 0, 64, 32}, 1};
  const PretraceLevel level{0, 8.0, 4.0};
  end_level(block, level, {{0, 0}}, 0);
  EXPECT_EQ(block.parts.size(), 1u) << "never without a second number of nearest_count";
  end_level(block, level, {{0, 0}}, 3);
  // Eight places along the side: two parts of four.
  EXPECT_EQ(block.across, 2u);
  EXPECT_EQ(block.down, 2u);
  ASSERT_EQ(block.parts.size(), 4u);
  EXPECT_EQ(block.parts[1].column, 1u);
  EXPECT_EQ(block.parts[1].row, 0u);
  const JitterCycle cycle;
  const PretraceLevel next{1, 4.0, 2.0};
  JitterRun jitter(cycle, next, block);
  const auto places = pretrace_places(next, block, block.parts[3], jitter);
  ASSERT_EQ(places.size(), 16u);
  for (const PretracePlace& place : places) {
    EXPECT_GE(place.column, 48.0);
    EXPECT_GE(place.row, 16.0);
  }
}

TEST(UnitIrradiance, APixelSeesWhatItSawInThePass) {
  RadiositySettings settings;
  settings.recursion_limit = 3;
  IrradianceCache cache(settings, {});
  EXPECT_EQ(cache.depths(), 3);
  EXPECT_EQ(cache.sight({0, 0}).samples, SampleStore::kAll);
  cache.begin_sights(4, 2);
  cache.see({1, 1}, 17, {});
  cache.see({2, 1}, 18, {{Rgb(0.5f), 0.75, true}});
  EXPECT_EQ(cache.sight({1, 1}).samples, 17u);
  EXPECT_EQ(cache.sight({1, 1}).gathered, nullptr);
  ASSERT_NE(cache.sight({2, 1}).gathered, nullptr);
  EXPECT_EQ(cache.sight({2, 1}).gathered->front().quality, 0.75);
  EXPECT_EQ(cache.sight({4, 1}).samples, SampleStore::kAll) << "not of that picture";
}
