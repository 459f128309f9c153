// Rays proven: what --dump-rays writes against the formulae, and the camera's rays against stock
// POV-Ray by a coordinate probe.
//
// The probe is a plane that shows, in its own light, where it was hit: one coordinate as three
// digits of 15 bits in red, green and blue of a 16-bit linear picture. Two planes and two
// coordinates (four frames of one run) fix a line.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "camera/lenticular.h"
#include "core/image/reader.h"
#include "tests/support/render.h"
#include "tools/common/process.h"
#include "tools/lentray-diff/sheet.h"
#include "tools/lentray-diff/wrapper.h"

namespace lentray::test {
namespace {

using camera::LensModel;
using camera::LensParameters;
using camera::Lenticular;
using camera::SheetPlacement;
using core::Ray;
using core::Vec3;

constexpr double kInf = LensParameters::kInfinity;
constexpr double kRange = 64.0;  // coordinates between -32 and 32 scene units

std::string digits(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}
std::string vector_text(const Vec3& v) {
  return "<" + digits(v.x) + "," + digits(v.y) + "," + digits(v.z) + ">";
}

/// A sheet to try: its lens, its size in pixels and in the scene, and its front.
struct Trial {
  std::string name;
  LensParameters lens;
  std::uint32_t columns, rows;
  double width, height, front;
  double eye_slope_x = 0.0, eye_slope_y = 0.0;
  bool mirrored = false;
};

SheetPlacement placement(const Trial& trial) {
  SheetPlacement place;
  // Turned about all three axes, unit and perpendicular to the last bit but one.
  const double a = 0.3, b = -0.54, c = 0.157;
  const Vec3 x{std::cos(b) * std::cos(c), std::cos(b) * std::sin(c), -std::sin(b)};
  const Vec3 y0{std::sin(a) * std::sin(b) * std::cos(c) - std::cos(a) * std::sin(c),
                std::sin(a) * std::sin(b) * std::sin(c) + std::cos(a) * std::cos(c),
                std::sin(a) * std::cos(b)};
  place.right = trial.mirrored ? -x : x;
  place.up = y0;
  place.normal = core::cross(x, y0);
  place.centre = {1.3, -0.7, 2.1};
  place.width = trial.width;
  place.height = trial.height;
  place.front = trial.front;
  place.eye_slope_x = trial.eye_slope_x;
  place.eye_slope_y = trial.eye_slope_y;
  return place;
}

Lenticular camera_of(const Trial& trial) {
  return Lenticular(trial.lens, placement(trial), trial.columns, trial.rows);
}

diff::Sheet sheet_of(const Lenticular& camera) {
  diff::Sheet s;
  const SheetPlacement& place = camera.placement();
  const LensParameters& lens = camera.sheet().lens();
  s.centre = place.centre;
  s.right = place.right;
  s.up = place.up;
  s.direction = place.normal;
  s.width = place.width;
  s.height = place.height;
  s.eye_slope_x = place.eye_slope_x;
  s.eye_slope_y = place.eye_slope_y;
  s.front = place.front;
  s.pitch = lens.pitch;
  s.focal_length = lens.focal_length;
  s.ior = lens.ior;
  s.pixels = lens.pixels;
  s.view_distance = lens.view_distance;
  s.paraxial = lens.model == LensModel::kParaxial;
  s.columns = camera.width();
  s.rows = camera.height();
  return s;
}

/// The depths of the two planes, behind the sheet; the first lies before it if the rays start
/// there.
std::pair<double, double> plane_depths(const Trial& trial) {
  return {trial.front > 0.0 ? -0.5 * trial.front : 0.75, 3.0};
}

/// Frame f shows plane f / 2 and coordinate f % 2 (along right, along up). Stock runs all frames at
/// once; lentray is told the frame by Declare=.
std::string probe_scene(const Trial& trial) {
  const SheetPlacement p = placement(trial);
  const auto [near, far] = plane_depths(trial);
  const double middle = core::dot(p.centre, p.normal);
  std::ostringstream out;
  out << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
      << "#ifndef (Frame) #declare Frame = frame_number; #end\n"
      << "#declare Depth = " << digits(near) << ";\n#declare Axis = " << vector_text(p.right)
      << ";\n#declare Origin = " << digits(core::dot(p.centre, p.right)) << ";\n"
      << "#if (Frame > 1) #declare Depth = " << digits(far) << "; #end\n"
      << "#if (mod(Frame, 2) = 1) #declare Axis = " << vector_text(p.up)
      << "; #declare Origin = " << digits(core::dot(p.centre, p.up)) << "; #end\n"
      << "#declare Ax = Axis.x; #declare Ay = Axis.y; #declare Az = Axis.z;\n"
      << "#declare Scaled = function { (x*Ax + y*Ay + z*Az - Origin)/" << digits(kRange)
      << " + 0.5 };\n#declare Step = 32768;\n"
      << "#declare First = function { floor(Scaled(x,y,z)*Step) };\n"
      << "#declare Rest = function { Scaled(x,y,z)*Step - First(x,y,z) };\n"
      << "#declare Second = function { floor(Rest(x,y,z)*Step) };\n"
      << "#declare Third = function { floor((Rest(x,y,z)*Step - Second(x,y,z))*Step) };\n"
      << "plane { " << vector_text(p.normal) << ", " << digits(middle) << " + Depth\n"
      << "  pigment { average pigment_map {\n"
      << "    [1 function { First(x,y,z)/Step } color_map { [0 rgb 0] [1 rgb <3,0,0>] }]\n"
      << "    [1 function { Second(x,y,z)/Step } color_map { [0 rgb 0] [1 rgb <0,3,0>] }]\n"
      << "    [1 function { Third(x,y,z)/Step } color_map { [0 rgb 0] [1 rgb <0,0,3>] }]\n"
      << "  } }\n  finish { ambient 0 diffuse 0 emission 1 }\n}\n";
  return out.str();
}

double decoded(const core::StoredImage& image, std::uint32_t column, std::uint32_t row) {
  double value = 0.0, weight = 1.0;
  for (int channel = 0; channel < 3; ++channel) {
    weight /= 32768.0;
    value += std::round(image.at(column, row, channel) * 32768.0 / 65535.0) * weight;
  }
  return (value - 0.5) * kRange;
}

/// The four frames of a scene in stock.
std::vector<core::StoredImage> stock_frames(const tool::TemporaryFolder& folder,
                                            const std::string& scene, std::uint32_t width,
                                            std::uint32_t height) {
  tool::write_text(folder / "wrapper.pov", scene);
  const auto result =
      tool::run_program({"povray", "+Iwrapper.pov", "+Of_.png", "+W" + std::to_string(width),
                         "+H" + std::to_string(height), "+KFI0", "+KFF3", "+FN16", "-A", "-J", "-D",
                         "-V", "+WT1", "File_Gamma=1.0"},
                        folder.path(), 120.0);
  if (result.status != 0) throw std::runtime_error(result.output);
  std::vector<core::StoredImage> frames;
  for (int f = 0; f < 4; ++f) {
    frames.push_back(core::read_image(folder / ("f_" + std::to_string(f) + ".png")));
  }
  return frames;
}

/// The largest distance between where our ray and stock's meet the planes.
double miss(const Trial& trial, const Ray& ray, const std::vector<core::StoredImage>& frames,
            std::uint32_t column, std::uint32_t row) {
  const SheetPlacement p = placement(trial);
  const auto [near, far] = plane_depths(trial);
  double largest = 0.0;
  for (int plane = 0; plane < 2; ++plane) {
    const double depth = (plane == 0 ? near : far);
    const double along = core::dot(ray.direction, p.normal);
    const double t = (depth - core::dot(ray.origin - p.centre, p.normal)) / along;
    EXPECT_GT(t, 0.0);  // the plane lies before the ray's start
    const Vec3 hit = ray.at(t) - p.centre;
    const double right = decoded(frames[2 * plane], column, row);
    const double up = decoded(frames[2 * plane + 1], column, row);
    largest = std::max({largest, std::fabs(core::dot(hit, p.right) - right),
                        std::fabs(core::dot(hit, p.up) - up)});
  }
  return largest;
}

LensParameters lens(double pitch, double focal, double ior, double pixels, double distance,
                    LensModel model) {
  LensParameters out;
  out.pitch = pitch;
  out.focal_length = focal;
  out.ior = ior;
  out.pixels = pixels;
  out.view_distance = distance;
  out.model = model;
  return out;
}

class ImageRaysViews : public ::testing::TestWithParam<Trial> {};

TEST_P(ImageRaysViews, AgreeWithStocksObliqueCameras) {
  const Trial& trial = GetParam();
  const Lenticular camera = camera_of(trial);
  ASSERT_GT(camera.sheet().views(), 0u);
  ASSERT_EQ(camera.sheet().dark_columns(), 0u);
  const diff::Sheet sheet = sheet_of(camera);
  const diff::Way way =
      sheet.is_finite() ? diff::Way::perspective_views : diff::Way::orthographic_views;
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "probe.pov", probe_scene(trial));
  const std::uint32_t last = camera.sheet().views() - 1;
  double largest = 0.0;
  for (const std::uint32_t view : {0u, 3u, last / 2, last}) {
    const std::uint32_t width = sheet.view_width(view);
    const auto frames =
        stock_frames(folder, diff::view_scene(sheet, view, way, {"#version 3.7;", "probe.pov"}),
                     width, camera.height());
    for (std::uint32_t i = 0; i < width; ++i) {
      for (std::uint32_t row = 0; row < camera.height(); ++row) {
        Ray ray;
        ASSERT_TRUE(camera.ray(i * camera.sheet().views() + view + 0.5, row + 0.5, ray));
        largest = std::max(largest, miss(trial, ray, frames, i, row));
      }
    }
  }
  EXPECT_LT(largest, 1e-9);
  RecordProperty("largest", digits(largest));
}

INSTANTIATE_TEST_SUITE_P(
    Sheets, ImageRaysViews,
    ::testing::Values(
        Trial{"N15_infinite_pinhole", lens(1.124, 3.03, 1.6, 15, kInf, LensModel::kPinhole), 150,
              20, 6.5, 4.1, 0.0},
        Trial{"N15_infinite_front", lens(1.124, 3.03, 1.6, 15, kInf, LensModel::kPinhole), 150, 20,
              6.5, 4.1, 2.75},
        Trial{"N14_infinite_paraxial_cut", lens(1.124, 3.03, 1.6, 14, kInf, LensModel::kParaxial),
              103, 17, 5.0, 7.0, 1.5},
        Trial{"N14_finite", lens(1.124, 3.03, 1.6, 14, 60, LensModel::kParaxial), 140, 17, 5.0, 7.0,
              0.0},
        Trial{"N15_finite_front_cut", lens(0.9, 2.2, 1.5, 15, 80, LensModel::kParaxial), 128, 13,
              6.0, 2.0, 2.0},
        Trial{"N15_finite_oblique_mirrored", lens(0.9, 2.2, 1.5, 15, 80, LensModel::kParaxial), 120,
              13, 6.0, 2.0, 2.0, 0.2, -0.1, true},
        Trial{"N15_infinite_oblique_mirrored", lens(0.9, 2.2, 1.5, 15, kInf, LensModel::kPinhole),
              120, 13, 6.0, 2.0, 1.0, -0.15, 0.1, true}),
    [](const auto& trial) { return trial.param.name; });

class ImageRaysMesh : public ::testing::TestWithParam<Trial> {};

TEST_P(ImageRaysMesh, AgreeWithStocksMeshCamera) {
  const Trial& trial = GetParam();
  const Lenticular camera = camera_of(trial);
  ASSERT_EQ(camera.sheet().dark_columns(), 0u);
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "probe.pov", probe_scene(trial));
  // The mesh's picture lies on its side. POV-Ray 3.7 repeats its first row, so there is one more.
  const auto frames =
      stock_frames(folder, diff::mesh_scene(sheet_of(camera), {"#version 3.7;", "probe.pov"}),
                   camera.height(), camera.width() + 1);
  double largest = 0.0;
  for (std::uint32_t k = 0; k < camera.width(); ++k) {
    for (std::uint32_t row = 0; row < camera.height(); ++row) {
      Ray ray;
      ASSERT_TRUE(camera.ray(k + 0.5, row + 0.5, ray));
      largest = std::max(largest, miss(trial, ray, frames, row, k + 1));
    }
  }
  // Stock keeps the mesh in floats, yet only rays that start between eye and sheet show it.
  const diff::Sheet sheet = sheet_of(camera);
  const double eye = sheet.view_distance * sheet.scale();
  const bool exact =
      sheet.is_finite() ? std::fabs(sheet.front - eye) < 1e-9 * eye : sheet.eye_slope_y == 0.0;
  EXPECT_LT(largest, exact ? 1e-10 : 1e-7);
  RecordProperty("largest", digits(largest));
}

