// Lenticular=On: sheets of the cameras that scenes have. Their rays, as --dump-rays writes them,
// against geometry worked out here; their middle view against the ordinary picture of lentray and of
// stock; their views against stock; and what is refused and said.
//
// The geometry: where the eye is finitely far and the model paraxial, the ray of a pixel is the line
// from its view's eye to the axis of its lens, no formula of slopes needed. Otherwise Snell's law, by
// angles. All in long double.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(const Vector& a, Real f) { return {a[0] * f, a[1] * f, a[2] * f}; }
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real length(const Vector& a) { return std::sqrt(dot(a, a)); }
Vector unit(const Vector& a) { return a * (1.0L / length(a)); }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A camera's vectors as they should be when the scene is read.
struct Frame {
  Vector location{0, 0, 0}, direction{0, 0, 1}, right{1.33L, 0, 0}, up{0, 1, 0};
};

Frame looking(const Vector& from, const Vector& to, Real along, Real wide, Real high,
              const Vector& sky = {0, 1, 0}) {
  const Vector d = unit(to - from), r = unit(cross(sky, d));
  return {from, d * along, r * wide, cross(d, r) * high};
}

Vector turned(const Vector& v, int axis, Real degrees) {
  const Real a = degrees * std::acos(-1.0L) / 180.0L;
  const int i = (axis + 1) % 3, k = (axis + 2) % 3;
  Vector out = v;
  out[i] = v[i] * std::cos(a) - v[k] * std::sin(a);
  out[k] = v[i] * std::sin(a) + v[k] * std::cos(a);
  return out;
}

/// rotate <x, y, z> scale s translate t
Frame moved(const Frame& f, const Vector& degrees, Real scale, const Vector& by) {
  const auto move = [&](Vector v) {
    for (int axis = 0; axis < 3; ++axis) v = turned(v, axis, degrees[axis]);
    return v * scale;
  };
  return {move(f.location) + by, move(f.direction), move(f.right), move(f.up)};
}

constexpr Real kEye = -1.0L, kInfinite = 0.0L;

struct SheetCameraCase {
  std::string name;
  std::string sdl;  ///< the camera, with what must stand before it
  Frame frame;
  Real distance = 1.0L;  ///< from location along direction to the sheet, scene units
  bool orthographic = false;
  std::vector<std::string> options{};  ///< besides Lenticular=On
  Real view_distance = kEye;           ///< mm
  bool paraxial = true;
  Real pixels = 5.0L;
  Real front = -1.0L;              ///< scene units; -1: the eye's plane
  bool middle_is_ordinary = true;  ///< the eye is the scene's own
  friend void PrintTo(const SheetCameraCase& c, std::ostream* out) { *out << c.name; }
};

constexpr Real kPitch = 1.124L, kFocal = 3.03L, kIor = 1.6L;
constexpr std::uint32_t kLenses = 40, kRows = 30;

std::uint32_t columns_of(const SheetCameraCase& c) {
  return static_cast<std::uint32_t>(std::lround(c.pixels * kLenses));
}

struct Line {
  Vector origin{}, direction{};
};

