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

class ImageShadowCaches : public ::testing::Test {
 protected:
  void expect_nearly_all_hits(std::span<const Small> scenes) const;
  void expect_nearly_all_hits_of_auto(std::span<const Small> scenes) const;
  void expect_auto_to_test_least(std::span<const Small> scenes) const;
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
    const auto result = run_lentray(words, m_folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
    return nlohmann::json::parse(tool::read_text(m_folder / "s.json"));
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
constexpr std::span kFew(kSpd, 2);

void ImageShadowCaches::expect_nearly_all_hits(std::span<const Small> scenes) const {
  for (const Small& small : scenes) {
    for (const char* order : {"rows", "views", "columns", "adaptive"}) {
      const auto s = run(small, {"+W600", "+H400", "-UL", "Shadow_Cache=grid",
                                 std::string("Pixel_Order=") + order});
      EXPECT_GE(of_bound(s), 0.95) << small.scene << " " << order;
    }
  }
}

TEST_F(ImageShadowCaches, TheGridHasNearlyAllHitsThereCanBeInAnyOrder) {
  expect_nearly_all_hits(kFew);
}
TEST_F(SlowShadowCaches, TheGridHasNearlyAllHitsThereCanBeInAnyOrder) {
  expect_nearly_all_hits(kSpd);
}

// Light buffers foresee what blocks; nothing is remembered.
void ImageShadowCaches::expect_nearly_all_hits_of_auto(std::span<const Small> scenes) const {
  for (const Small& small : scenes) {
    for (const char* order : {"rows", "views", "columns", "adaptive"}) {
      const auto s = run(small, {"+W600", "+H400", std::string("Pixel_Order=") + order});
      EXPECT_GE(of_bound(s), 0.95) << small.scene << " " << order;
      EXPECT_EQ(s.at("cache").at("probes"), 0) << small.scene;
      EXPECT_EQ(s.at("auto").at("cached"), 0) << small.scene;
    }
  }
}

TEST_F(ImageShadowCaches, AutoHasThemTooWithLightBuffersInAnyOrder) {
  expect_nearly_all_hits_of_auto(kFew);
}
TEST_F(SlowShadowCaches, AutoHasThemTooWithLightBuffersInAnyOrder) {
  expect_nearly_all_hits_of_auto(kSpd);
}

void ImageShadowCaches::expect_auto_to_test_least(std::span<const Small> scenes) const {
  // Of shapes, by searches and by probes. (A volume that the point is outside of is a test of bounds.)
  const auto tests_with = [&](const Small& small, const char* cache) {
    const auto s = run_whole(small, {"+W600", "+H400", std::string("Shadow_Cache=") + cache});
    return number(s.at("tests").at("primitives")) + number(s.at("shadow").at("cache").at("probes"));
  };
  constexpr const char* kCaches[] = {"last", "neighbourhood", "grid", "cascade"};
  double of_auto = 0.0;
  std::map<std::string, double> of_cache;
  for (const Small& small : scenes) {
    const double tests = tests_with(small, "auto");
    EXPECT_EQ(tests, tests_with(small, "off")) << small.scene;
    of_auto += tests;
    for (const char* cache : kCaches) of_cache[cache] += tests_with(small, cache);
  }
  for (const auto& [cache, tests] : of_cache) EXPECT_LT(of_auto, tests) << cache;
}
TEST_F(ImageShadowCaches, WithLightBuffersAutoAsksNoCacheAndTestsLeast) {
  expect_auto_to_test_least(kFew);
}
TEST_F(SlowShadowCaches, WithLightBuffersAutoAsksNoCacheAndTestsLeast) {
  expect_auto_to_test_least(kSpd);
}

// The rule: without a light buffer, what `neighbourhood` does.
TEST_F(ImageShadowCaches, WithoutLightBuffersAutoIsTheNeighbourhood) {
  for (const Small& small : kSpd) {
    const auto with = [&](const char* cache) {
      return run(small, {"+W240", "+H180", "-UL", std::string("Shadow_Cache=") + cache});
    };
    const auto s = with("auto");
    EXPECT_EQ(s.at("auto").at("cached"), s.at("rays")) << small.scene;
    EXPECT_EQ(s.at("cache"), with("neighbourhood").at("cache")) << small.scene;
    EXPECT_GT(number(s.at("cache").at("hits")), 0.0) << small.scene;
  }
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

TEST_F(ImageShadowCaches, TheCascadeIsBetweenTheNeighbourhoodAndTheGrid) {
  for (const Small& small : kSpd) {
    const auto with = [&](const char* cache) {
      return run(small, {"+W400", "+H300", "-UL", std::string("Shadow_Cache=") + cache})
          .at("cache");
    };
    const auto near = with("neighbourhood"), cascade = with("cascade"), grid = with("grid");
    EXPECT_GT(number(cascade.at("hits")), number(near.at("hits"))) << small.scene;
    EXPECT_LT(number(cascade.at("hits")), number(grid.at("hits"))) << small.scene;
    EXPECT_LT(number(cascade.at("probes")), number(grid.at("probes"))) << small.scene;
  }
}

// The rule of Pixel_Order=auto: serpentine on a sheet. Counts of the cache `last`.
TEST_F(ImageShadowCaches, TheOrderOfAutoOnASheetIsSerpentineWhichTestsLeast) {
  std::map<std::string, double> of_order;
  for (const Small& small : kSpd) {
    for (const char* order :
         {"auto", "rows", "views", "columns", "tiles", "serpentine", "hilbert", "strips(4,32)"}) {
      of_order[order] += tests(run(small, {"+W300", "+H200", "-UL", "Shadow_Cache=last",
                                           std::string("Pixel_Order=") + order}));
    }
    EXPECT_EQ(of_order["auto"], of_order["serpentine"]) << small.scene;
  }
  for (const auto& [order, all] : of_order) EXPECT_LE(of_order["auto"], all) << order;
}

TEST_F(ImageShadowCaches, AdaptiveStripsBeatFixedOnes) {
  double adaptive = 0.0, fixed = 0.0, rows = 0.0;
  for (const Small& small : kSpd) {
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

}  // namespace
}  // namespace lentray::test