INSTANTIATE_TEST_SUITE_P(
    Sheets, ImageRaysMesh,
    ::testing::Values(
        Trial{"N15_infinite", lens(1.124, 3.03, 1.6, 15, kInf, LensModel::kPinhole), 150, 20, 6.5,
              4.1, 0.0},
        Trial{"N14_finite_pinhole", lens(1.124, 3.03, 1.6, 14, 60, LensModel::kPinhole), 140, 17,
              5.0, 7.0, 2.0},
        Trial{"N7_37_infinite_front", lens(0.508, 1.4, 1.56, 7.37, kInf, LensModel::kPinhole), 100,
              21, 4.2, 1.7, 2.5},
        Trial{"N7_37_finite_pinhole", lens(0.508, 1.4, 1.56, 7.37, 40, LensModel::kPinhole), 100,
              21, 4.2, 1.7, 0.0},
        Trial{"N7_37_finite_paraxial_front", lens(0.508, 1.4, 1.56, 7.37, 40, LensModel::kParaxial),
              100, 21, 4.2, 1.7, 2.5},
        Trial{"N15_oblique_mirrored", lens(0.9, 2.2, 1.5, 15, 80, LensModel::kPinhole), 120, 13,
              6.0, 2.0, 2.0, 0.1, -0.1, true},
        // Many rows, rays from the eye, from infinity and between.
        Trial{"many_rows_from_the_eye", lens(1.124, 3.03, 1.6, 14, 20, LensModel::kPinhole), 30,
              260, 2.0, 1.5, 20 * 2.0 / (30 / 14.0 * 1.124), 0.1, -0.1},
        Trial{"many_rows_infinite", lens(1.124, 3.03, 1.6, 12.5, kInf, LensModel::kPinhole), 30,
              500, 2.0, 1.5, 2.0, 0.1, -0.1},
        Trial{"many_rows_between", lens(1.124, 3.03, 1.6, 14, 20, LensModel::kPinhole), 30, 260,
              2.0, 1.5, 5.0, 0.1, -0.1}),
    [](const auto& trial) { return trial.param.name; });

