// Focal blur, against stock. Both programs' pictures are noisy, so what counts is the PSNR after the
// 8 x 8 box filter: 50 dB and more is what two correct pictures of 100 rays a pixel have here, and
// some 35 where few rays are taken; with half or twice the aperture it is less than 36.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

const std::string kFocalBlurStage = R"(#version 3.7; global_settings { assumed_gamma 1 }
light_source { <1,6,-3>, 1 }
sphere { <0,0,3>, .8 pigment { rgb <.9,.2,.2> } finish { phong .8 } }
cylinder { <1.4,-1,2>, <1.4,2,2>, .3 pigment { rgb <.2,.9,.2> } }
sphere { <-.9,.5,-.5>, .25 pigment { rgb .9 } finish { phong 1 reflection .3 } }
box { <-2.6,-1,5>, <-1.4,2.5,5.4> pigment { rgb <.9,.5,.9> } }
)";
const std::string kFocalBlurFloor =
    "plane { y, -1 pigment { checker rgb <.9,.8,.3> rgb <.2,.3,.7> scale .7 } }\n";
const std::string kView = "location <0,.5,-3> look_at z*2 aperture .9 focal_point z*2 ";
const std::string kFull = "blur_samples 100 variance 0 ";
const std::string kHalfDisc =
    "bokeh { pigment { gradient x color_map { [.5 rgb 0] [.5 rgb 1] } } } ";

SceneText scene_of(const std::string& camera, std::vector<std::string> arguments = {}) {
  return {.sdl = kFocalBlurStage + kFocalBlurFloor + "camera { " + camera + " }\n",
          .width = 64,
          .height = 48,
          .arguments = std::move(arguments),
          .files = {}};
}

double smooth_psnr(const StoredImage& a, const StoredImage& b) {
  return core::compare(a, b, core::Columns::all(a.width)).smooth_psnr;
}

struct FocalBlurCase {
  std::string camera;
  double least;  ///< dB
  std::vector<std::string> arguments{};
};

class ImageFocalBlur : public ::testing::TestWithParam<FocalBlurCase> {};

TEST_P(ImageFocalBlur, AsInStock) {
  const SceneText scene = scene_of(GetParam().camera, GetParam().arguments);
  const double psnr = smooth_psnr(lentray_render(scene), stock_render(scene));
  EXPECT_GE(psnr, GetParam().least) << GetParam().camera;
  RecordProperty("smooth_psnr", std::to_string(psnr));
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, ImageFocalBlur,
    ::testing::Values(
        FocalBlurCase{
            "location <1,1.5,-3> look_at <-.3,0,2> angle 60 aperture .9 focal_point <1.4,0,2> " +
                kFull,
            50},
        FocalBlurCase{"location <0,.5,-3> direction 2*z aperture .9 focal_point z*2 " + kFull, 50},
        FocalBlurCase{
            "location <0,.5,-3> direction <.3,.2,1> aperture .9 focal_point <.5,.6,2> " + kFull,
            50},
        FocalBlurCase{"location <0,.5,-3> look_at z*2 angle 40 aperture .4 " + kFull, 50},
        FocalBlurCase{
            "fisheye angle 140 location <0,.5,-3> direction z*2 aperture 1.8 focal_point z*2 " +
                kFull,
            50},
        FocalBlurCase{"ultra_wide_angle angle 100 " + kView + kFull, 50},
        FocalBlurCase{"omnimax " + kView + kFull, 50},
        FocalBlurCase{"panoramic " + kView + kFull, 44},
        FocalBlurCase{"spherical angle 120 90 " + kView + kFull, 50},
        FocalBlurCase{"cylinder 1 angle 100 " + kView + kFull, 50},
        FocalBlurCase{kView + kFull + "normal { bumps .3 scale .2 }", 50}));

INSTANTIATE_TEST_SUITE_P(
    Bokeh, ImageFocalBlur,
    ::testing::Values(
        FocalBlurCase{
            kView + kFull + "bokeh { pigment { gradient y color_map { [.7 rgb 0] [.7 rgb 1] } } }",
            47},
        FocalBlurCase{kView + kFull + kHalfDisc + "right -x*1.33", 50}));

