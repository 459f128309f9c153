// Rays of the cameras against values computed apart from the program, with 40 digits.
#include "camera/lenticular.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/projected.h"

namespace lentray::camera {
namespace {

using core::Ray;
using core::Vec3;

constexpr double kCameraLenticularInf = LensParameters::kInfinity;

void expect_near(const Vec3& got, const Vec3& want, double tolerance) {
  EXPECT_NEAR(got.x, want.x, tolerance);
  EXPECT_NEAR(got.y, want.y, tolerance);
  EXPECT_NEAR(got.z, want.z, tolerance);
}

struct CameraLenticularExpected {
  LensParameters lens;
  std::uint32_t width, height;
  double sheet_width, sheet_height, front, eye_slope_x, eye_slope_y;
  std::uint32_t column, row;
  Vec3 origin, direction;
};

// A row a case.
// clang-format off
const CameraLenticularExpected kRays[] = {
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kPinhole}, 150, 40, 6.5, 4.1, 0, 0, 0, 0, 0,
     Vec3{-1.9825, -0.3425, 3.38375},
     Vec3{0.13873072670119604573, 0.55038344659484077383, 0.82330543978728945619}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kPinhole}, 150, 40, 6.5, 4.1, 0, 0, 0, 78, 20,
     Vec3{1.5508333333333333333, -0.62583333333333333333, 1.9004166666666666667},
     Vec3{0.22416848838789702135, 0.60584323842618490526, 0.76334950007657576781}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kPinhole}, 150, 40, 6.5, 4.1, 0, 0, 0, 149, 39,
     Vec3{4.5825, -1.0575, 0.81625},
     Vec3{0.50262671762446095555, 0.73233144205647322874, 0.45940944886402454638}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kPinhole}, 150, 40, 6.5, 4.1, 2.75, 0, 0, 0, 0,
     Vec3{-2.3790646113085659844, -1.9157823056542829922, 1.0303146113085659844},
     Vec3{0.13873072670119604573, 0.55038344659484077383, 0.82330543978728945619}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kPinhole}, 150, 40, 6.5, 4.1, 2.75, 0, 0, 78, 20,
     Vec3{0.92657802834868407541, -2.3129609858256579623, -0.22532802834868407541},
     Vec3{0.22416848838789702135, 0.60584323842618490526, 0.76334950007657576781}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kPinhole}, 150, 40, 6.5, 4.1, 2.75, 0, 0, 149, 39,
     Vec3{3.145731277975232651, -3.1508843610123836745, -0.49698127797523265104},
     Vec3{0.50262671762446095555, 0.73233144205647322874, 0.45940944886402454638}},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 33, 5, 7, 3.5, 0, 0, 0, 0,
     Vec3{-2.9092456048104810481, -1.2274421963446344634, -0.5179350012501250125},
     Vec3{0.12255129793546591933, 0.55978999096050258245, 0.81952202251969599143}},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 33, 5, 7, 3.5, 0, 0, 73, 16,
     Vec3{0.64458745599559955996, -2.77770627200220022, -0.74458745599559955996},
     Vec3{0.23235961967327466618, 0.61081503372984007841, 0.75691082811313082445}},
    {{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial}, 140, 33, 5, 7, 3.5, 0, 0, 139, 32,
     Vec3{3.1759122714771477148, -4.8392244703220322032, 0.051268334583458345835},
     Vec3{0.51770988537472587336, 0.72073237565988100293, 0.46100034410068759395}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 21, 4.2, 1.7, 0, 0, 0, 0, 0,
     Vec3{-0.53650253968253968254, -0.80872746031746031746, 3.1269787301587301587},
     Vec3{0.14903297620472789069, 0.56314503610020519986, 0.81280799720429645423}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 21, 4.2, 1.7, 0, 0, 0, 53, 10,
     Vec3{1.4477, -0.62615, 1.9523},
     Vec3{0.24038286153636396849, 0.61562388720566022417, 0.75048205133859251137}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 21, 4.2, 1.7, 0, 0, 0, 99, 20,
     Vec3{3.2255425396825396825, -0.54675253968253968254, 0.98398126984126984127},
     Vec3{0.34619221981837620428, 0.66772624537906251983, 0.65900880735328953489}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 21, 4.2, 1.7, 9, 0.2, -0.1, 0, 0,
     Vec3{-3.7546259494043838837, -6.0656168172704268342, -3.5070702080273812239},
     Vec3{0.3553783585953284956, 0.58051990963039920696, 0.73260006604204128153}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 21, 4.2, 1.7, 9, 0.2, -0.1, 53, 10,
     Vec3{-2.5405885935576020963, -6.2202942967788010481, -3.9594114064423979037},
     Vec3{0.44003258017131344716, 0.61720853218558872892, 0.65224608560349956752}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kPinhole}, 100, 21, 4.2, 1.7, 9, 0.2, -0.1, 99, 20,
     Vec3{-1.7082195299348896158, -6.5658059223992099156, -4.0300843126333452765},
     Vec3{0.53291473453814852577, 0.65014124928608975523, 0.5415886277322089267}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 21, 4.2, 1.7, 9, -0.15, 0.3, 0, 0,
     Vec3{0.74502381001609146598, -7.4157919375601891593, -4.4067199674478565737},
     Vec3{-0.12685754348943845398, 0.65402944657083915731, 0.74575642583759684247}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 21, 4.2, 1.7, 9, -0.15, 0.3, 53, 10,
     Vec3{1.9598894940880015507, -7.5700552529559992247, -4.8598894940880015507},
     Vec3{-0.052581068176548052458, 0.71285717440826111192, 0.69933531311101629834}},
    {{0.508, 1.4, 1.56, 7.37, 250, LensModel::kParaxial}, 100, 21, 4.2, 1.7, 9, -0.15, 0.3, 99, 20,
     Vec3{2.8094667036493475726, -7.9069628056070913214, -4.9477705462175824649},
     Vec3{0.043972846425302531259, 0.77786155227629356336, 0.62689536149789126855}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kParaxial}, 150, 40, 6.5, 4.1, 1, 0.1, 0.25, 0, 0,
     Vec3{-2.0311791345801246791, -1.1168395672900623396, 2.6824291345801246791},
     Vec3{0.046544615421875432776, 0.74038574589148076701, 0.67056882275866761785}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kParaxial}, 150, 40, 6.5, 4.1, 1, 0.1, 0.25, 78, 20,
     Vec3{1.4230166850018335167, -1.4397416574990832417, 1.2782333149981664833},
     Vec3{0.12380267061385322525, 0.78834819627900372202, 0.60264419035822388415}},
    {{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kParaxial}, 150, 40, 6.5, 4.1, 1, 0.1, 0.25, 149, 39,
     Vec3{4.1645124679134580125, -2.0164937660432709938, 0.48423753208654198753},
     Vec3{0.38083706757157616253, 0.87375901347154214969, 0.3025034121141779059}},
};
// clang-format on

