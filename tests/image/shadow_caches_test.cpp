// What caches and orders are worth, by counts alone: hits against their upper bound on the SPD
// scenes, and what Shadow_Cache=auto and Pixel_Order=auto and adaptive decide.
#include <gtest/gtest.h>

#include <map>
#include <span>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

using ShadowCachesWords = std::vector<std::string>;

struct Small {
  const char* scene;
  int size;
};
/// Small enough for a test, with as many pixels an object as the published ones have in a print.
constexpr Small kSpd[] = {{"balls", 2}, {"gears", 2}, {"rings", 2}, {"tetra", 3},
                          {"tree", 6},  {"mount", 4}, {"teapot", 2}};

/// How much is rendered: all scenes in large pictures, or a few in small ones.
struct ShadowCachesExtent {
  std::span<const Small> scenes;
  const char *width, *height;
};
constexpr ShadowCachesExtent kEverything{kSpd, "+W600", "+H400"};
constexpr ShadowCachesExtent kFew{std::span(kSpd, 2), "+W300", "+H200"};

class ImageShadowCaches : public ::testing::Test {
 protected:
  void expect_nearly_all_hits(const ShadowCachesExtent& extent) const;
  void expect_nearly_all_hits_of_auto(const ShadowCachesExtent& extent) const;
  void expect_auto_to_test_least(const ShadowCachesExtent& extent) const;
  void expect_auto_worth_having(std::span<const Small> scenes) const;
  void expect_cascade_between(const ShadowCachesExtent& extent) const;
  void expect_order_of_auto_to_test_least(std::span<const Small> scenes) const;
  void expect_adaptive_strips_best(std::span<const Small> scenes) const;
  nlohmann::json run(const Small& small, ShadowCachesWords more) const {
    return run_whole(small, std::move(more)).at("shadow");
  }
  nlohmann::json run_whole(const Small& small, ShadowCachesWords more) const {
    ShadowCachesWords words{
        "+I" + (source_folder() / "scenes" / (std::string("spd_") + small.scene + ".pov")).string(),
        "Declare=Size=" + std::to_string(small.size),
        "Declare=Lenticular_Camera=1",
        "-F",
        "-V",
        "+WT1",
        "Shadow_Log=On",
        "Statistics_File=s.json"};
    words.insert(words.end(), more.begin(), more.end());
    static std::map<ShadowCachesWords, nlohmann::json> known;  // tests share some runs
    const auto [at, is_new] = known.try_emplace(words);
    if (is_new) {
      const auto result = run_lentray(words, m_folder.path());
      EXPECT_EQ(result.status, 0) << result.output;
      at->second = nlohmann::json::parse(tool::read_text(m_folder / "s.json"));
    }
    return at->second;
  }
  static double number(const nlohmann::json& j) { return j.get<double>(); }
  static double of_bound(const nlohmann::json& s) {
    return number(s.at("cache").at("hits")) / number(s.at("log").at("most_hits"));
  }
  static double tests(const nlohmann::json& s) { return number(s.at("log").at("tests")); }

 private:
  const tool::TemporaryFolder m_folder;
};

/// The same of all scenes.
class SlowShadowCaches : public ImageShadowCaches {};

void ImageShadowCaches::expect_nearly_all_hits(const ShadowCachesExtent& extent) const {
  for (const Small& small : extent.scenes) {
    for (const char* order : {"rows", "views", "columns", "adaptive"}) {
      const auto s = run(small, {extent.width, extent.height, "-UL", "Shadow_Cache=grid",
                                 std::string("Pixel_Order=") + order});
      EXPECT_GE(of_bound(s), 0.95) << small.scene << " " << order;
    }
  }
}

TEST_F(ImageShadowCaches, TheGridHasNearlyAllHitsThereCanBeInAnyOrder) {
  expect_nearly_all_hits(kFew);
}
TEST_F(SlowShadowCaches, TheGridHasNearlyAllHitsThereCanBeInAnyOrder) {
  expect_nearly_all_hits(kEverything);
}

