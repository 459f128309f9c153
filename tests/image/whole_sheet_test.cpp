// Whole sheets of the size that is printed, lens by lens and view by view against stock. Slow (some
// minutes each): labelled so. docs/sheets.md tells how to run them and what came out.
#include <gtest/gtest.h>

#include "tests/support/sheet_report.h"

namespace lentray::test {
namespace {

struct WholeSheet {
  std::string name, scene, way;
  std::vector<std::string> options;
  std::size_t lenses, views;
  friend void PrintTo(const WholeSheet& s, std::ostream* out) { *out << s.name; }
};

class SlowWholeSheet : public ::testing::TestWithParam<WholeSheet> {};

TEST_P(SlowWholeSheet, IsExact) {
  const WholeSheet& sheet = GetParam();
  std::vector<std::string> arguments{(source_folder() / "scenes" / sheet.scene).string()};
  arguments.insert(arguments.end(), sheet.options.begin(), sheet.options.end());
  const SheetRun run = compare_sheet(arguments, "exact");
  ASSERT_EQ(run.status, 0) << run.said;
  print_row(sheet.name, run.report);
  EXPECT_EQ(run.report["way"], sheet.way);
  EXPECT_EQ(run.report["whole"]["grade"], "exact");
  EXPECT_EQ(run.report["lenses"].size(), sheet.lenses);
  EXPECT_EQ(run.report["views"].size(), sheet.views);
  EXPECT_TRUE(all_match(run.report["lenses"])) << run.said;
  EXPECT_TRUE(all_match(run.report["views"])) << run.said;
}

const std::vector<std::string> kBenchmark{"Declare=Lenticular_Camera=1", "+W1995", "+H2000"};
const std::vector<std::string> kNarrow{"Declare=Lenticular_Camera=1", "Lens_Pixels=12.5", "+W1000",
                                       "+H400"};

std::vector<std::string> from_eye(const std::string& distance, const std::string& lens,
                                  bool whole = true) {
  return {"Lenticular=On", "Sheet_Distance=" + distance, lens, whole ? "+W1995" : "+W1000",
          whole ? "+H2000" : "+H400"};
}

// The sheet of a scene's own camera stands at what it looks at: |Goal - Eye| of the scenes.
constexpr const char* kBalls = "2.9983328";
constexpr const char* kGears = "3.5185224";
constexpr const char* kParallel = "oblique orthographic views";
constexpr const char* kPerspective = "oblique perspective views";
constexpr const char* kMesh = "mesh_camera";

INSTANTIATE_TEST_SUITE_P(
    Sheets, SlowWholeSheet,
    ::testing::Values(WholeSheet{"balls_infinite", "spd_balls.pov", kParallel, kBenchmark, 133, 15},
                      WholeSheet{"gears_infinite", "spd_gears.pov", kParallel, kBenchmark, 133, 15},
                      WholeSheet{"balls_paraxial", "spd_balls.pov", kPerspective,
                                 from_eye(kBalls, "Lens_Model=paraxial"), 133, 15},
                      WholeSheet{"gears_paraxial", "spd_gears.pov", kPerspective,
                                 from_eye(kGears, "Lens_Model=paraxial"), 133, 15},
                      WholeSheet{"balls_pinhole", "spd_balls.pov", kMesh,
                                 from_eye(kBalls, "Lens_Model=pinhole"), 133, 15},
                      WholeSheet{"gears_pinhole", "spd_gears.pov", kMesh,
                                 from_eye(kGears, "Lens_Model=pinhole"), 133, 15},
                      WholeSheet{"balls_N12_5_infinite", "spd_balls.pov", kMesh, kNarrow, 80, 0},
                      WholeSheet{"gears_N12_5_infinite", "spd_gears.pov", kMesh, kNarrow, 80, 0},
                      WholeSheet{"balls_N12_5_paraxial", "spd_balls.pov", kMesh,
                                 from_eye(kBalls, "Lens_Pixels=12.5", false), 80, 0},
                      WholeSheet{"gears_N12_5_paraxial", "spd_gears.pov", kMesh,
                                 from_eye(kGears, "Lens_Pixels=12.5", false), 80, 0}),
    [](const auto& sheet) { return sheet.param.name; });

/// Scenes of Debian's povray-examples through Lenticular=On, the eye where their camera is.
class SlowSheetExamples : public ::testing::TestWithParam<const char*> {};

TEST_P(SlowSheetExamples, EveryViewMatches) {
  const std::filesystem::path scene =
      std::filesystem::path("/usr/share/doc/povray/examples") / GetParam();
  if (!std::filesystem::exists(scene)) GTEST_SKIP() << "povray-examples is not installed";
  const SheetRun run = compare_sheet({scene.string(), "Lenticular=On", "+W480", "+H180"}, "match");
  ASSERT_FALSE(run.report.is_null()) << run.said;
  print_row(GetParam(), run.report);
  EXPECT_EQ(run.status, 0) << run.said;
  EXPECT_EQ(run.report["way"], kPerspective);
  EXPECT_EQ(run.report["views"].size(), 15u);
  EXPECT_TRUE(all_match(run.report["views"])) << run.said;
}

INSTANTIATE_TEST_SUITE_P(Debian, SlowSheetExamples,
                         ::testing::Values("advanced/sombrero.pov", "advanced/teapot/teapot3.pov",
                                           "advanced/whiltile.pov", "advanced/woodbox.pov",
                                           "camera/perspective.pov", "lights/parallel_lights.pov",
                                           "lights/spotlite.pov", "objects/chesmsh.pov",
                                           "objects/csg/cliptst2.pov", "objects/torus1.pov",
                                           "textures/finishes/arches.pov",
                                           "textures/finishes/cluster.pov",
                                           "textures/normals/normal.pov"),
                         [](const auto& scene) {
                           std::string name = std::filesystem::path(scene.param).stem().string();
                           return name;
                         });

}  // namespace
}  // namespace lentray::test