/// A rotation with rational entries, so that the expected values are exact.
SheetPlacement rotated_sheet(double width, double height) {
  SheetPlacement place;
  place.centre = {1.3, -0.7, 2.1};
  place.right = {2.0 / 3.0, 1.0 / 3.0, -2.0 / 3.0};
  place.up = {-2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0};
  place.normal = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
  place.width = width;
  place.height = height;
  return place;
}

TEST(UnitCameraLenticular, RaysFollowTheFormulae) {
  for (const CameraLenticularExpected& want : kRays) {
    SheetPlacement place = rotated_sheet(want.sheet_width, want.sheet_height);
    place.front = want.front;
    place.eye_slope_x = want.eye_slope_x;
    place.eye_slope_y = want.eye_slope_y;
    const Lenticular camera(want.lens, place, want.width, want.height);
    SCOPED_TRACE("N " + std::to_string(want.lens.pixels) + " column " +
                 std::to_string(want.column) + " front " + std::to_string(want.front));
    Ray ray;
    ASSERT_TRUE(camera.ray(want.column + 0.5, want.row + 0.5, ray));
    expect_near(ray.origin, want.origin, 1e-12);
    expect_near(ray.direction, want.direction, 1e-12);
  }
}

TEST(UnitCameraLenticular, FrontIsClampedToTheEye) {
  LensParameters lens;
  lens.view_distance = 200.0;
  lens.model = LensModel::kParaxial;
  SheetPlacement place;
  place.width = 6.0;
  place.height = 4.0;
  place.front = 1e6;
  const Lenticular camera(lens, place, 150, 100);
  ASSERT_EQ(camera.warnings().size(), 1u);
  EXPECT_NE(camera.warnings()[0].find("lens_front"), std::string::npos);
  // All rays of the middle view start at the eye.
  const double distance = 200.0 * camera.scale();
  Ray ray;
  for (const std::uint32_t k : {7u, 67u, 142u}) {
    ASSERT_TRUE(camera.ray(k + 0.5, 12.5, ray));
    expect_near(ray.origin, {0.0, 0.0, -distance}, 1e-12);
  }
  // View 0 has its eye at -V n e_0/f beside the axis.
  const double e0 = (0.5 / 15.0 - 0.5) * lens.print_pitch();
  ASSERT_TRUE(camera.ray(30.5, 80.5, ray));
  expect_near(ray.origin, {-distance * 1.6 * e0 / 3.03, 0.0, -distance}, 1e-11);
}