/// The pixel's ray from the geometry alone.
Line expected(const SheetCameraCase& c, std::uint32_t column, std::uint32_t row) {
  const Frame& f = c.frame;
  const Real grown = c.orthographic ? 1.0L : c.distance / length(f.direction);
  const Real width = length(f.right) * grown, height = length(f.up) * grown;
  const Vector r = unit(f.right), u = unit(f.up);
  Vector d = unit(cross(r, u));
  if (dot(d, f.direction) < 0.0L) d = d * -1.0L;
  const Vector middle = f.location + unit(f.direction) * c.distance;
  const Vector foot = f.location + d * dot(middle - f.location, d);  // before the eye, on the sheet
  const Real depth = dot(middle - f.location, d);
  const Real lenses = columns_of(c) / c.pixels, scale = width / (lenses * kPitch);
  const bool finite = c.view_distance != kInfinite;
  const Real v = c.view_distance == kEye ? depth / scale : c.view_distance;  // mm
  const Real print = finite ? kPitch * (1.0L + kFocal / (kIor * v)) : kPitch;
  const Real lens = std::floor((column + 0.5L) / c.pixels);
  const Real cell = ((column + 0.5L) / c.pixels - lens - 0.5L) * print;
  const Vector axis = middle + r * ((lens + 0.5L - lenses / 2.0L) * kPitch * scale) +
                      u * ((0.5L - (row + 0.5L) / kRows) * height);
  const Vector aside =
      (foot - middle) * (-1.0L / depth);  // slopes along r and u, V infinite or not
  const Vector away = aside + d;
  const Real front = c.front >= 0.0L ? c.front : (finite ? std::min(depth, v * scale) : depth);
  Vector slope;
  if (c.paraxial && finite) {
    const Vector eye = middle - away * (v * scale) - r * (v * kIor * cell / kFocal * scale);
    slope = (axis - eye) * (1.0L / (v * scale));
  } else {
    const Real sideways = dot(aside, r), upwards = dot(aside, u);
    const Vector tilt = finite ? (axis - middle) * (1.0L / (v * scale)) : Vector{0, 0, 0};
    const Real shift = finite || c.paraxial
                           ? kFocal / kIor * sideways
                           : kFocal * std::tan(std::asin(std::sin(std::atan(sideways)) / kIor));
    const Real offset = cell + shift + kFocal / kIor * dot(tilt, r);
    const Real tangent = c.paraxial
                             ? kIor * offset / kFocal
                             : std::tan(std::asin(kIor * std::sin(std::atan(offset / kFocal))));
    slope = r * tangent + d + u * (upwards + dot(tilt, u));
  }
  return {axis - slope * front, unit(slope)};
}

/// Every ray of a dump; the scene is `sdl` and something to see.
std::vector<Line> dumped(const std::string& sdl, std::uint32_t width,
                         const std::vector<std::string>& options, std::string* said = nullptr) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", sdl);
  std::vector<std::string> arguments{"+Iscene.pov",
                                     "+W" + std::to_string(width),
                                     "+H" + std::to_string(kRows),
                                     "-F",
                                     "-V",
                                     "--dump-rays",
                                     "rays.txt"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const auto result = run_lentray(arguments, folder.path());
  if (said != nullptr) *said = result.output;
  if (result.status != 0) throw std::runtime_error(result.output);
  std::ifstream in(folder / "rays.txt");
  std::vector<Line> rays;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::uint32_t column = 0, row = 0;
    Line ray;
    words >> column >> row;
    for (Real& x : ray.origin) words >> x;
    for (Real& x : ray.direction) words >> x;
    if (words.fail()) throw std::runtime_error(line);
    rays.push_back(ray);
  }
  return rays;
}

std::vector<std::string> options_of(const SheetCameraCase& c) {
  std::vector<std::string> options{"Lenticular=On"};
  char pixels[40];
  std::snprintf(pixels, sizeof pixels, "Lens_Pixels=%.17g", static_cast<double>(c.pixels));
  options.emplace_back(pixels);
  options.insert(options.end(), c.options.begin(), c.options.end());
  return options;
}

// No edges at round places: rays that graze them would hang on the last bit.
const char* const kThings =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    "background { rgb <.2,.3,.5> }\n"
    "light_source { <20,40,-30> rgb 1 }\n"
    "plane { y, -2 pigment { checker rgb <.9,.8,.6> rgb <.3,.4,.2> translate <.137,0,.291> } }\n"
    "sphere { <0,0,3>, 1.6 pigment { rgb <.8,.2,.1> } finish { phong .5 reflection .2 } }\n"
    "box { <1.013,-1.47,-1.02>, <1.97,1.03,.04>\n"
    "  pigment { gradient x color_map { [0 rgb 1] [1 rgb z] } scale .317 } }\n"
    "cylinder { <-3,-2,1>, <-2,2,2>, .6 pigment { rgb <.2,.6,.3> } }\n";

std::string sheet_camera_scene_of(const SheetCameraCase& c) { return kThings + c.sdl + "\n"; }

class SheetCameraRays : public ::testing::TestWithParam<SheetCameraCase> {};