INSTANTIATE_TEST_SUITE_P(
    Rays, ImageFocalBlur,
    ::testing::Values(FocalBlurCase{kView + "blur_samples 1", 31},
                      FocalBlurCase{kView + "blur_samples 6", 39},
                      FocalBlurCase{kView + "blur_samples 7", 43},
                      FocalBlurCase{kView + "blur_samples 37", 46},
                      FocalBlurCase{kView + "blur_samples 20,60 variance .1", 47},
                      FocalBlurCase{kView + "blur_samples 100 confidence .5 variance 1/64", 44},
                      FocalBlurCase{kView + "blur_samples 100", 47}));

INSTANTIATE_TEST_SUITE_P(
    Antialiased, ImageFocalBlur,
    ::testing::Values(FocalBlurCase{kView + "blur_samples 20", 48, {"+A0.2", "+AM1", "+R2"}},
                      FocalBlurCase{kView + "blur_samples 20", 48, {"+A0.2", "+AM2", "+R2"}}));

TEST(ImageFocalBlurAlpha, AsInStock) {
  const SceneText scene = scene_of(kView + kFull, {"+UA", "+FN8"});
  const StoredImage ours = lentray_render(scene), stock = stock_render(scene);
  ASSERT_EQ(ours.channels, 4);
  EXPECT_GE(smooth_psnr(ours, stock), 40.0);
  double difference = 0.0;
  for (std::size_t i = 3; i < ours.samples.size(); i += 4) {
    difference += std::fabs(static_cast<double>(ours.samples[i]) - stock.samples[i]) / 255.0;
  }
  EXPECT_LT(difference / (ours.width * ours.height), 0.01);
}

TEST(ImageFocalBlurTest, WouldNoticeAnotherAperture) {
  const StoredImage stock = stock_render(scene_of(kView + kFull));
  for (const char* wrong : {"0", "1.8"}) {
    const std::string view =
        "location <0,.5,-3> look_at z*2 focal_point z*2 aperture " + std::string(wrong) + " ";
    EXPECT_LT(smooth_psnr(lentray_render(scene_of(view + kFull)), stock), 36.0) << wrong;
  }
}

/// Where the light of a picture of one bright point is, in pixels: the picture of the aperture.
struct Spot {
  double light = 0.0, x = 0.0, y = 0.0, width = 0.0, height = 0.0;  ///< standard deviations
};

Spot spot_of(const StoredImage& picture) {
  Spot s;
  double xx = 0.0, yy = 0.0;
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const double light = core::level(picture, x, y)[1];
      s.light += light;
      s.x += light * x;
      s.y += light * y;
      xx += light * x * x;
      yy += light * y * y;
    }
  }
  s.x /= s.light;
  s.y /= s.light;
  s.width = std::sqrt(xx / s.light - s.x * s.x);
  s.height = std::sqrt(yy / s.light - s.y * s.y);
  return s;
}

TEST(ImageFocalBlurTest, ABrightPointShowsTheAperture) {
  const std::string point =
      "#version 3.7; global_settings { assumed_gamma 1 } sphere { <.2,.1,4>, .25 pigment { rgb 1 }"
      " finish { emission 1 } } camera { location -4*z angle 40 focal_point <1,0,-1> aperture 2.4"
      " blur_samples 300 variance 0 ";
  for (const std::string& bokeh : {std::string(), kHalfDisc}) {
    const SceneText scene{.sdl = point + bokeh + "}",
                          .width = 80,
                          .height = 60,
                          .arguments = {"File_Gamma=1.0"},
                          .bits = 16,
                          .files = {}};
    const Spot ours = spot_of(lentray_render(scene)), stock = spot_of(stock_render(scene));
    EXPECT_GT(stock.height, 5.0);
    EXPECT_NEAR(ours.light / stock.light, 1.0, 0.02);
    EXPECT_NEAR(ours.x, stock.x, 0.15);
    EXPECT_NEAR(ours.y, stock.y, 0.15);
    EXPECT_NEAR(ours.width / stock.width, 1.0, 0.02);
    EXPECT_NEAR(ours.height / stock.height, 1.0, 0.02);
  }
}

