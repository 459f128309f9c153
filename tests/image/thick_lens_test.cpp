// The lens model thick against stock tracing a sheet of glass. In stock the rays of a mesh_camera
// start at the pixels of the print, inside the glass, one through each part of the aperture, and
// leave through the cylinders to pictures that stand before the sheet. Nothing of the lens's own
// surface is told to stock but the cylinders; where rays start, and where they aim in the glass, is
// computed here a second time.
//
// The light that stock follows leaves towards the viewer; Lentray follows the same lines from the
// other end. So the pictures stand one above the other, each for rows of its own, that nothing hides
// anything. Light that comes back to the print meets a black plane there.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <sstream>

#include "tests/support/mesh_rows.h"
#include "tests/support/render.h"
#include "tests/support/thick_places.h"

namespace lentray::test::thick_lens {
namespace {

/// A sheet across z, its middle at the origin. Scene units are mm.
struct GlassSheet {
  std::string name;
  double pitch, focal_length, ior, pixels;
  int rays;
  int columns, rows;
  double distance = 0.0;  ///< V, 0: infinite
  double eye_slope = 0.0;
  bool spills = false;  ///< light of some rays runs into the next lens
  /// Column and row of a pixel one of whose rays passes the edge of a lens so near that stock, which finds no
  /// surface within some 1e-5 mm of where a ray leaves another, shows it otherwise.
  std::optional<std::array<std::uint32_t, 2>> grazed{};