TEST_P(SheetCameraRays, AreThoseOfTheGeometry) {
  const SheetCameraCase& c = GetParam();
  const std::uint32_t width = columns_of(c);
  const auto rays = dumped(sheet_camera_scene_of(c), width, options_of(c));
  ASSERT_EQ(rays.size(), std::size_t{width} * kRows);
  Real largest = 0.0L;
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const Line& got = rays[std::size_t{row} * width + column];
      const Line want = expected(c, column, row);
      for (int a = 0; a < 3; ++a) {
        largest = std::max({largest, std::fabs(got.origin[a] - want.origin[a]),
                            std::fabs(got.direction[a] - want.direction[a])});
      }
    }
  }
  EXPECT_LT(largest, 1e-12L);
}

const SheetCameraCase kSheetCameraCases[] = {
    {"look_at", "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1), length({.5L, 2, 10})},
    {"look_at_under_transforms",
     "camera { location <0,1,-6> look_at <.3,.2,.5> right x*1.6 up y*1.2 direction z*1.5\n"
     "  rotate <10,25,-5> scale 1.5 translate <.5,.25,-1> }",
     moved(looking({0, 1, -6}, {.3L, .2L, .5L}, 1.5L, 1.6L, 1.2L), {10, 25, -5}, 1.5L,
           {.5L, .25L, -1}),
     1.5L * length({.3L, -.8L, 6.5L})},
    {"named_camera_moved",
     "#declare C = camera { location <0,1,-6> look_at 0 right x*4/3 rotate y*10 }\n"
     "camera { C rotate y*15 scale 1.25 }",
     moved(moved(looking({0, 1, -6}, {0, 0, 0}, 1, 4.0L / 3, 1), {0, 10, 0}, 1, {0, 0, 0}),
           {0, 15, 0}, 1.25L, {0, 0, 0}),
     1.25L * length({0, 1, 6})},
    {"sky_and_angle",
     "camera { sky <1,3,0> location <2,1,-8> look_at <0,.5,0> right x*4/3 angle 50 }",
     looking({2, 1, -8}, {0, .5L, 0}, 2.0L / 3 / std::tan(25.0L * std::acos(-1.0L) / 180), 4.0L / 3,
             1, {1, 3, 0}),
     length({2, .5L, 8})},
    {"words_in_old_order",
     "#version 3.1;\ncamera { location <0,1,-6> look_at <.3,.2,.5> direction <0,0,2> right x*4/3\n"
     "  up y translate <.5,0,0> }",
     {{.5L, 1, -6}, {0, 0, 2}, {4.0L / 3, 0, 0}, {0, 1, 0}},
     length({.3L, -.8L, 6.5L})},
    {"mirrored_right", "camera { location <1,2,-9> right -x*4/3 look_at <.5,0,1> }",
     [] {
       Frame f = looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1);
       f.right = f.right * -1.0L;
       return f;
     }(),
     length({.5L, 2, 10})},
    {"oblique_direction",
     "camera { location <-1,1,-8> direction <.25,-.2,1.5> right x*4/3 up y }",
     {{-1, 1, -8}, {.25L, -.2L, 1.5L}, {4.0L / 3, 0, 0}, {0, 1, 0}},
     7.5L,
     false,
     {"Sheet_Distance=7.5"}},
    {"oblique_and_mirrored",
     "camera { location <-1,1,-8> direction <.25,-.2,1.5> right -x*4/3 up y*.75 rotate <0,8,3> }",
     moved({{-1, 1, -8}, {.25L, -.2L, 1.5L}, {-4.0L / 3, 0, 0}, {0, .75L, 0}}, {0, 8, 3}, 1,
           {0, 0, 0}),
     7.5L,
     false,
     {"Sheet_Distance=7.5"}},
    {"oblique_from_infinity",
     "camera { location <-1,1,-8> direction <.25,-.2,1.5> right x*4/3 up y }",
     {{-1, 1, -8}, {.25L, -.2L, 1.5L}, {4.0L / 3, 0, 0}, {0, 1, 0}},
     7.5L,
     false,
     {"Sheet_Distance=7.5", "View_Distance=inf"},
     kInfinite,
     false,
     5,
     -1,
     false},
    {"oblique_pinhole",
     "camera { location <-1,1,-8> direction <.25,-.2,1.5> right x*4/3 up y }",
     {{-1, 1, -8}, {.25L, -.2L, 1.5L}, {4.0L / 3, 0, 0}, {0, 1, 0}},
     7.5L,
     false,
     {"Sheet_Distance=7.5", "Lens_Model=pinhole"},
     kEye,
     false,
     5,
     -1,
     false},
    {"sheet_distance",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     6.25L,
     false,
     {"Sheet_Distance=6.25"}},
    {"from_infinity",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     length({.5L, 2, 10}),
     false,
     {"View_Distance=inf"},
     kInfinite,
     false,
     5,
     -1,
     false},
    {"zero_means_infinity",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     length({.5L, 2, 10}),
     false,
     {"View_Distance=0", "Lens_Model=paraxial"},
     kInfinite,
     true,
     5,
     -1,
     false},
    {"nearer_than_the_eye",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     length({.5L, 2, 10}),
     false,
     {"View_Distance=25"},
     25.0L,
     true,
     5,
     -1,
     false},
    {"farther_than_the_eye",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     length({.5L, 2, 10}),
     false,
     {"View_Distance=80"},
     80.0L,
     true,
     5,
     -1,
     false},
    {"pinhole_at_the_eye",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     length({.5L, 2, 10}),
     false,
     {"Lens_Model=pinhole"},
     kEye,
     false,
     5,
     -1,
     false},
    {"own_front",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     length({.5L, 2, 10}),
     false,
     {"Lens_Front=3.5"},
     kEye,
     true,
     5,
     3.5L},
    {"fractional_pixels",
     "camera { location <1,2,-9> look_at <.5,0,1> right x*4/3 }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 4.0L / 3, 1),
     length({.5L, 2, 10}),
     false,
     {},
     kEye,
     true,
     7.3L,
     -1,
     false},
    {"orthographic",
     "camera { orthographic location <1,2,-9> right x*8 up y*6 look_at <.5,0,1> }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 8, 6),
     0.0L,
     true,
     {},
     kInfinite,
     false},
    {"orthographic_by_look_at",
     "camera { orthographic location <1,2,-9> look_at <.5,0,1> }",
     looking({1, 2, -9}, {.5L, 0, 1}, 1, 1.33L * length({.5L, 2, 10}), length({.5L, 2, 10})),
     0.0L,
     true,
     {},
     kInfinite,
     false},
    {"orthographic_oblique",
     "camera { orthographic location <-1,1,-8> direction <.2,-.1,1> right x*8 up y*6 }",
     {{-1, 1, -8}, {.2L, -.1L, 1}, {8, 0, 0}, {0, 6, 0}},
     0.0L,
     true,
     {},
     kInfinite,
     false},
    {"orthographic_moved_sheet",
     "camera { orthographic location <-1,1,-8> direction <.2,-.1,1> right -x*8 up y*6 }",
     {{-1, 1, -8}, {.2L, -.1L, 1}, {-8, 0, 0}, {0, 6, 0}},
     7.0L,
     true,
     {"Sheet_Distance=7", "Lens_Model=paraxial"},
     kInfinite,
     true},
};

