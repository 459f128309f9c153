// What caches and orders are worth, by counts alone: hits against their upper bound on the SPD
// scenes, and what Shadow_Cache=auto and Pixel_Order=auto and adaptive decide.
#include <gtest/gtest.h>

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

TEST_F(ImageShadowCaches, TheGridHasNearlyAllHitsThereCanBeInAnyOrder) {
  for (const Small& small : kSpd) {
    for (const char* order : {"rows", "views", "columns", "adaptive"}) {
      const auto s = run(small, {"+W600", "+H400", "-UL", "Shadow_Cache=grid",
                                 std::string("Pixel_Order=") + order});
      EXPECT_GE(of_bound(s), 0.95) << small.scene << " " << order;
    }
  }
}

// Light buffers foresee what blocks; nothing is remembered.
TEST_F(ImageShadowCaches, AutoHasThemTooWithLightBuffersInAnyOrder) {
  for (const Small& small : kSpd) {
    for (const char* order : {"rows", "views", "columns", "adaptive"}) {
      const auto s = run(small, {"+W600", "+H400", std::string("Pixel_Order=") + order});
      EXPECT_GE(of_bound(s), 0.95) << small.scene << " " << order;
      EXPECT_EQ(s.at("cache").at("probes"), 0) << small.scene;
      EXPECT_EQ(s.at("auto").at("cached"), 0) << small.scene;
    }
  }
}

TEST_F(ImageShadowCaches, WithLightBuffersAutoNeedsHardlyMoreTestsThanTheBest) {
  for (const Small& small : kSpd) {
    // Of shapes, by searches and by probes. (A volume that the point is outside of is a test of bounds.)
    const auto with = [&](const char* cache) {
      const auto s = run_whole(small, {"+W600", "+H400", std::string("Shadow_Cache=") + cache});
      return number(s.at("tests").at("primitives")) +
             number(s.at("shadow").at("cache").at("probes"));
    };
    const double least = with("auto");
    EXPECT_EQ(least, with("off")) << small.scene;
    for (const char* other : {"last", "neighbourhood", "grid"}) {
      EXPECT_LE(least, 1.03 * with(other)) << small.scene << " " << other;
    }
  }
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

// Where it brings nothing, as of tetra and tree, of which little is blocked, it hardly tests more.
TEST_F(ImageShadowCaches, WithoutLightBuffersAutoTestsHardlyMoreWhereNothingIsGained) {
  for (const Small& small :
       {Small{"tetra", 3}, Small{"tetra", 5}, Small{"tree", 6}, Small{"tree", 8}}) {
    const ShadowCachesWords words{"+W300", "+H300", "-UL"};
    ShadowCachesWords off = words;
    off.push_back("Shadow_Cache=off");
    EXPECT_LE(tests(run(small, words)), 1.01 * tests(run(small, off))) << small.scene << small.size;
  }
}

// Where it is light nothing is asked: of tree's shadow rays 1 in 70 is blocked.
TEST_F(ImageShadowCaches, TheNeighbourhoodAsksWhereItIsDarkOnly) {
  for (const char* cache : {"neighbourhood", "cascade"}) {
    const auto s =
        run({"tree", 8}, {"+W300", "+H300", "-UL", std::string("Shadow_Cache=") + cache});
    EXPECT_LE(number(s.at("cache").at("probes")), 3.0 * number(s.at("blocked"))) << cache;
    EXPECT_GE(of_bound(s), 0.7) << cache;
  }
}

TEST_F(ImageShadowCaches, TheCascadeHasMostHitsOfTheGridWithFewerProbes) {
  for (const Small& small : kSpd) {
    const auto with = [&](const char* cache) {
      return run(small, {"+W400", "+H300", "-UL", std::string("Shadow_Cache=") + cache});
    };
    const auto cascade = with("cascade"), grid = with("grid");
    EXPECT_GE(of_bound(cascade), 0.85 * of_bound(grid)) << small.scene;
    EXPECT_LE(number(cascade.at("cache").at("probes")), 0.9 * number(grid.at("cache").at("probes")))
        << small.scene;
  }
}

// The rule of Pixel_Order=auto: serpentine on a sheet, hilbert without. Counts of the cache `last`.
TEST_F(ImageShadowCaches, TheOrderOfAutoNeedsTheFewestTestsOrNearly) {
  for (const Small& small : kSpd) {
    double least = 1e300;
    for (const char* order :
         {"rows", "views", "columns", "tiles", "serpentine", "hilbert", "strips(4,32)"}) {
      least = std::min(least, tests(run(small, {"+W300", "+H200", "-UL", "Shadow_Cache=last",
                                                std::string("Pixel_Order=") + order})));
    }
    const auto s = run(small, {"+W300", "+H200", "-UL", "Shadow_Cache=last", "Pixel_Order=auto"});
    EXPECT_LE(tests(s), 1.03 * least) << small.scene;
  }
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