/// A probe that cannot tell rays apart proves nothing: a sheet one part in ten thousand off fails.
TEST(ImageRaysProbe, SeesSmallMistakes) {
  Trial trial{"", lens(1.124, 3.03, 1.6, 15, kInf, LensModel::kPinhole), 60, 5, 6.5, 4.1, 0.0};
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "probe.pov", probe_scene(trial));
  const diff::Sheet sheet = sheet_of(camera_of(trial));
  const auto frames = stock_frames(
      folder,
      diff::view_scene(sheet, 2, diff::Way::orthographic_views, {"#version 3.7;", "probe.pov"}), 4,
      5);
  trial.lens.focal_length *= 1.0001;
  Ray ray;
  ASSERT_TRUE(camera_of(trial).ray(2.5, 0.5, ray));
  EXPECT_GT(miss(trial, ray, frames, 0, 0), 1e-6);
}

/// What --dump-rays says of a pixel.
struct DumpedRay {
  bool dark = true;
  Vec3 origin, direction;
};

std::vector<DumpedRay> read_dump(const std::filesystem::path& path, std::uint32_t width,
                                 std::uint32_t height) {
  std::ifstream in(path);
  std::vector<DumpedRay> rays(std::size_t{width} * height);
  std::size_t lines = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::uint32_t column = 0, row = 0;
    std::string first;
    words >> column >> row >> first;
    DumpedRay& r = rays.at(std::size_t{row} * width + column);
    ++lines;
    if (first == "dark") continue;
    r.dark = false;
    r.origin.x = std::stod(first);
    words >> r.origin.y >> r.origin.z >> r.direction.x >> r.direction.y >> r.direction.z;
    EXPECT_FALSE(words.fail()) << line;
  }
  EXPECT_EQ(lines, rays.size());
  return rays;
}