INSTANTIATE_TEST_SUITE_P(Cameras, SheetCameraRays, ::testing::ValuesIn(kSheetCameraCases),
                         [](const auto& trial) { return trial.param.name; });

/// Odd N: the middle view's lines are those of the scene's own camera.
class SheetCameraMiddleRays : public ::testing::TestWithParam<SheetCameraCase> {};

TEST_P(SheetCameraMiddleRays, AreTheOrdinaryCameras) {
  const SheetCameraCase& c = GetParam();
  std::vector<std::string> options = options_of(c);
  options.emplace_back("View=2");
  const auto view = dumped(sheet_camera_scene_of(c), columns_of(c), options);
  const auto ordinary = dumped(sheet_camera_scene_of(c), kLenses, {});
  ASSERT_EQ(view.size(), ordinary.size());
  Real largest = 0.0L;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const Line &a = view[i], &b = ordinary[i];
    largest = std::max({largest, length(a.direction - b.direction),
                        length(cross(b.origin - a.origin, a.direction))});
  }
  EXPECT_LT(largest, 1e-12L);
}

std::vector<SheetCameraCase> from_their_own_eye() {
  std::vector<SheetCameraCase> out;
  for (const SheetCameraCase& c : kSheetCameraCases) {
    if (c.middle_is_ordinary) out.push_back(c);
  }
  return out;
}