// Light buffers foresee what blocks.
void ImageShadowCaches::expect_nearly_all_hits_of_auto(const ShadowCachesExtent& extent) const {
  for (const Small& small : extent.scenes) {
    for (const char* order : {"rows", "views", "columns", "adaptive"}) {
      const auto s = run(small, {extent.width, extent.height, std::string("Pixel_Order=") + order});
      EXPECT_GE(of_bound(s), 0.95) << small.scene << " " << order;
    }
  }
}

TEST_F(ImageShadowCaches, AutoHasThemTooWithLightBuffersInAnyOrder) {
  expect_nearly_all_hits_of_auto(kFew);
}
TEST_F(SlowShadowCaches, AutoHasThemTooWithLightBuffersInAnyOrder) {
  expect_nearly_all_hits_of_auto(kEverything);
}

void ImageShadowCaches::expect_auto_to_test_least(const ShadowCachesExtent& extent) const {
  // Of shapes, by searches and by probes. (A volume that the point is outside of is a test of bounds.)
  const auto tests_with = [&](const Small& small, const char* cache) {
    const auto s =
        run_whole(small, {extent.width, extent.height, std::string("Shadow_Cache=") + cache});
    return number(s.at("tests").at("primitives")) + number(s.at("shadow").at("cache").at("probes"));
  };
  constexpr const char* kCaches[] = {"last", "neighbourhood", "grid", "cascade"};
  double of_auto = 0.0;
  std::map<std::string, double> of_cache;
  for (const Small& small : extent.scenes) {
    of_auto += tests_with(small, "auto");
    for (const char* cache : kCaches) of_cache[cache] += tests_with(small, cache);
  }
  for (const auto& [cache, tests] : of_cache) EXPECT_LT(of_auto, tests) << cache;
}
TEST_F(ImageShadowCaches, WithLightBuffersAutoTestsLessThanAnyCache) {
  expect_auto_to_test_least(kFew);
}
TEST_F(SlowShadowCaches, WithLightBuffersAutoTestsLessThanAnyCache) {
  expect_auto_to_test_least(kEverything);
}

// Which cache it takes is its own affair: it must be worth having.
void ImageShadowCaches::expect_auto_worth_having(std::span<const Small> scenes) const {
  double of_auto = 0.0, of_last = 0.0;
  for (const Small& small : scenes) {
    const auto with = [&](const char* cache) {
      return run(small, {"+W240", "+H180", "-UL", std::string("Shadow_Cache=") + cache});
    };
    const auto own = with("auto"), last = with("last");
    EXPECT_GT(of_bound(own), of_bound(last)) << small.scene;
    of_auto += tests(own);
    of_last += tests(last);
  }
  EXPECT_LT(of_auto, of_last);
}

TEST_F(ImageShadowCaches, WithoutLightBuffersAutoFindsMoreThanTheLastBlockerAndTestsLess) {
  expect_auto_worth_having(kFew.scenes);
}
TEST_F(SlowShadowCaches, WithoutLightBuffersAutoFindsMoreThanTheLastBlockerAndTestsLess) {
  expect_auto_worth_having(kSpd);
}

// Also where next to nothing is blocked, as of tetra and tree.
TEST_F(ImageShadowCaches, WithoutLightBuffersAutoTestsNoMoreThanWithoutACache) {
  for (const Small& small :
       {Small{"tetra", 3}, Small{"tetra", 5}, Small{"tree", 6}, Small{"tree", 8}}) {
    const ShadowCachesWords words{"+W300", "+H300", "-UL"};
    ShadowCachesWords off = words;
    off.push_back("Shadow_Cache=off");
    EXPECT_LE(tests(run(small, words)), tests(run(small, off))) << small.scene << small.size;
  }
}