std::string lenticular_scene(const Trial& trial) {
  const SheetPlacement p = placement(trial);
  const LensParameters& l = trial.lens;
  std::ostringstream out;
  out << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nsphere { 100, 1 }\ncamera {\n"
      << "  lenticular location " << vector_text(p.centre) << " direction " << vector_text(p.normal)
      << "\n  right " << vector_text(p.right * p.width) << " up " << vector_text(p.up * p.height)
      << "\n  lens_pitch " << digits(l.pitch) << " lens_focal_length " << digits(l.focal_length)
      << " lens_ior " << digits(l.ior) << "\n  lens_pixels " << digits(l.pixels) << " lens_front "
      << digits(p.front) << "\n  view_distance " << (l.is_finite() ? digits(l.view_distance) : "0")
      << " lens_model " << camera::name_of(l.model) << "\n}\n";
  return out.str();
}

/// The formulae once more, in long double and by angles.
bool formula(const Trial& trial, std::uint32_t column, std::uint32_t row, Vec3& origin,
             Vec3& direction) {
  using Real = long double;
  const LensParameters& l = trial.lens;
  const SheetPlacement p = placement(trial);
  const Real n = l.pixels, pitch = l.pitch, f = l.focal_length, ior = l.ior;
  const Real inverse_v = l.is_finite() ? 1.0L / l.view_distance : 0.0L;
  const Real lenses = trial.columns / n, scale = trial.width / (lenses * pitch);
  const Real print = pitch * (1.0L + f * inverse_v / ior);
  const Real lens = std::floor((column + 0.5L) / n);
  const Real axis = (lens + 0.5L - lenses / 2.0L) * pitch;
  const Real offset = ((column + 0.5L) / n - lenses / 2.0L) * print - axis;
  Real slope = ior * offset / f;
  if (l.model == LensModel::kPinhole) {
    const Real sine = ior * std::sin(std::atan(offset / f));
    if (std::fabs(sine) >= 1.0L) return false;
    slope = std::tan(std::asin(sine));
  }
  const Real y = (0.5L - (row + 0.5L) / trial.rows) * trial.height;
  const Real rise = y * inverse_v / scale;
  Real v[3], size = 0.0L;
  for (int a = 0; a < 3; ++a) {
    v[a] = slope * p.right[a] + p.normal[a] + rise * p.up[a];
    size += v[a] * v[a];
  }
  for (int a = 0; a < 3; ++a) {
    origin[a] =
        static_cast<double>(p.centre[a] + axis * scale * p.right[a] + y * p.up[a] - p.front * v[a]);
    direction[a] = static_cast<double>(v[a] / std::sqrt(size));
  }
  return true;
}

class ImageRaysDump : public ::testing::TestWithParam<Trial> {};

TEST_P(ImageRaysDump, FollowsTheFormulae) {
  const Trial& trial = GetParam();
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", lenticular_scene(trial));
  const auto result =
      run_lentray({"+Iscene.pov", "+W" + std::to_string(trial.columns),
                   "+H" + std::to_string(trial.rows), "-F", "-V", "--dump-rays", "rays.txt"},
                  folder.path());
  ASSERT_EQ(result.status, 0) << result.output;
  const auto rays = read_dump(folder / "rays.txt", trial.columns, trial.rows);
  double largest = 0.0;
  std::size_t dark = 0;
  for (std::uint32_t row = 0; row < trial.rows; ++row) {
    for (std::uint32_t column = 0; column < trial.columns; ++column) {
      const DumpedRay& got = rays[std::size_t{row} * trial.columns + column];
      Vec3 origin, direction;
      const bool lit = formula(trial, column, row, origin, direction);
      ASSERT_EQ(got.dark, !lit) << column << " " << row;
      if (!lit) {
        ++dark;
        continue;
      }
      for (int a = 0; a < 3; ++a) {
        largest = std::max({largest, std::fabs(got.origin[a] - origin[a]),
                            std::fabs(got.direction[a] - direction[a])});
      }
    }
  }
  EXPECT_LT(largest, 1e-12);
  EXPECT_EQ(dark > 0, trial.name == "total_reflection");
  RecordProperty("largest", digits(largest));
}

INSTANTIATE_TEST_SUITE_P(
    Sheets, ImageRaysDump,
    ::testing::Values(
        Trial{"N15_infinite", lens(1.124, 3.03, 1.6, 15, kInf, LensModel::kPinhole), 150, 20, 6.5,
              4.1, 0.0},
        Trial{"N14_finite_paraxial", lens(1.124, 3.03, 1.6, 14, 60, LensModel::kParaxial), 140, 17,
              5.0, 7.0, 2.0},
        Trial{"N14_finite_pinhole", lens(1.124, 3.03, 1.6, 14, 60, LensModel::kPinhole), 140, 17,
              5.0, 7.0, 2.0},
        Trial{"N7_37_finite", lens(0.508, 1.4, 1.56, 7.37, 40, LensModel::kPinhole), 100, 21, 4.2,
              1.7, 2.5},
        Trial{"N7_37_infinite_paraxial", lens(0.508, 1.4, 1.56, 7.37, kInf, LensModel::kParaxial),
              100, 21, 4.2, 1.7, 2.5},
        Trial{"total_reflection", lens(6.0, 3.03, 1.6, 15, kInf, LensModel::kPinhole), 45, 4, 6.5,
              4.1, 1.0}),
    [](const auto& trial) { return trial.param.name; });

/// The same probe, seen by lentray's own renderer: not only the camera but the whole way to the
/// file keeps its digits.
TEST(ImageRaysProbe, LentraySeesItAsStockDoes) {
  const Trial trial{"", lens(0.508, 1.4, 1.56, 7.37, 40, LensModel::kPinhole), 100, 21, 4.2, 1.7,
                    2.5};
  const Lenticular camera = camera_of(trial);
  SceneText scene;
  scene.sdl =
      probe_scene(trial) + lenticular_scene(trial).substr(lenticular_scene(trial).find("camera"));
  scene.width = trial.columns;
  scene.height = trial.rows;
  scene.bits = 16;
  std::vector<core::StoredImage> frames;
  for (int f = 0; f < 4; ++f) {
    scene.arguments = {"File_Gamma=1.0", "Declare=Frame=" + std::to_string(f)};
    frames.push_back(lentray_render(scene));
  }
  double largest = 0.0;
  for (std::uint32_t k = 0; k < trial.columns; ++k) {
    for (std::uint32_t row = 0; row < trial.rows; ++row) {
      Ray ray;
      ASSERT_TRUE(camera.ray(k + 0.5, row + 0.5, ray));
      largest = std::max(largest, miss(trial, ray, frames, k, row));
    }
  }
  EXPECT_LT(largest, 1e-9);
}

}  // namespace
}  // namespace lentray::test
