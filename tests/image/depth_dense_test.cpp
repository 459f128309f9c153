// Depth that --depth reports and Depth_Budget keeps, held against every pixel of the sheet
// (tests/support/dense_depth.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/image/depth_text.h"
#include "tests/support/dense_depth.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDepthExamples = "/usr/share/doc/povray/examples/";

/// The usual sheet where the camera looks, seen by an eye at the camera.
DenseSheet usual_sheet(const DenseScene& scene, int width, int height, double factor) {
  DenseSheet out;
  out.width = width;
  out.height = height;
  out.distance = scene.look_at_distance();
  out.factor = factor;
  return out;
}

/// All of a scene of povray-examples: what --depth says, and what is so with Depth_Budget.
void expect_dense_depth(const std::string& name, int width, int height) {
  const std::string scene = kDepthExamples + name;
  if (!fs::exists(scene)) GTEST_SKIP() << "povray-examples is not installed";
  SCOPED_TRACE(name);
  const tool::TemporaryFolder folder;
  const std::vector<std::string> size{"+I" + scene, "+W" + std::to_string(width),
                                      "+H" + std::to_string(height), "Lenticular=On"};
  const auto with = [&size](const std::vector<std::string>& more) {
    std::vector<std::string> words = size;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const auto said = run_lentray(with({"--depth"}), folder.path());
  ASSERT_EQ(said.status, 0) << said.output;
  const DenseScene dense(scene, width, height);
  // P' is P (1 + f/(nV)), and V as many mm as the camera is before the sheet.
  DenseSheet sheet = usual_sheet(dense, width, height, 1.0);
  const double distance = dense.look_at_millimetres(sheet);
  sheet.print_pitch = sheet.pitch * (1.0 + sheet.focal_length / (sheet.index * distance));
  const DenseDepth is = dense.look(sheet);
  const double least = parallax_behind(said.output, "Nearest visible point"),
               most = parallax_behind(said.output, "Farthest visible point");
  EXPECT_NEAR(least, is.least, 0.1);
  EXPECT_NEAR(most, is.most, 0.1);
  EXPECT_EQ(said.output.find("Background, ") != std::string::npos, is.has_sky());
  if (is.has_sky()) {
    EXPECT_NEAR(parallax_behind(said.output, "Background"), is.sky, 1e-3 * is.sky);
  }
  std::printf("| %s | %d x %d | %.3f | %.3f | %.3f | %.3f |", name.c_str(), width, height, least,
              is.least, most, is.most);

  const double budget = 0.4 * std::max(std::fabs(is.least), std::fabs(is.most));
  const auto kept = run_lentray(
      with({"Depth_Budget=" + std::to_string(budget), "View=0", "-F", "Statistics_File=s.json"}),
      folder.path());
  ASSERT_EQ(kept.status, 0) << kept.output;
  const double factor =
      nlohmann::json::parse(tool::read_text(folder / "s.json"))["lens"]["depth_factor"];
  EXPECT_GT(factor, 0.3);
  EXPECT_LT(factor, 0.45);
  sheet.factor = factor;
  const DenseDepth now = dense.look(sheet);
  EXPECT_GE(now.least, -budget);
  EXPECT_LE(now.most, budget);
  EXPECT_NE(kept.output.find("depth is compressed to "), std::string::npos) << kept.output;
  const bool sky_is_out =
      kept.output.find("The background is not within the budget") != std::string::npos;
  EXPECT_EQ(sky_is_out, now.has_sky() && now.sky > budget) << now.sky << "\n" << kept.output;
  std::printf(" %.3f | %.3f | %.3f |\n", budget, factor,
              std::max(std::fabs(now.least), std::fabs(now.most)));
}

// More pixels than --depth looks at.
TEST(ImageDepthDense, IsThatOfEveryPixel) {
  expect_dense_depth("advanced/woodbox.pov", 1200, 480);
  expect_dense_depth("camera/perspective.pov", 1200, 480);
}

class SlowDepthExamples : public ::testing::TestWithParam<const char*> {};

TEST_P(SlowDepthExamples, AreThoseOfEveryPixel) { expect_dense_depth(GetParam(), 1920, 720); }

INSTANTIATE_TEST_SUITE_P(
    Depth, SlowDepthExamples,
    ::testing::Values("advanced/sombrero.pov", "advanced/teapot/teapot3.pov",
                      "advanced/whiltile.pov", "advanced/woodbox.pov", "camera/perspective.pov",
                      "lights/parallel_lights.pov", "lights/spotlite.pov", "objects/chesmsh.pov",
                      "objects/csg/cliptst2.pov", "objects/torus1.pov",
                      "textures/finishes/arches.pov", "textures/finishes/cluster.pov"),
    [](const auto& example) {
      std::string name = fs::path(example.param).stem().string();
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
      return name;
    });

}  // namespace
}  // namespace lentray::test
