// Slanted lens sheets against stock. The rays of the models paraxial and pinhole, worked out in
// tests/support/slanted_reference.h, are those of a mesh_camera in stock. Those of thick start at the
// print in stock too, inside a sheet of glass whose cylinders are slanted, and stock refracts them.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "tests/image/slanted_scenes.h"
#include "tests/support/mesh_rows.h"

namespace lentray::test::slanted {
namespace {

/// Cylinders upon a slab whose top lies in them, turned. The print is black.
std::string slanted_glass(const SlantReference& s) {
  std::ostringstream out;
  const std::string tall = number(s.width() + s.height()), r = number(s.radius());
  out << "merge {\n  box { <-" << tall << ",-" << tall << "," << r << ">, <" << tall << "," << tall
      << "," << number(s.focal_length + 1.0) << "> }\n";
  const SlantReal lenses = s.columns / static_cast<SlantReal>(s.pixels);
  const int many = static_cast<int>((s.width() + s.height()) / s.pitch);
  for (int i = -many; i <= many; ++i) {
    const SlantReal middle = (i + 0.5L - 0.5L * lenses + std::floor(0.5L * lenses)) * s.pitch;
    out << "  cylinder { <" << number(middle) << ",-" << tall << "," << r << ">, <"
        << number(middle) << "," << tall << "," << r << ">, " << r << " }\n";
  }
  out << "  rotate " << number(-s.slant)
      << "*z pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior " << number(s.ior)
      << " } }\nplane { z, " << number(s.focal_length + 0.02)
      << " pigment { rgb 0 } finish { ambient 0 diffuse 0 } }\n";
  return out.str();
}

/// A face of a mesh_camera: its ray starts in its middle and is perpendicular to it.
void add_face(const SlantVector& from, const SlantVector& along, std::ostream& out) {
  const SlantReal size = std::hypot(along[0], along[1], along[2]);
  const SlantVector d{along[0] / size, along[1] / size, along[2] / size};
  const SlantReal flat = std::hypot(d[2], d[0]);
  const SlantVector u{d[2] / flat, 0.0L, -d[0] / flat};
  const SlantVector w{d[1] * u[2], d[2] * u[0] - d[0] * u[2], -d[1] * u[0]};
  const auto corner = [&](SlantReal a, SlantReal b) {
    return point({from[0] + a * u[0] + b * w[0], from[1] + a * u[1] + b * w[1],
                  from[2] + a * u[2] + b * w[2]});
  };
  out << "triangle { " << corner(1, -1.0L / 3) << ", " << corner(-1, -1.0L / 3) << ", "
      << corner(0, 2.0L / 3) << " }\n";
}

std::string stock_scene(const SlantReference& s) {
  std::ostringstream out;
  const bool thick = s.model == Model::kThick;
  out << world_of(s) << (thick ? slanted_glass(s) : std::string()) << "camera { mesh_camera { "
      << s.rays << " 0\n";
  for (int j = 0; j < s.rays; ++j) {
    out << "mesh {\n";
    for (int row = 0; row < s.rows; ++row) {
      for (int column = 0; column < s.columns; ++column) {
        const auto ray = slant_ray(s, column, row, j);
        SlantVector from{0, 0, s.focal_length}, along{0, 0, 1};  // into the print
        if (ray && thick) {
          from = ray->in_print;
          for (int i = 0; i < 3; ++i) along[i] = ray->leaves[i] - from[i];
        } else if (ray) {
          along = ray->slope;
          for (int i = 0; i < 3; ++i) from[i] = ray->leaves[i] - kFront * along[i];
        }
        add_face(from, along, out);
      }
    }
    out << "}\n";
  }
  out << "} }\n";
  return out.str();
}

struct SlantedCase {
  std::string name;
  SlantReference sheet;
  friend void PrintTo(const SlantedCase& c, std::ostream* out) { *out << c.name; }
};

class ImageSlantedSheets : public ::testing::TestWithParam<SlantedCase> {};

TEST_P(ImageSlantedSheets, AsStockTracesItsRays) {
  const SlantReference& s = GetParam().sheet;
  const StoredImage ours = lentray_render(text_of(sheet_scene(s), s.columns, s.rows));
  const StoredImage stock =
      without_first_row(stock_render(text_of(stock_scene(s), s.columns, s.rows + 1)));
  EXPECT_TRUE(reaches(ours, stock, Grade::match));
  // A picture without much in it proves nothing.
  std::set<std::array<double, 3>> colours;
  for (std::uint32_t row = 0; row < ours.height; ++row) {
    for (std::uint32_t column = 0; column < ours.width; ++column) {
      colours.insert(core::level(ours, column, row));
    }
  }
  EXPECT_GT(colours.size(), ours.width * ours.height / 20);
  RecordProperty("comparison",
                 describe(core::compare(ours, stock, core::Columns::all(ours.width))));
  // Other slants are seen.
  SlantReference other = s;
  other.slant += 0.25;
  EXPECT_FALSE(
      reaches(lentray_render(text_of(sheet_scene(other), s.columns, s.rows)), stock, Grade::match));
}

const double kThird = std::atan(1.0 / 3.0) * 180.0 / std::numbers::pi;

INSTANTIATE_TEST_SUITE_P(
    Sheets, ImageSlantedSheets,
    ::testing::Values(
        SlantedCase{"paraxial", {.model = Model::kParaxial, .slant = kThird, .distance = 300.0}},
        SlantedCase{"paraxial_fractional",
                    {.model = Model::kParaxial,
                     .slant = -9.46,
                     .pixels = 7.37,
                     .distance = 150.0,
                     .row_by_column = 1.5,
                     .eye_slope_x = 0.1,
                     .eye_slope_y = -0.05}},
        SlantedCase{"paraxial_infinite", {.model = Model::kParaxial, .slant = 33.0, .pixels = 8.2}},
        SlantedCase{"pinhole", {.model = Model::kPinhole, .slant = kThird}},
        SlantedCase{"pinhole_fractional",
                    {.model = Model::kPinhole,
                     .slant = -25.0,
                     .pixels = 6.283,
                     .distance = 200.0,
                     .eye_slope_x = -0.1,
                     .eye_slope_y = -0.1}},
        SlantedCase{"thick", {.model = Model::kThick, .slant = kThird, .rows = 24, .rays = 5}},
        SlantedCase{"thick_fractional",
                    {.model = Model::kThick,
                     .slant = -20.0,
                     .pixels = 7.37,
                     .distance = 200.0,
                     .rows = 24,
                     .row_by_column = 0.5,
                     .eye_slope_x = 0.1,
                     .rays = 4}}),
    [](const auto& sheet) { return sheet.param.name; });

}  // namespace
}  // namespace lentray::test::slanted