  double radius() const { return focal_length * (ior - 1.0) / ior; }
  double lenses() const { return columns / pixels; }
  double inverse_distance() const { return distance > 0.0 ? 1.0 / distance : 0.0; }
  double height() const { return 0.6 * rows; }
  double row_height(double row) const { return (0.5 - row / rows) * height(); }
};

std::string number(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}
std::string point(double x, double y, double z) {
  return "<" + number(x) + "," + number(y) + "," + number(z) + ">";
}

/// Where the pictures stand, before the sheet.
constexpr double kDepths[] = {3.0, 20.0, 60.0, 0.6};

/// Between the pictures' rows, mm. Rays of one row at two depths within the lens lie less apart.
constexpr double kGap = 0.04;

/// Fine stripes and waves, finer where they are near. Each for its share of the rows.
std::string pictures(const GlassSheet& sheet) {
  std::ostringstream out;
  const int count = static_cast<int>(std::size(kDepths));
  for (int i = 0; i < count; ++i) {
    const double depth = kDepths[i], shrunk = 1.0 - depth * sheet.inverse_distance();
    const double top = sheet.row_height(i * sheet.rows / count) * shrunk - 0.5 * kGap;
    const double bottom = sheet.row_height((i + 1) * sheet.rows / count) * shrunk + 0.5 * kGap;
    const double wave = 0.35 + 0.12 * depth;
    out << "polygon { 5, <-500," << number(bottom) << ">, <500," << number(bottom) << ">, <500,"
        << number(top) << ">, <-500," << number(top) << ">, <-500," << number(bottom)
        << "> translate " << number(-depth) << "*z\n  pigment { average pigment_map {"
        << " [1 function { 0.5 + 0.5*sin(x/" << number(wave)
        << ") } color_map { [0 rgb 0] [1 rgb <3,0,0>] }]"
        << " [1 function { 0.5 + 0.5*sin(x/" << number(3.1 * wave) << " + " << i
        << ") } color_map { [0 rgb 0] [1 rgb <0,3,0>] }]"
        << " [1 function { select(sin(x/" << number(5.0 * wave)
        << "), 0, 1) } color_map { [0 rgb 0] [1 rgb <0,0,3>] }]"
        << " } }\n  finish { ambient 0 diffuse 0 emission 1 } }\n";
  }
  return out.str();
}

std::string head() {
  return "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 0 }\n";
}

std::string our_scene(const GlassSheet& s) {
  std::ostringstream out;
  out << head() << pictures(s) << "camera { lenticular location 0 direction "
      << point(s.eye_slope, 0, 1) << " right " << number(s.lenses() * s.pitch) << "*x up "
      << number(s.height()) << "*y\n  lens_pitch " << number(s.pitch) << " lens_focal_length "
      << number(s.focal_length) << " lens_ior " << number(s.ior) << " lens_pixels "
      << number(s.pixels) << " lens_front 70 view_distance " << number(s.distance)
      << " lens_model thick lens_rays " << s.rays << " }\n";
  return out.str();
}

/// Cylinders upon a slab whose top lies in them. The print is black.
std::string glass(const GlassSheet& s) {
  std::ostringstream out;
  const double r = s.radius(), x = s.lenses() * s.pitch + 12.0 * s.pitch;
  const std::string tall = number(0.5 * s.height() + 10.0);
  out << "merge {\n  box { <" << number(-x) << ",-" << tall << "," << number(r) << ">, <"
      << number(x) << "," << tall << "," << number(s.focal_length + 1.0) << "> }\n";
  const int last = static_cast<int>(std::ceil(s.lenses())) + 5;
  for (int i = -5; i <= last; ++i) {
    const std::string axis = number((i + 0.5 - 0.5 * s.lenses()) * s.pitch);
    out << "  cylinder { <" << axis << ",-" << tall << "," << number(r) << ">, <" << axis << ","
        << tall << "," << number(r) << ">, " << number(r) << " }\n";
  }
  out << "  pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior " << number(s.ior)
      << " } }\nplane { z, " << number(s.focal_length + 0.02)
      << " pigment { rgb 0 } finish { ambient 0 diffuse 0 } }\n";
  return out.str();
}

/// How a ray climbs in the glass, for each mm of its way across the cylinders, so that outside it
/// rises by `rise` for each mm of depth: what the angle outside makes of it, until that is at rest.
double climb_of(const GlassSheet& s, double offset, double across, double rise) {
  if (rise == 0.0) return 0.0;
  const double r = s.radius(), depth = r - std::sqrt(r * r - across * across);
  const double incidence = std::atan2(across, r - depth) +  // of the normal, then of the ray
                           std::atan2(offset - across, s.focal_length - depth);
  double q = rise / std::hypot(1.0, rise);
  for (int i = 0; i < 200; ++i) {
    const double ior = std::sqrt((s.ior * s.ior - q * q) / (1.0 - q * q));
    const double sine = ior * std::sin(incidence);
    if (std::fabs(sine) >= 1.0) break;  // totally reflected: it is black, whatever its climb
    const double slope = std::tan(std::asin(sine) - std::atan2(across, r - depth));
    q = rise / std::sqrt(1.0 + slope * slope + rise * rise);
  }
  const double inside = q / s.ior;
  return inside / std::sqrt(1.0 - inside * inside);
}

/// The straight way from the print to that point of the surface stays in the glass.
bool stays_inside(const GlassSheet& s, double offset, double across) {
  const double r = s.radius(), half = 0.5 * s.pitch;
  if (std::fabs(offset) <= half) return true;
  const double depth = r - std::sqrt(r * r - across * across);
  const double edge = r - std::sqrt(r * r - half * half);
  const double part = (std::copysign(half, offset) - across) / (offset - across);
  return depth + part * (s.focal_length - depth) >= edge;
}

/// The face whose ray is that pixel's of that number: it starts there and goes to its place of the lens's
/// surface.
void add_face(const GlassSheet& s, int column, int row, int number, std::ostream& out) {
  const double inverse = s.inverse_distance();
  const double lens = std::floor((column + 0.5) / s.pixels);
  const double axis = (lens + 0.5 - 0.5 * s.lenses()) * s.pitch;
  const double print = s.pitch * (1.0 + s.focal_length * inverse / s.ior);
  // For an eye at a slant the print is shifted so that its middle view looks along the slope.
  const double sine = s.eye_slope / std::hypot(1.0, s.eye_slope) / s.ior;
  const double shift = s.focal_length * sine / std::sqrt(1.0 - sine * sine);
  const double offset = ((column + 0.5) / s.pixels - 0.5 * s.lenses()) * print - axis + shift;
  int view = 0;
  while (std::floor((column - view - 0.5) / s.pixels) == lens) ++view;
  const ThickPlace place = thick_place(static_cast<std::int64_t>(lens), row, view, number, s.rays);
  const double across = static_cast<double>(place.part - 0.5L) * s.pitch, r = s.radius();
  const double depth = r - std::sqrt(r * r - across * across);
  const double y = s.row_height(row + 0.5 + static_cast<double>(place.down)),
               climb = climb_of(s, offset, across, y * inverse);
  const double x = across - offset, z = depth - s.focal_length, way = std::hypot(x, z);
  double dx = x / way, dy = -climb, dz = z / way;  // light goes down where the line rises
  const double size = std::sqrt(1.0 + climb * climb);
  dx /= size, dy /= size, dz /= size;
  if (!stays_inside(s, offset, across)) dx = dy = 0.0, dz = 1.0;  // into the print
  // Perpendicular to the ray: u = y x d, w = d x u.
  double ux = dz, uz = -dx;
  const double flat = std::hypot(ux, uz);
  ux /= flat, uz /= flat;
  const double wx = dy * uz, wy = dz * ux - dx * uz, wz = -dy * ux;
  const double px = axis + offset, py = y + climb * way, pz = s.focal_length;
  const auto corner = [&](double u, double w) {
    return point(px + u * ux + w * wx, py + w * wy, pz + u * uz + w * wz);
  };
  out << "triangle { " << corner(1.0, -1.0 / 3.0) << ", " << corner(-1.0, -1.0 / 3.0) << ", "
      << corner(0.0, 2.0 / 3.0) << " }\n";
}

std::string stock_scene(const GlassSheet& s) {
  std::ostringstream out;
  out << head() << pictures(s) << glass(s) << "camera { mesh_camera { " << s.rays << " 0\n";
  for (int j = 0; j < s.rays; ++j) {
    out << "mesh {\n";
    for (int row = 0; row < s.rows; ++row) {
      for (int column = 0; column < s.columns; ++column) {
        add_face(s, column, row, j, out);
      }
    }
    out << "}\n";
  }
  out << "} }\n";
  return out.str();
}

SceneText text_of(const std::string& sdl, int width, int height) {
  SceneText scene;
  scene.sdl = sdl;
  scene.width = static_cast<std::uint32_t>(width);
  scene.height = static_cast<std::uint32_t>(height);
  return scene;
}

class ImageThickLens : public ::testing::TestWithParam<GlassSheet> {};

TEST_P(ImageThickLens, AsStockTracesTheGlass) {
  const GlassSheet& s = GetParam();
  const StoredImage ours = lentray_render(text_of(our_scene(s), s.columns, s.rows));
  StoredImage stock =
      without_first_row(stock_render(text_of(stock_scene(s), s.columns, s.rows + 1)));
  if (s.grazed) {
    const auto [column, row] = *s.grazed;
    EXPECT_NE(core::level(ours, column, row), core::level(stock, column, row)) << "it is as others";
    const std::size_t channels = static_cast<std::size_t>(stock.channels);
    const std::size_t at = (std::size_t{row} * stock.width + column) * channels;
    for (std::size_t i = 0; i < channels; ++i) stock.samples[at + i] = ours.samples[at + i];
  }
  EXPECT_TRUE(reaches(ours, stock, Grade::exact));
  // A picture without much in it proves nothing.
  std::set<std::array<double, 3>> colours;
  for (std::uint32_t row = 0; row < ours.height; ++row) {
    for (std::uint32_t column = 0; column < ours.width; ++column) {
      colours.insert(core::level(ours, column, row));
    }
  }
  EXPECT_GT(colours.size(), ours.width * ours.height / 5);
  const nlohmann::json lens = lentray_statistics(text_of(our_scene(s), s.columns, s.rows))["lens"];
  EXPECT_EQ(lens["rays"], s.rays);
  EXPECT_EQ(lens["spilled_rays"] > 0.0, s.spills);
  RecordProperty("colours", static_cast<int>(colours.size()));
  RecordProperty("comparison",
                 describe(core::compare(ours, stock, core::Columns::all(ours.width))));
}

INSTANTIATE_TEST_SUITE_P(
    Sheets, ImageThickLens,
    ::testing::Values(
        GlassSheet{"the_papers", 1.124, 3.03, 1.6, 15, 16, 120, 16},
        GlassSheet{"the_papers_near_eye", 1.124, 3.03, 1.6, 15, 9, 150, 16, 90.0},
        GlassSheet{"fractional", 0.9, 2.2, 1.5, 7.37, 8, 100, 16, 120.0},
        GlassSheet{"of_60_lpi", 25.4 / 60.0, 0.7, 1.57, 10, 16, 120, 16},
        // Many rays are totally reflected in these. Others run into the next lens and
        // into the print, in half circles also through it.
        GlassSheet{"wide", 2.28, 2.0, 2.5, 12, 33, 84, 16, 0.0, 0.0, true},
        GlassSheet{"at_a_slant", 2.2, 3.03, 1.6, 12, 33, 84, 16, 0.0, -1.0, true},
        GlassSheet{"half_circles", 0.923, 2.0, 1.3, 12, 129, 60, 8, 0.0, 0.55, true, {{47, 5}}}),
    [](const auto& sheet) { return sheet.param.name; });

/// The comparison sees a lens that is a hundredth thicker.
TEST(ImageThickLensProbe, SeesOtherLenses) {
  GlassSheet s{"", 1.124, 3.03, 1.6, 15, 4, 60, 8};
  const StoredImage ours = lentray_render(text_of(our_scene(s), s.columns, s.rows));
  s.focal_length *= 1.01;
  const StoredImage other = lentray_render(text_of(our_scene(s), s.columns, s.rows));
  EXPECT_FALSE(reaches(ours, other, Grade::exact));
}

/// Antialias_Angle=2 is the mean of two sheets whose prints are shifted by a quarter of a pixel to either
/// side, as those of slanted eyes are.
TEST(ImageThickLensProbe, AveragesDirectionsToo) {
  GlassSheet s{"", 1.124, 3.03, 1.6, 15, 4, 60, 8};
  const auto render = [&](std::vector<std::string> words) {
    words.emplace_back("File_Gamma=1");
    return lentray_render(text_of(our_scene(s), s.columns, s.rows), words);
  };
  const StoredImage mean = render({"Antialias_Angle=2"});
  const double inside = std::atan(0.25 * s.pitch / s.pixels / s.focal_length);
  const double slope = std::tan(std::asin(s.ior * std::sin(inside)));
  s.eye_slope = slope;
  const StoredImage one_side = render({});
  s.eye_slope = -slope;
  const StoredImage other_side = render({});
  double largest = 0.0;
  for (std::uint32_t row = 0; row < mean.height; ++row) {
    for (std::uint32_t column = 0; column < mean.width; ++column) {
      const auto one = core::level(mean, column, row);
      const auto left = core::level(one_side, column, row);
      const auto right = core::level(other_side, column, row);
      for (std::size_t i = 0; i < 3; ++i) {
        largest = std::max(largest, std::fabs(one[i] - 0.5 * (left[i] + right[i])));
      }
    }
  }
  EXPECT_LE(largest, 1.5);  // of 255: each is rounded
}

/// A picture's bits are its pixels' own: whoever renders which part of it, in which order.
TEST(ImageThickLensProbe, APixelsRaysAreItsOwn) {
  const tool::TemporaryFolder folder;
  const auto render = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{(source_folder() / "scenes/demo.pov").string(),
                                   "+FN16",
                                   "-V",
                                   "Lenticular=On",
                                   "Lens_Model=thick",
                                   "Lens_Rays=5",
                                   "Lens_Pixels=6",
                                   "+O" + (folder / "a.png").string()};
    words.insert(words.end(), more.begin(), more.end());
    const tool::RunResult done = run_lentray(words);
    EXPECT_EQ(done.status, 0) << done.output;
    return core::read_image(folder / "a.png");
  };
  for (const char* slant : {"Lens_Slant=0", "Lens_Slant=1/3"}) {
    const StoredImage whole = render({"+W60", "+H40", "+WT1", slant});
    EXPECT_TRUE(same_bits(whole, render({"+W60", "+H40", "+WT2", slant})));
    EXPECT_TRUE(same_bits(whole, render({"+W60", "+H40", "Pixel_Order=views", slant})));
    EXPECT_TRUE(same_bits(whole, render({"+W60", "+H40", "Band_Height=3", slant})));
    const StoredImage part = render({"+W60", "+H40", "+SR15", "+ER28", slant});
    for (std::uint32_t row = 14; row < 28; ++row) {
      for (std::uint32_t k = 0; k < 60; ++k) {
        for (std::uint32_t i = 0; i < 3; ++i) {
          ASSERT_EQ(part.at(k, row, i), whole.at(k, row, i)) << k << ' ' << row << ' ' << i;
        }
      }
    }
  }
  EXPECT_TRUE(same_bits(render({"+W60", "+H40", "View=2"}),
                        render({"+W60", "+H40", "Views=6", "View=2", "View_Size=10x40"})));
}

TEST(ImageThickLensProbe, SamplesBesideItsRaysAreCalledUseless) {
  const tool::TemporaryFolder folder;
  const auto says_it = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{(source_folder() / "scenes/demo.pov").string(),
                                   "-V",
                                   "+W30",
                                   "+H20",
                                   "Lenticular=On",
                                   "Lens_Pixels=6",
                                   "+O" + (folder / "a.png").string()};
    words.insert(words.end(), more.begin(), more.end());
    const tool::RunResult done = run_lentray(words);
    EXPECT_EQ(done.status, 0) << done.output;
    return done.output.find(
               "+A gains nothing with Lens_Model=thick, for the rays of a pixel are "
               "spread over its area already: leave +A out, or raise Lens_Rays") !=
           std::string::npos;
  };
  for (const char* method : {"+AM1", "+AM2", "+AM3"}) {
    EXPECT_TRUE(says_it({"Lens_Model=thick", "+A0.3", method})) << method;
    EXPECT_FALSE(says_it({"Lens_Model=thick", method})) << method;
    EXPECT_FALSE(says_it({"Lens_Model=pinhole", "+A0.3", method})) << method;
  }
  EXPECT_TRUE(says_it({"Lens_Model=thick", "+A0.3", "View=2"}));
  EXPECT_FALSE(says_it({"Lens_Model=thick", "+A0.3", "Lens_Rays=1"}));
  // Pixels of other pictures may be wider than a lens.
  EXPECT_FALSE(says_it({"Lens_Model=thick", "+A0.3", "Views=2", "View=1"}));
}

