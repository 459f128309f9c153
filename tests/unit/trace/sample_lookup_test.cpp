// What was found for a query ahead of time, while samples go on being added.
#include "core/trace/sample_lookup.h"

#include <gtest/gtest.h>

#include <random>

namespace lentray::core {
namespace {

class LookupStage {
 public:
  explicit LookupStage(bool is_last) : lookup(cache, 0, is_last) {}
  void add(int count) {
    for (int i = 0; i < count; ++i) add_at(place());
  }
  void add_at(const Vec3& point) {
    IrradianceSample sample;
    sample.point = point;
    sample.normal = Vec3(0, 1, 0);
    sample.to_nearest = normalized(Vec3(number(), number(), 1.5));
    sample.light = Rgb(static_cast<float>(number() + 1.0), 0.5f, 0.25f);
    sample.radius = 0.3f;
    sample.nearest = 0.2f;
    sample.quality = 0.9f;
    cache.store(0).add(sample);
  }
  IndirectQuery query() { return {place(), Vec3(0, 1, 0), Vec3(0, 1, 0), 0.2}; }
  Vec3 place() { return {4.0 * number(), 0.01 * number(), 4.0 * number()}; }

  IrradianceCache cache{RadiositySettings(), Vec3(0, 5, 0)};
  SampleLookup lookup;

 private:
  double number() { return m_numbers(m_random); }
  std::mt19937 m_random{7};
  std::uniform_real_distribution<double> m_numbers{-1.0, 1.0};
};

bool same(const Reuse& a, const Reuse& b) {
  return a.weight == b.weight && a.light.r == b.light.r && a.light.g == b.light.g &&
         a.light.b == b.light.b;
}

}  // namespace

TEST(UnitSampleLookup, WhatIsFoundEarlyIsWhatIsFoundInTurn) {
  for (const bool is_last : {false, true}) {
    for (const int added : {0, 3, 16, 17, 60}) {
      LookupStage stage(is_last);
      stage.add(400);
      std::vector<IndirectQuery> queries;
      std::vector<EarlyReuse> early;
      for (int i = 0; i < 400; ++i) {
        queries.push_back(stage.query());
        early.push_back(stage.lookup.find_early(queries.back()));
      }
      stage.add(added);
      int changed = 0;
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const Reuse now = stage.lookup.find(queries[i]);
        EXPECT_TRUE(same(stage.lookup.find(queries[i], early[i]), now));
        if (!same(early[i].reuse, now)) ++changed;
      }
      EXPECT_EQ(changed > 0, added > 0) << added << " samples were added";
    }
  }
}

TEST(UnitSampleLookup, ASampleAtThePlaceCountsAtOnce) {
  LookupStage stage(false);
  const IndirectQuery query = stage.query();
  const EarlyReuse early = stage.lookup.find_early(query);
  EXPECT_EQ(early.reuse.weight, 0.0);
  stage.add_at(query.point);
  EXPECT_GT(stage.lookup.find(query, early).weight, 0.0);
}

TEST(UnitSampleLookup, WhatWasNotAskedEarlyIsFoundInTurn) {
  LookupStage stage(true);
  stage.add(300);
  for (int i = 0; i < 50; ++i) {
    const IndirectQuery query = stage.query();
    EXPECT_TRUE(same(stage.lookup.find(query, EarlyReuse()), stage.lookup.find(query)));
  }
}

}  // namespace lentray::core