// Where it is light nothing is asked: of tree's shadow rays 1 in 70 is blocked. `last` asks everywhere.
TEST_F(ImageShadowCaches, TheNeighbourhoodAsksLessThanTheLastBlockerAndFindsMore) {
  const auto with = [&](const char* cache) {
    return run({"tree", 8}, {"+W300", "+H300", "-UL", std::string("Shadow_Cache=") + cache})
        .at("cache");
  };
  const auto last = with("last");
  for (const char* cache : {"neighbourhood", "cascade"}) {
    const auto asked = with(cache);
    EXPECT_LT(number(asked.at("probes")), number(last.at("probes"))) << cache;
    EXPECT_GT(number(asked.at("hits")), number(last.at("hits"))) << cache;
  }
}

void ImageShadowCaches::expect_cascade_between(const ShadowCachesExtent& extent) const {
  for (const Small& small : extent.scenes) {
    const auto with = [&](const char* cache) {
      return run(small, {extent.width, extent.height, "-UL", std::string("Shadow_Cache=") + cache})
          .at("cache");
    };
    const auto near = with("neighbourhood"), cascade = with("cascade"), grid = with("grid");
    EXPECT_GT(number(cascade.at("hits")), number(near.at("hits"))) << small.scene;
    EXPECT_LT(number(cascade.at("hits")), number(grid.at("hits"))) << small.scene;
    EXPECT_LT(number(cascade.at("probes")), number(grid.at("probes"))) << small.scene;
  }
}

TEST_F(ImageShadowCaches, TheCascadeIsBetweenTheNeighbourhoodAndTheGrid) {
  expect_cascade_between(kFew);
}
TEST_F(SlowShadowCaches, TheCascadeIsBetweenTheNeighbourhoodAndTheGrid) {
  expect_cascade_between({kSpd, "+W400", "+H300"});
}

// By counts of the cache `last`. Which of the orders it is does not matter.
void ImageShadowCaches::expect_order_of_auto_to_test_least(std::span<const Small> scenes) const {
  std::map<std::string, double> of_order;
  for (const Small& small : scenes) {
    for (const char* order :
         {"auto", "rows", "views", "columns", "tiles", "serpentine", "hilbert", "strips(4,32)"}) {
      of_order[order] += tests(run(small, {"+W300", "+H200", "-UL", "Shadow_Cache=last",
                                           std::string("Pixel_Order=") + order}));
    }
  }
  for (const auto& [order, all] : of_order) EXPECT_LE(of_order["auto"], all) << order;
}

TEST_F(ImageShadowCaches, TheOrderOfAutoOnASheetTestsNoMoreThanAnyOther) {
  expect_order_of_auto_to_test_least(kFew.scenes);
}
TEST_F(SlowShadowCaches, TheOrderOfAutoOnASheetTestsNoMoreThanAnyOther) {
  expect_order_of_auto_to_test_least(kSpd);
}

void ImageShadowCaches::expect_adaptive_strips_best(std::span<const Small> scenes) const {
  double adaptive = 0.0, fixed = 0.0, rows = 0.0;
  for (const Small& small : scenes) {
    const ShadowCachesWords more{"+W300", "+H200", "-UL", "Shadow_Cache=last"};
    const auto hits = [&](const char* order) {
      ShadowCachesWords words = more;
      words.push_back(std::string("Pixel_Order=") + order);
      return of_bound(run(small, words));
    };
    adaptive += hits("adaptive");
    fixed += hits("strips(4,32)");
    rows += hits("rows");
  }
  EXPECT_GT(adaptive, fixed);
  EXPECT_GT(fixed, rows);
}

TEST_F(ImageShadowCaches, AdaptiveStripsBeatFixedOnes) { expect_adaptive_strips_best(kFew.scenes); }
TEST_F(SlowShadowCaches, AdaptiveStripsBeatFixedOnes) { expect_adaptive_strips_best(kSpd); }

}  // namespace
}  // namespace lentray::test