/// A view is its columns of the sheet.
TEST(ImageThickLensProbe, AViewIsAPartOfTheSheet) {
  const GlassSheet s{"", 1.124, 3.03, 1.6, 15, 4, 60, 8};
  const StoredImage sheet = lentray_render(text_of(our_scene(s), s.columns, s.rows));
  const StoredImage view = lentray_render(text_of(our_scene(s), s.columns, s.rows), {"View=4"});
  ASSERT_EQ(view.width, 4u);
  for (std::uint32_t row = 0; row < view.height; ++row) {
    for (std::uint32_t lens = 0; lens < 4; ++lens) {
      EXPECT_EQ(core::level(view, lens, row), core::level(sheet, 15 * lens + 4, row));
    }
  }
}

TEST(ErrorThickLens, HasNoReferenceInLentrayDiff) {
  const std::string scene = (source_folder() / "scenes/demo.pov").string();
  const tool::RunResult result =
      run_diff({scene, "Lenticular=On", "Lens_Model=thick", "+W30", "+H20"});
  EXPECT_NE(result.status, 0);
  EXPECT_NE(result.output.find("there is no reference for the lens model thick: there are ones for "
                               "paraxial and pinhole"),
            std::string::npos)
      << result.output;
}

}  // namespace
}  // namespace lentray::test::thick_lens
