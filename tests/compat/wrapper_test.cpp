// The reference itself: that stock's two independent ways of showing a sheet agree, that a
// wrapper shows what the plain scene shows, and that each mistake a renderer could make in the
// lens is caught by the comparison. Needs povray, not lentray.
#include "tools/lentray-diff/wrapper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/image/compare.h"
#include "tests/support/render.h"
#include "tools/lentray-diff/stock.h"

namespace lentray::diff {
namespace {

using core::compare_lenses;
using core::Grade;
using core::LensComparison;
using core::StoredImage;
using core::Vec3;

constexpr const char* kWrapperScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Tall) #declare Tall = 1; #end
camera { location <0,1,-6> look_at <0,0.6,0> }
light_source { <-6,9,-8> rgb 0.9 }
light_source { <7,3,-5> rgb <0.3,0.35,0.4> }
background { rgb <0.1,0.2,0.4> }
plane { y, -1 pigment { checker rgb <.9,.8,.7> rgb <.2,.3,.5> scale 0.7 } }
sphere { <-1.2,0.4,2>, 1 pigment { rgb <.9,.2,.2> } finish { phong .6 reflection .2 } }
box { <0.3,-1,-1>,<1.2,Tall,0> rotate y*20 pigment { rgb <.2,.8,.3> } }
cylinder { <-0.5,-1,-2>,<-0.4,0.9,-1.7>, .15 pigment { rgb <.9,.9,.1> } }
)";

/// A sheet through the scene's middle, turned a little, rows not square.
Sheet sheet(double lens_pixels, std::uint32_t columns, double view_distance, bool paraxial) {
  Sheet s;
  const double a = 0.2, b = 0.1;  // radians about y, then tilt
  s.right = {std::cos(a), 0, -std::sin(a)};
  s.direction = {std::sin(a) * std::cos(b), -std::sin(b), std::cos(a) * std::cos(b)};
  s.up = {std::sin(a) * std::sin(b), std::cos(b), std::cos(a) * std::sin(b)};
  s.centre = {0.1, 0.5, 0};
  s.width = 4;
  s.height = 2.5;
  s.pixels = lens_pixels;
  s.columns = columns;
  s.rows = 24;
  s.view_distance = view_distance;
  s.paraxial = paraxial;
  s.front = std::isfinite(view_distance) ? view_distance * s.scale() : 5.0;
  return s;
}

constexpr double kFar = std::numeric_limits<double>::infinity();

class Stock {
 public:
  Stock() {
    options.processes = 2;
    tool::write_text(m_folder / "scene.pov", kWrapperScene);
  }
  StoredImage operator()(const Sheet& s, Way way) const {
    return stock_integral(m_folder / "scene.pov", s, way, options);
  }
  std::filesystem::path scene() const { return m_folder / "scene.pov"; }
  StockOptions options;

 private:
  tool::TemporaryFolder m_folder;
};

LensComparison two_ways(const Sheet& s, Way way) {
  const Stock stock;
  return compare_lenses(stock(s, way), stock(s, Way::mesh_camera), s.pixels);
}

TEST(CompatWrapper, OrthographicViewsAgreeWithMeshCamera) {
  EXPECT_TRUE(reaches(two_ways(sheet(5, 100, kFar, false), Way::orthographic_views), Grade::match));
}

TEST(CompatWrapper, CutLastLens) {
  EXPECT_TRUE(reaches(two_ways(sheet(5, 98, kFar, false), Way::orthographic_views), Grade::match));
}

TEST(CompatWrapper, PerspectiveViewsAgreeWithMeshCamera) {
  EXPECT_TRUE(reaches(two_ways(sheet(5, 98, 60, true), Way::perspective_views), Grade::match));
}

TEST(CompatWrapper, EyeBesideTheMiddle) {
  Sheet s = sheet(5, 100, 60, true);
  s.eye_slope_x = 0.15;
  s.eye_slope_y = -0.1;
  EXPECT_TRUE(reaches(two_ways(s, Way::perspective_views), Grade::match));
  s.view_distance = kFar;
  s.front = 3;
  EXPECT_TRUE(reaches(two_ways(s, Way::orthographic_views), Grade::match));
}