TEST(UnitCameraLenticular, ADarkPixelHasNoRay) {
  LensParameters lens;
  lens.pitch = 6.0;
  const Lenticular camera(lens, SheetPlacement{}, 30, 4);
  Ray ray;
  EXPECT_FALSE(camera.ray(0.5, 0.5, ray));
  EXPECT_TRUE(camera.ray(1.5, 0.5, ray));
  EXPECT_EQ(camera.dark_pixels(), 16u);
  ASSERT_EQ(camera.warnings().size(), 1u);
  EXPECT_NE(camera.warnings()[0].find("16 pixels"), std::string::npos);
  EXPECT_NE(camera.warnings()[0].find("5.19845 mm"), std::string::npos);
}

TEST(UnitCameraLenticular, PlacesBetweenCentresStayUnderTheirLens) {
  LensParameters lens;
  const Lenticular camera(lens, SheetPlacement{}, 30, 4);
  Ray left, right, centre;
  ASSERT_TRUE(camera.ray(14.999, 0.5, left));
  ASSERT_TRUE(camera.ray(14.5, 0.5, centre));
  ASSERT_TRUE(camera.ray(15.001, 0.5, right));
  EXPECT_GT(left.direction.x, centre.direction.x);
  EXPECT_LT(right.direction.x, 0.0);
}

TEST(UnitCameraLenticular, PrintSizeAndResolution) {
  LensParameters lens;  // 640 pixels at N = 15 are a 48 mm sheet
  SheetPlacement place;
  place.width = 4.0;
  place.height = 3.0;
  const Lenticular camera(lens, place, 640, 480);
  EXPECT_NEAR(camera.sheet().sheet_width(), 47.95733333333333, 1e-12);
  EXPECT_NEAR(camera.print_dpi_x(), 338.96797153024912, 1e-10);
  EXPECT_NEAR(camera.print_dpi_y(), 338.96797153024912, 1e-10);
  LensParameters near = lens;
  near.view_distance = 400.0;
  const Lenticular finite(near, place, 640, 480);
  // The print is P'/P larger both ways.
  EXPECT_NEAR(finite.print_width() / camera.print_width(), 1.0 + 3.03 / 640.0, 1e-14);
  EXPECT_NEAR(finite.print_height() / camera.print_height(), 1.0 + 3.03 / 640.0, 1e-14);
}

TEST(UnitCameraLenticular, AViewShowsTheLensesSameColumn) {
  LensParameters lens;
  lens.pixels = 14.0;
  lens.view_distance = 300.0;
  const Lenticular camera(lens, rotated_sheet(3.0, 2.0), 31, 5);
  const SheetView view(camera, 2);
  EXPECT_EQ(view.width(), 3u);
  EXPECT_EQ(view.height(), 5u);
  Ray a, b;
  for (std::uint32_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(view.ray(i + 0.5, 3.5, a));
    ASSERT_TRUE(camera.ray(i * 14 + 2.5, 3.5, b));
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.direction, b.direction);
  }
}

TEST(UnitCameraPerspective, PixelsOfAnObliqueFrame) {
  Projection p;
  p.location = {1.0, 2.0, 3.0};
  p.direction = {0.5, 0.0, 2.0};
  p.right = {-1.5, 0.25, 0.0};
  p.up = {0.0, 1.0, 0.125};
  const Projected camera(ProjectedKind::kPerspective, p, {}, 4, 2);
  Ray ray;
  ASSERT_TRUE(camera.ray(0.5, 1.5, ray));  // x0 = -0.375, y0 = -0.25
  expect_near(ray.origin, p.location, 0.0);
  const Vec3 want{0.5 + 0.5625, -0.09375 - 0.25, 2.0 - 0.03125};
  expect_near(ray.direction, want / std::sqrt(dot(want, want)), 1e-15);
}