INSTANTIATE_TEST_SUITE_P(Cameras, SheetCameraMiddleRays, ::testing::ValuesIn(from_their_own_eye()),
                         [](const auto& trial) { return trial.param.name; });

/// Pictures for those cases that add something in a picture.
class SheetCameraPicture : public ::testing::TestWithParam<std::string> {
 protected:
  const SheetCameraCase& trial() const {
    for (const SheetCameraCase& c : kSheetCameraCases) {
      if (c.name == GetParam()) return c;
    }
    throw std::logic_error(GetParam());
  }
};

class SheetCameraMiddleView : public SheetCameraPicture {};

TEST_P(SheetCameraMiddleView, IsTheOrdinaryPicture) {
  SceneText scene;
  scene.sdl = sheet_camera_scene_of(trial());
  scene.width = kLenses;
  scene.height = kRows;
  const StoredImage ordinary = lentray_render(scene), stock = stock_render(scene);
  scene.width = columns_of(trial());
  std::vector<std::string> options = options_of(trial());
  options.emplace_back("View=2");
  const StoredImage view = lentray_render(scene, options);
  // The rays agree to rounding, so all but what hangs on rounding has the same bits.
  const Comparison c = core::compare(view, ordinary, core::Columns::all(kLenses));
  EXPECT_EQ(c.beyond_1, 0u) << describe(c);
  EXPECT_LT(c.mean, 0.002) << describe(c);
  EXPECT_TRUE(reaches(view, stock, Grade::exact));
  // Another view is another picture: the comparison would tell.
  options.back() = "View=4";
  EXPECT_LT(core::compare(lentray_render(scene, options), stock, core::Columns::all(kLenses)).grade,
            Grade::match);
}

INSTANTIATE_TEST_SUITE_P(Cameras, SheetCameraMiddleView,
                         ::testing::Values("look_at_under_transforms", "named_camera_moved",
                                           "sky_and_angle", "words_in_old_order", "mirrored_right",
                                           "oblique_and_mirrored", "sheet_distance",
                                           "orthographic_by_look_at", "orthographic_oblique",
                                           "orthographic_moved_sheet"),
                         [](const auto& trial) { return trial.param; });

/// All views, live against stock.
class SheetCameraViews : public SheetCameraPicture {};

TEST_P(SheetCameraViews, AreStocks) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", sheet_camera_scene_of(trial()));
  std::vector<std::string> arguments = options_of(trial());
  arguments.insert(arguments.end(),
                   {"scene.pov", "+W" + std::to_string(columns_of(trial())), "+H60", "--threads",
                    "1", "--no-pictures", "--grade", "exact", "--json", "report.json"});
  const auto result = run_diff(arguments, folder.path());
  EXPECT_EQ(result.status, 0) << result.output;
}

INSTANTIATE_TEST_SUITE_P(Cameras, SheetCameraViews,
                         ::testing::Values("look_at_under_transforms", "mirrored_right",
                                           "oblique_direction", "oblique_from_infinity",
                                           "oblique_pinhole", "from_infinity",
                                           "nearer_than_the_eye", "pinhole_at_the_eye", "own_front",
                                           "fractional_pixels", "orthographic",
                                           "orthographic_oblique"),
                         [](const auto& trial) { return trial.param; });

// What is said and refused, by the whole program.

nlohmann::json lens_of(const std::string& camera, std::vector<std::string> more, std::string& said,
                       const std::string& things = kThings) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", things + camera + "\n");
  more.insert(more.end(),
              {"+Iscene.pov", "+Oo.png", "+W200", "+H30", "-V", "Statistics_File=s.json"});
  const auto result = run_lentray(more, folder.path());
  said = result.output;
  if (result.status != 0) return {};
  return nlohmann::json::parse(tool::read_text(folder / "s.json"))["lens"];
}