TEST(CompatWrapper, MirroredSheet) {
  Sheet s = sheet(5, 100, kFar, true);
  s.right = -s.right;
  EXPECT_TRUE(reaches(two_ways(s, Way::orthographic_views), Grade::match));
}

TEST(CompatWrapper, MiddleViewIsTheOrdinaryPicture) {
  // Odd N: the middle view's eye stands on the axis, and the scene's camera can be put there.
  const Stock stock;
  const Sheet s = sheet(5, 100, 60, true);
  const StoredImage view = stock_view(stock.scene(), s, 2, stock.options);
  const double v = s.view_distance * s.scale();
  const Vec3 eye = s.centre - s.direction * v;
  std::ostringstream plain;
  plain.precision(17);
  const auto put = [&](const char* word, const Vec3& p) {
    plain << word << " <" << p.x << "," << p.y << "," << p.z << "> ";
  };
  plain << kWrapperScene << "camera { ";
  put("location", eye);
  put("direction", s.direction * v);
  put("right", s.right * s.width);
  put("up", s.up * s.height);
  plain << "}\n";
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "plain.pov", plain.str());
  EXPECT_TRUE(test::same_bits(view, stock_picture(folder / "plain.pov", 20, 24, stock.options)));
}

TEST(CompatWrapper, DeclareReachesTheScene) {
  Stock stock;
  const Sheet s = sheet(5, 50, kFar, true);
  const StoredImage low = stock(s, Way::orthographic_views);
  stock.options.arguments = {"Declare=Tall=2"};
  EXPECT_FALSE(test::same_bits(low, stock(s, Way::orthographic_views)));
}

TEST(CompatWrapper, BrokenSceneIsReported) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "broken.pov", "#version 3.7;\nsphere { <0,0,0> 1 pigmen }\n");
  try {
    stock_integral(folder / "broken.pov", sheet(5, 50, kFar, true), Way::orthographic_views, {});
    FAIL() << "no error";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("broken.pov"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("rror"), std::string::npos) << e.what();
  }
}

// Mutations: the picture of a sheet that is wrong in one way against the right one.

bool is_caught(const StoredImage& right, const StoredImage& wrong, double lens_pixels) {
  return !reaches(compare_lenses(wrong, right, lens_pixels), Grade::match);
}

TEST(CompatMutation, RightVectorSwapped) {
  const Stock stock;
  const Sheet s = sheet(5, 100, kFar, false);
  Sheet wrong = s;
  wrong.right = -s.right;
  EXPECT_TRUE(
      is_caught(stock(s, Way::orthographic_views), stock(wrong, Way::orthographic_views), 5));
}

TEST(CompatMutation, PrintPitchForgotten) {
  // P in the place of P': a sheet whose pixels are P'/P too close together, axes in place.
  const Stock stock;
  const Sheet s = sheet(9, 180, 60, true);
  const StoredImage right = stock(s, Way::perspective_views);
  std::vector<StoredImage> views;
  const double eye = s.view_distance * s.scale();
  for (std::uint32_t j = 0; j < 9; ++j) {
    Sheet wrong = s;
    // The same eyes as a sheet of a focal length P'/P longer: e/f shrinks by P/P'.
    wrong.eye_slope_x =
        s.ior * s.cell_offset(j) / s.focal_length * (s.pitch / s.print_pitch() - 1.0);
    wrong.front = eye;
    views.push_back(stock_view(stock.scene(), wrong, j, stock.options));
  }
  EXPECT_TRUE(is_caught(right, interlaced(views, s.columns), 9));
}

TEST(CompatMutation, LensPixelsOneOff) {
  const Stock stock;
  const Sheet s = sheet(5, 120, kFar, false);
  Sheet wrong = s;
  wrong.pixels = 6;
  wrong.width = s.width;  // the same sheet on screen
  EXPECT_TRUE(
      is_caught(stock(s, Way::orthographic_views), stock(wrong, Way::orthographic_views), 5));
}