// Stock starts all rays of these at the camera's location. What they show is what its perspective
// camera shows from afar with an aperture of the same slopes.
TEST(ImageFocalBlurTest, OrthographicAsAPerspectiveFromAfar) {
  SceneText parallel = scene_of({}), far = parallel;
  const std::string rest = " right 5*x up 3.75*y focal_point <0,.5,2> " + kFull + "}";
  parallel.sdl =
      kFocalBlurStage + "camera { orthographic location <0,.5,-3> direction z aperture .9" + rest;
  far.sdl =
      kFocalBlurStage + "camera { location <0,.5,-2998> direction 3000*z aperture .9*600" + rest;
  EXPECT_GE(smooth_psnr(lentray_render(parallel), stock_render(far)), 45.0);
}

// A view of a sheet is what stock shows from the view's eye, with the same aperture and focus.
TEST(ImageFocalBlurSheet, ViewsAsInStock) {
  // The eye of view j is 5 (j - 7) n P'/(f N) beside the camera, 5 units before the sheet; it sees
  // the sheet, 5.2056 wide.
  const std::string lens = "aperture .5 blur_samples 100 variance 0 ";
  const SceneText sheet = scene_of(
      "location <0,.5,-3> direction z right x up .75*y look_at <0,.5,2>"
      " angle 55 focal_point <0,.5,3> " +
          lens,
      {"Lenticular=On", "Lens_Pixels=15", "+W960", "+H48"});
  const double half = 5.0 * std::tan(55.0 / 2.0 * M_PI / 180.0);
  const double pitch = 1.124, focal = 3.03, ior = 1.6;
  const double eye_mm = 5.0 * (64 * pitch) / (2.0 * half);
  const double print_pitch = pitch * (1.0 + focal / (ior * eye_mm));
  for (const int view : {0, 9}) {
    const double e = (view - 7) / 15.0 * print_pitch, x = -5.0 * ior * e / focal;
    const std::string at = std::to_string(x);
    const SceneText one =
        scene_of("location <" + at + ",.5,-3> direction <-(" + at + "),0,5> right x*" +
                     std::to_string(2.0 * half) + " up y*" + std::to_string(1.5 * half) +
                     " focal_point <-.2*(" + at + "),.5,3> " + lens,
                 {"+W64", "+H48"});
    EXPECT_GE(
        smooth_psnr(lentray_render(sheet, {"View=" + std::to_string(view)}), stock_render(one)),
        48.0)
        << view;
  }
}

TEST(ImageFocalBlurSheet, TheSheetIsItsViews) {
  const SceneText sheet = scene_of(kView + "blur_samples 100 variance 0",
                                   {"Lenticular=On", "Lens_Pixels=6", "+W384", "+H48"});
  const StoredImage whole = lentray_render(sheet);
  const StoredImage view = lentray_render(sheet, {"View=2"});
  StoredImage cut = view;
  for (std::uint32_t y = 0; y < view.height; ++y) {
    for (std::uint32_t x = 0; x < view.width; ++x) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(view.channels); ++c) {
        cut.samples[(std::size_t{y} * view.width + x) * static_cast<std::size_t>(view.channels) +
                    c] = whole.samples[(std::size_t{y} * whole.width + x * 6 + 2) *
                                           static_cast<std::size_t>(whole.channels) +
                                       c];
      }
    }
  }
  EXPECT_GE(smooth_psnr(cut, view), 45.0);
}

TEST(ImageFocalBlurTest, MeshCamerasHaveNone) {
  const std::string mesh =
      "mesh_camera { 1 3 mesh { triangle { <-2,-1,-2>, <-2,1.4,-2>, <2,1.4,-2>"
      " uv_vectors <0,0>, <0,1>, <1,1> } } } ";
  EXPECT_TRUE(same_bits(lentray_render(scene_of(mesh + "aperture 1 blur_samples 20")),
                        lentray_render(scene_of(mesh))));
}

}  // namespace
}  // namespace lentray::test