TEST(SheetCamera, WithoutLookAtTheMedianDepthCounts) {
  // A wall fills most of the picture, a ball before it and the sky beside it the rest.
  const std::string things =
      "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
      "box { <-4,-90,11.9>, <90,90,30> }\nsphere { <0,0,-2>, 1.5 }\n";
  std::string said;
  const nlohmann::json lens =
      lens_of("camera { location <0,0,-9> direction z*1.5 right x*4/3 up y }", {"Lenticular=On"},
              said, things);
  EXPECT_NE(said.find("Sheet distance 20.9, the median depth of what the camera sees (it has no "
                      "look_at)"),
            std::string::npos)
      << said;
  ASSERT_FALSE(lens.is_null());
  EXPECT_NEAR(lens["centre"][2].get<double>(), 11.9, 1e-12);
  // With a look_at nothing is looked for.
  (void)lens_of("camera { location <0,0,-9> look_at 0 }", {"Lenticular=On"}, said);
  EXPECT_NE(said.find("Sheet distance 9, where the camera looks at"), std::string::npos) << said;
  (void)lens_of("camera { location <0,0,-9> look_at 0 }", {"Lenticular=On", "Sheet_Distance=4"},
                said);
  EXPECT_NE(said.find("Sheet distance 4, as asked for"), std::string::npos) << said;
  // Away from everything there is no depth.
  EXPECT_TRUE(lens_of("camera { location y*3 direction y right x up z }", {"Lenticular=On"}, said)
                  .is_null());
  EXPECT_NE(said.find("give Sheet_Distance"), std::string::npos) << said;
}

TEST(SheetCamera, ModelFollowsTheViewingDistance) {
  const std::string camera = "camera { location <0,1,-9> look_at 0 }";
  const std::string orthographic = "camera { orthographic location <0,1,-9> look_at 0 }";
  std::string said;
  EXPECT_EQ(lens_of(camera, {"Lenticular=On"}, said)["model"], "paraxial");
  EXPECT_EQ(said.find("Rays miss the eyes"), std::string::npos);
  EXPECT_EQ(lens_of(camera, {"Lenticular=On", "View_Distance=300"}, said)["model"], "paraxial");
  EXPECT_EQ(lens_of(camera, {"Lenticular=On", "View_Distance=inf"}, said)["model"], "pinhole");
  EXPECT_EQ(lens_of(orthographic, {"Lenticular=On"}, said)["model"], "pinhole");
  EXPECT_EQ(
      lens_of(camera, {"Lenticular=On", "View_Distance=inf", "Lens_Model=paraxial"}, said)["model"],
      "paraxial");
  EXPECT_EQ(lens_of(camera, {"Lenticular=On", "Lens_Model=pinhole"}, said)["model"], "pinhole");
  EXPECT_NE(said.find("Rays miss the eyes of their views by at most "), std::string::npos) << said;
}

/// Pinhole at a finite distance: the miss is printed in pixels; here it is found from the rays.
TEST(SheetCamera, PinholeMissesTheEyesByWhatItSays) {
  const std::string camera = "camera { location <0,1,-9> look_at 0 right x*4/3 }";
  std::string said;
  const nlohmann::json lens = lens_of(camera, {"Lenticular=On", "Lens_Model=pinhole"}, said);
  ASSERT_FALSE(lens.is_null());
  const double p = 1.124, f = 3.03, n = 1.6, pixels = 15.0, v = lens["view_distance_mm"];
  const double print = p * (1.0 + f / (n * v)), lenses = 200 / pixels;
  double largest = 0.0;
  for (int k = 0; k < 200; ++k) {
    const double i = std::floor((k + 0.5) / pixels), x = (i + 0.5 - lenses / 2.0) * p;
    const double cell = ((k + 0.5) / pixels - i - 0.5) * print;
    // The view's eye is where the middle lens sends this cell offset.
    const double to_eye = std::tan(std::asin(n * std::sin(std::atan(cell / f)))) + x / v;
    const double hits = f * std::tan(std::asin(std::sin(std::atan(to_eye)) / n));
    largest = std::max(largest, std::fabs(cell + x * f / (n * v) - hits) / (print / pixels));
  }
  EXPECT_GT(largest, 0.01);
  EXPECT_NEAR(lens["eye_miss_px"].get<double>(), largest, 1e-9);
  char line[80];
  std::snprintf(line, sizeof line, "by at most %.6g pixels (Snell's law)", largest);
  EXPECT_NE(said.find(line), std::string::npos) << said;
}

