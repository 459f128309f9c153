// Depth that --depth reports and Depth_Budget keeps, held against every pixel of the sheet. Eyes and parallax
// are worked out here: each view is the perspective of an eye through the sheet's plane, and a
// point's parallax is how far apart two neighbouring eyes see it there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/accel/hierarchy.h"
#include "core/scene/scene.h"
#include "core/scene/tolerances.h"
#include "parser/compile/camera.h"
#include "parser/read_scene.h"
#include "tests/image/depth_text.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using core::Vec3;

constexpr const char* kDepthExamples = "/usr/share/doc/povray/examples/";

/// The extremes of what all pixels of a paraxial sheet with a finite V show.
struct DenseDepth {
  double least = 1e300, most = -1e300;  ///< parallax, pixels a view
  double sky = 0.0;                     ///< parallax of what is infinitely far
  bool has_sky = false;
};

/// A sheet of Lenticular=On with N pixels a lens and otherwise the usual lens, at look_at.
struct DenseSheet {
  static constexpr double kPitch = 1.124, kFocal = 3.03, kIndex = 1.6;
  Vec3 middle, right, up, eye;  ///< right and up: as long as the sheet
  double lenses = 0.0;
  int views = 15;
  double factor = 1.0;

  /// Of view j, beside the camera's own eye.
  Vec3 eye_of(int j) const {
    const double units = core::length(right) / (lenses * kPitch);  // a millimetre
    const double distance = core::length(eye - middle) / units;
    const double print_pitch = kPitch * (1.0 + kFocal / (kIndex * distance));
    const double offset = ((j + 0.5) / views - 0.5) * print_pitch * factor;
    return eye - core::normalized(right) * (distance * kIndex * offset / kFocal * units);
  }
  /// Where the sheet's plane is passed on the way from an eye to a point, in lenses to the right.
  double seen_at(const Vec3& from, const Vec3& point) const {
    const Vec3 normal = core::normalized(core::cross(right, up));
    const double part = core::dot(middle - from, normal) / core::dot(point - from, normal);
    const Vec3 there = from + (point - from) * part;
    return core::dot(there - middle, right) / core::length_squared(right) * lenses;
  }
  double parallax_of(const Vec3& point) const {
    return seen_at(eye_of(views / 2), point) - seen_at(eye_of(views / 2 + 1), point);
  }
};

class DenseScene {
 public:
  DenseScene(const std::string& path, int width, int height) : m_width(width), m_height(height) {
    parser::SourceManager sources;
    parser::Diagnostics diagnostics(sources);
    for (const auto s : {parser::Stream::kDebug, parser::Stream::kRender,
                         parser::Stream::kStatistics, parser::Stream::kWarning}) {
      diagnostics.connect(s, [](std::string_view) {});
    }
    parser::ParserOptions options;
    options.image_width = width;
    options.image_height = height;
    options.library_paths = {fs::path(path).parent_path().string(), "/usr/share/povray-3.7/include",
                             "/usr/share/povray/include"};
    parser::SceneDesc description = parser::read_descriptions(path, sources, diagnostics, options);
    m_scene = std::make_unique<core::Scene>(parser::build_scene(description, diagnostics),
                                            core::CompileOptions{});
    m_camera =
        parser::camera_request(description.camera.value_or(parser::CameraDesc{}), {}).projection;
  }

  /// `factor`: what depth is compressed to.
  DenseDepth look(double factor) const {
    const double distance = m_camera.look_at_distance.value();
    const double far = distance / core::length(m_camera.direction);
    DenseSheet sheet;
    sheet.eye = m_camera.location;
    sheet.middle = sheet.eye + m_camera.direction * far;
    sheet.right = m_camera.right * far;
    sheet.up = m_camera.up * far;
    sheet.lenses = m_width / static_cast<double>(sheet.views);
    sheet.factor = factor;
    DenseDepth out;
    out.sky = sheet.parallax_of(sheet.middle + m_camera.direction * 1e12);
    for (int j = 0; j < sheet.views; ++j) {
      const Vec3 eye = sheet.eye_of(j);
      for (int row = 0; row < m_height; ++row) {
        for (int i = 0; i < m_width / sheet.views; ++i) {
          const Vec3 target = sheet.middle + sheet.right * ((i + 0.5) / sheet.lenses - 0.5) +
                              sheet.up * (0.5 - (row + 0.5) / m_height);
          add(sheet, eye, target, out);
        }
      }
    }
    return out;
  }

 private:
  void add(const DenseSheet& sheet, const Vec3& eye, const Vec3& target, DenseDepth& out) const {
    core::HitLists lists;
    core::Hit hit;
    const core::Ray ray{eye, core::normalized(target - eye)};
    if (!m_scene->hierarchy().nearest(ray, core::kMinHitDistance * m_scene->tolerance_scale(),
                                      1e300, core::RayKind::kCamera, hit, lists, nullptr)) {
      out.has_sky = true;
      return;
    }
    const double step = sheet.parallax_of(ray.at(hit.t));
    out.least = std::min(out.least, step);
    out.most = std::max(out.most, step);
  }

  int m_width, m_height;
  std::unique_ptr<core::Scene> m_scene;
  camera::Projection m_camera;
};

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
  const DenseDepth is = dense.look(1.0);
  const double least = parallax_behind(said.output, "Nearest visible point"),
               most = parallax_behind(said.output, "Farthest visible point");
  EXPECT_NEAR(least, is.least, 0.1);
  EXPECT_NEAR(most, is.most, 0.1);
  EXPECT_EQ(said.output.find("Background, ") != std::string::npos, is.has_sky);
  if (is.has_sky) {
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
  const DenseDepth now = dense.look(factor);
  EXPECT_GE(now.least, -budget);
  EXPECT_LE(now.most, budget);
  EXPECT_NE(kept.output.find("depth is compressed to "), std::string::npos) << kept.output;
  const bool sky_is_out =
      kept.output.find("The background is not within the budget") != std::string::npos;
  EXPECT_EQ(sky_is_out, now.has_sky && now.sky > budget) << now.sky << "\n" << kept.output;
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
