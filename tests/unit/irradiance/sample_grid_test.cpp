// That the search of samples leaves out none that the rule of reuse wants, whatever lies how, and that a
// picture's query gets the answer of the pass only if it is the same.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/irradiance/irradiance_cache.h"
#include "core/irradiance/sample_store.h"

using namespace lentray::core;

namespace {

/// Samples and places about corners of walls and balls, of any radius and with anything near.
struct GridStage {
  explicit GridStage(double s) : scale(s) {}
  double number() { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }
  Vec3 any_direction() { return normalized(Vec3(number() - 0.5, number() - 0.5, number() - 0.51)); }
  void place(Vec3& point, Vec3& normal) {
    const double a = 4.0 * number() - 2.0, b = 4.0 * number() - 2.0;
    switch (static_cast<int>(3.0 * number())) {
      case 0: point = {a, 0.0, b}, normal = {0.0, 1.0, 0.0}; break;
      case 1: point = {2.0, a + 2.0, b}, normal = {-1.0, 0.0, 0.0}; break;
      default: normal = any_direction(), point = normal * 0.7 + Vec3(0.0, 0.7, 0.0);
    }
    point = (point + normal * (0.03 * number() - 0.015)) * scale;
  }
  IrradianceSample sample() {
    IrradianceSample one;
    place(one.point, one.normal);
    one.radius = static_cast<float>(scale * (0.05 + 0.5 * number() * number()));
    one.nearest = static_cast<float>(3.0 * number() * one.radius);
    if (number() < 0.8) one.to_nearest = any_direction();
    one.quality = static_cast<float>(number());
    one.light = Rgb(1.0f);
    return one;
  }
  const double scale;
  std::mt19937 random{7};
};

}  // namespace

class UnitSampleGrid : public ::testing::TestWithParam<double> {};

TEST_P(UnitSampleGrid, LeavesOutNoneThatIsOfUse) {
  GridStage stage(GetParam());
  RadiositySettings settings;
  settings.error_bound = 0.6;
  SampleStore store(settings, 0);
  for (int i = 0; i < 600; ++i) store.add(stage.sample());
  int found = 0;
  for (int i = 0; i < 5000; ++i) {
    // The bound is the greatest for which the octree's cells hold all that the rule wants.
    ReuseQuery query{{}, {}, i % 2 == 0 ? 0.6 : 0.25, i % 3 == 0};
    stage.place(query.point, query.normal);
    const std::size_t limit = i % 4 == 0 ? 300 : SampleStore::kAll;
    double sum = 0.0;
    for (std::size_t k = 0; k < store.samples().size() && k < limit; ++k) {
      sum += reuse_weight(store.samples()[k], query) * store.samples()[k].quality;
    }
    EXPECT_NEAR(store.find(query, limit).weight, sum, 1e-12 * (1.0 + sum)) << i;
    if (sum > 0.0) ++found;
  }
  EXPECT_GT(found, 500);
}

INSTANTIATE_TEST_SUITE_P(Scales, UnitSampleGrid, ::testing::Values(1e-3, 1.0, 30.0, 1e4));

TEST(UnitIrradianceAnswers, AreThoseOfThePixelThatWasSeen) {
  IrradianceCache cache(RadiositySettings{}, {});
  cache.begin_sights(3, 1);
  cache.see({0, 0}, 1, {});
  const std::vector<KnownAnswer> two{{5, Rgb(0.25f), false}, {6, Rgb(0.5f), true}};
  cache.answer(two);
  cache.see({1, 0}, 2, {});
  cache.answer({});
  cache.see({2, 0}, 2, {});
  cache.answer({two.data(), 1});
  ASSERT_EQ(cache.sight({0, 0}).answers.size(), 2u);
  EXPECT_EQ(cache.sight({0, 0}).answers[1].query, 6u);
  EXPECT_TRUE(cache.sight({0, 0}).answers[1].was_gathered);
  EXPECT_TRUE(cache.sight({1, 0}).answers.empty());
  ASSERT_EQ(cache.sight({2, 0}).answers.size(), 1u);
  EXPECT_EQ(cache.sight({2, 0}).answers[0].light, Rgb(0.25f));
}