TEST(SheetCamera, FrontIsTheEyesPlaneAndNoFarther) {
  const std::string camera = "camera { location <0,1,-9> look_at <0,1,0> right x*4/3 }";
  std::string said;
  EXPECT_NEAR(lens_of(camera, {"Lenticular=On"}, said)["front"].get<double>(), 9.0, 1e-12);
  EXPECT_EQ(said.find("lens_front"), std::string::npos) << said;
  EXPECT_NEAR(lens_of(camera, {"Lenticular=On", "View_Distance=inf"}, said)["front"].get<double>(),
              9.0, 1e-12);
  EXPECT_NEAR(lens_of(camera, {"Lenticular=On", "Lens_Front=100"}, said)["front"].get<double>(),
              9.0, 1e-12);
  EXPECT_NE(said.find("lens_front reaches beyond the eye"), std::string::npos) << said;
  EXPECT_NEAR(lens_of(camera, {"Lenticular=On", "Lens_Front=2"}, said)["front"].get<double>(), 2.0,
              1e-15);
  EXPECT_NEAR(
      lens_of(camera, {"Lenticular=On", "Lens_Front=100", "View_Distance=inf"}, said)["front"]
          .get<double>(),
      100.0, 1e-12);
  EXPECT_EQ(lens_of("camera { orthographic location <0,1,-9> right x*8 up y*6 look_at 0 }",
                    {"Lenticular=On"}, said)["front"],
            0.0);
  // Of `lenticular` in a scene: the sheet's width.
  const std::string sheet =
      "camera { lenticular location <0,1,0> direction z right x*8 up y*6 lens_pixels 15 }";
  EXPECT_NEAR(lens_of(sheet, {}, said)["front"].get<double>(), 8.0, 1e-15);
}

TEST(ErrorSheetCamera, RefusalsNameTheCamera) {
  const std::pair<const char*, const char*> cameras[] = {
      {"fisheye angle 180", "`fisheye`"},
      {"ultra_wide_angle angle 120", "`ultra_wide_angle`"},
      {"omnimax", "`omnimax`"},
      {"panoramic angle 100", "`panoramic`"},
      {"spherical angle 360", "`spherical`"},
      {"cylinder 1 angle 90", "`cylinder`"},
      {"cylinder 2 angle 90", "`cylinder`"},
      {"cylinder 3 angle 90", "`cylinder`"},
      {"cylinder 4 angle 90", "`cylinder`"},
      {"mesh_camera { 1 0 mesh { triangle { 0, x, y } } }", "`mesh_camera`"},
  };
  for (const auto& [words, name] : cameras) {
    std::string said;
    EXPECT_TRUE(lens_of("camera { " + std::string(words) + " location <0,1,-9> look_at 0 }",
                        {"Lenticular=On"}, said)
                    .is_null())
        << words;
    EXPECT_NE(said.find(name), std::string::npos) << words << ": " << said;
    EXPECT_NE(said.find("has no lens sheet"), std::string::npos) << words << ": " << said;
  }
}

TEST(ErrorSheetCamera, ASkewedFrameIsRefused) {
  std::string said;
  EXPECT_TRUE(lens_of("camera { location <0,1,-9> direction z right <4/3,.1,0> up y }",
                      {"Lenticular=On", "Sheet_Distance=5"}, said)
                  .is_null());
  EXPECT_NE(said.find("`right` is not perpendicular to `up`"), std::string::npos) << said;
  EXPECT_TRUE(lens_of("camera { location <0,1,-9> direction x right x*4/3 up y }",
                      {"Lenticular=On", "Sheet_Distance=5"}, said)
                  .is_null());
  EXPECT_NE(said.find("picture plane"), std::string::npos) << said;
}

}  // namespace
}  // namespace lentray::test