TEST(CompatMutation, ViewsReversed) {
  const Stock stock;
  const Sheet s = sheet(5, 100, kFar, false);
  const StoredImage right = stock(s, Way::orthographic_views);
  StoredImage wrong = right;
  for (std::uint32_t y = 0; y < wrong.height; ++y) {
    for (std::uint32_t k = 0; k < wrong.width; ++k) {
      const std::uint32_t from = k / 5 * 5 + 4 - k % 5;
      for (int c = 0; c < 3; ++c) wrong.at(k, y, c) = right.at(from, y, c);
    }
  }
  EXPECT_TRUE(is_caught(right, wrong, 5));
}

TEST(CompatMutation, OneLensShiftedByOnePixel) {
  const Stock stock;
  const Sheet s = sheet(15, 600, kFar, false);
  const StoredImage right = stock(s, Way::orthographic_views);
  StoredImage wrong = right;
  for (std::uint32_t y = 0; y < wrong.height; ++y) {
    for (std::uint32_t k = 20 * 15; k < 21 * 15; ++k) {
      for (int c = 0; c < 3; ++c) wrong.at(k, y, c) = right.at(k - 1, y, c);
    }
  }
  const LensComparison result = compare_lenses(wrong, right, 15);
  EXPECT_FALSE(reaches(result, Grade::match));
  EXPECT_LT(result.lenses[20].grade, Grade::match);
  EXPECT_EQ(result.lenses[19].grade, Grade::exact);
}

// Text.

TEST(UnitWrapper, VersionDirective) {
  EXPECT_EQ(version_directive("// #version 3.1;\n#version 3.7;\n"), "#version 3.7;");
  EXPECT_EQ(version_directive("/* a */ #version 3.5\nsphere"), "#version 3.5;");
  EXPECT_EQ(version_directive("#version Temp;"), "");
  EXPECT_EQ(version_directive("sphere { 0, 1 }"), "");
}

TEST(UnitWrapper, LenticularCamerasBecomeOrdinary) {
  bool changed = false;
  const std::string text = "camera {\n  lenticular // }\n location <0,0,0>\n}\nsphere { 0, 1 }\n";
  EXPECT_EQ(without_lenticular(text, changed), "camera { orthographic \n\n\n}\nsphere { 0, 1 }\n");
  EXPECT_TRUE(changed);
  const std::string two =
      "camera { lenticular }#declare lenticular = 1; camera { location lenticular }"
      "camera {lenticular lens_pitch 2}";
  EXPECT_EQ(without_lenticular(two, changed),
            "camera { orthographic }#declare lenticular = 1; camera { orthographic }"
            "camera { orthographic }");
  const std::string none =
      "// camera { lenticular }\n\"camera { lenticular }\" camera { angle 30 }";
  EXPECT_EQ(without_lenticular(none, changed), none);
  EXPECT_FALSE(changed);
}

TEST(UnitWrapper, IncludedFiles) {
  EXPECT_EQ(
      included_files("#include \"a.inc\"\n// #include \"b.inc\"\n# include\"c d.inc\" #include X"),
      (std::vector<std::string>{"a.inc", "c d.inc"}));
}

TEST(CompatWrapper, LenticularCameraInAnIncludeFile) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "cam.inc", "camera { lenticular location <0,0,0> lens_pitch 1.124 }\n");
  tool::write_text(folder / "scene.pov", std::string(kWrapperScene) + "#include \"cam.inc\"\n");
  const Stock stock;
  const Sheet s = sheet(3, 30, kFar, true);
  const StoredImage with = stock_integral(folder / "scene.pov", s, best_way(s), stock.options);
  EXPECT_TRUE(test::same_bits(with, stock(s, best_way(s))));
}

TEST(UnitWrapper, BestWay) {
  EXPECT_EQ(best_way(sheet(15, 150, kFar, false)), Way::orthographic_views);
  EXPECT_EQ(best_way(sheet(7.37, 150, kFar, false)), Way::mesh_camera);
  EXPECT_EQ(best_way(sheet(15, 150, 60, true)), Way::perspective_views);
  EXPECT_EQ(best_way(sheet(15, 150, 60, false)), Way::mesh_camera);
  Sheet near = sheet(15, 150, 60, true);
  near.front *= 0.5;
  EXPECT_EQ(best_way(near), Way::mesh_camera);
}

}  // namespace
}  // namespace lentray::diff