TEST(UnitCameraOrthographic, PixelsOfAnObliqueFrame) {
  Projection p;
  p.location = {1.0, 2.0, 3.0};
  p.direction = {3.0, 0.0, 4.0};
  p.right = {8.0, 0.0, 0.0};
  p.up = {0.0, 4.0, 0.0};
  const Projected camera(ProjectedKind::kOrthographic, p, {}, 4, 2);
  Ray ray;
  ASSERT_TRUE(camera.ray(3.5, 0.5, ray));  // x0 = 0.375, y0 = 0.25
  expect_near(ray.origin, {4.0, 3.0, 3.0}, 1e-15);
  expect_near(ray.direction, {0.6, 0.0, 0.8}, 1e-15);
}

// Places of a pixel's area.

/// Of the sheets above, a few lenses wide.
std::vector<Lenticular> sheets_of_places() {
  std::vector<Lenticular> out;
  for (const LensParameters& lens :
       {LensParameters{1.124, 3.03, 1.6, 15, kCameraLenticularInf, LensModel::kPinhole},
        LensParameters{1.124, 3.03, 1.6, 14, 400, LensModel::kParaxial},
        LensParameters{0.508, 1.4, 1.56, 7, 250, LensModel::kPinhole},
        LensParameters{0.508, 1.4, 1.56, 12.4, 250, LensModel::kPinhole}}) {
    SheetPlacement place = rotated_sheet(6.5, 4.1);
    place.front = 2.75;
    place.eye_slope_x = 0.2;
    place.eye_slope_y = -0.1;
    out.emplace_back(lens, place, 93, 11);
  }
  return out;
}

TEST(UnitCameraLenticular, ThePixelsCentreIsItsRayBitForBit) {
  for (const Lenticular& camera : sheets_of_places()) {
    for (int k = 0; k < 93; ++k) {
      for (int row = 0; row < 11; ++row) {
        Ray ray, at;
        ASSERT_TRUE(camera.ray(k + 0.5, row + 0.5, ray));
        ASSERT_TRUE(camera.ray_at({.column = k, .row = row}, at));
        EXPECT_TRUE(at.origin == ray.origin && at.direction == ray.direction) << k << ' ' << row;
      }
    }
  }
}

TEST(UnitCameraLenticular, NeighboursOfAViewJoinAtWholePixels) {
  for (const Lenticular& camera : sheets_of_places()) {
    const auto views = static_cast<std::int32_t>(camera.sheet().views());
    if (views == 0) continue;
    for (int k = -views; k < 93; ++k) {  // beyond the left edge too
      for (const double turn : {0.0, 0.3, -0.5}) {
        Ray right, left;
        ASSERT_TRUE(camera.ray_at({.column = k, .row = 4, .across = 0.5, .turn = turn}, right));
        ASSERT_TRUE(
            camera.ray_at({.column = k + views, .row = 4, .across = -0.5, .turn = turn}, left));
        expect_near(right.origin, left.origin, 1e-13);
        expect_near(right.direction, left.direction, 1e-13);
      }
    }
  }
}

TEST(UnitCameraLenticular, RowsAndDirectionsJoin) {
  for (const Lenticular& camera : sheets_of_places()) {
    for (int k = 0; k < 92; ++k) {
      Ray a, b;
      ASSERT_TRUE(camera.ray_at({.column = k, .row = 4, .across = 0.2, .down = 0.5}, a));
      ASSERT_TRUE(camera.ray_at({.column = k, .row = 5, .across = 0.2, .down = -0.5}, b));
      expect_near(a.origin, b.origin, 1e-13);
      expect_near(a.direction, b.direction, 1e-13);
      if (camera.sheet().lens_of(k) != camera.sheet().lens_of(k + 1)) continue;
      ASSERT_TRUE(camera.ray_at({.column = k, .row = 4, .across = 0.2, .turn = 0.5}, a));
      ASSERT_TRUE(camera.ray_at({.column = k + 1, .row = 4, .across = 0.2, .turn = -0.5}, b));
      expect_near(a.origin, b.origin, 1e-13);
      expect_near(a.direction, b.direction, 1e-13);
    }
  }
}

}  // namespace
}  // namespace lentray::camera
