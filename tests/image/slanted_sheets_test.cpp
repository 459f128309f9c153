// Slanted lens sheets against stock. The rays of the models paraxial and pinhole, worked out in
// tests/support/slanted_reference.h, are those of a mesh_camera in stock. Those of thick start at the
// print in stock too, inside a sheet of glass whose cylinders are slanted, and stock refracts them.
// Views are taken out of sheets by a few lines of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>

#include "tests/support/mesh_rows.h"
#include "tests/support/render.h"
#include "tests/support/slanted_reference.h"

namespace lentray::test::slanted {
namespace {

using Model = SlantReference::Model;

std::string number(SlantReal value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", static_cast<double>(value));
  return buffer;
}
std::string point(const SlantVector& v) {
  return "<" + number(v[0]) + "," + number(v[1]) + "," + number(v[2]) + ">";
}

std::string head() {
  return "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 0 }\n";
}

/// Solids before and behind the sheet; units are mm.
constexpr const char* kThings = R"(background { rgb <.2,.3,.5> }
light_source { <20,40,-60> rgb 1 }
plane { y, -4.1 pigment { checker rgb <.9,.8,.6> rgb <.3,.4,.2> translate <.137,0,.291> } }
sphere { <-1.1,.3,6>, 2.6 pigment { rgb <.8,.2,.1> } finish { phong .5 reflection .2 } }
box { <2.013,-2.47,-1.02>, <3.97,2.03,.84>
  pigment { gradient x color_map { [0 rgb 1] [1 rgb z] } scale .317 } }
cylinder { <-4,-3,-3>, <-3,3,2>, .5 pigment { rgb <.2,.6,.3> } }
)";

/// Stripes that stand one above the other before the sheet, each for its share of the rows.
std::string stripes(const SlantReference& s) {
  constexpr double kDepths[] = {3.0, 20.0, 60.0, 0.6};
  std::ostringstream out;
  for (int i = 0; i < 4; ++i) {
    const SlantReal depth = kDepths[i], shrunk = 1.0L - depth * s.inverse();
    const SlantReal top = (0.5L - i / 4.0L) * s.height() * shrunk;
    const SlantReal bottom = (0.25L - i / 4.0L) * s.height() * shrunk;
    const SlantReal wave = 0.35L + 0.12L * depth;
    out << "box { <-500," << number(bottom) << ",0>, <500," << number(top) << ",.001> translate "
        << number(-depth) << "*z\n  pigment { average pigment_map {"
        << " [1 function { 0.5 + 0.5*sin(x/" << number(wave)
        << ") } color_map { [0 rgb 0] [1 rgb <3,0,0>] }]"
        << " [1 function { 0.5 + 0.5*sin(x/" << number(3.1L * wave) << " + " << i
        << ") } color_map { [0 rgb 0] [1 rgb <0,3,0>] }]"
        << " [1 function { select(sin(x/" << number(5.0L * wave)
        << "), 0, 1) } color_map { [0 rgb 0] [1 rgb <0,0,3>] }]"
        << " } }\n  finish { ambient 0 diffuse 0 emission 1 } }\n";
  }
  return out.str();
}

constexpr double kFront = 70.0;

std::string world_of(const SlantReference& s) {
  return head() + (s.model == Model::kThick ? stripes(s) : std::string(kThings));
}

std::string sheet_scene(const SlantReference& s) {
  std::ostringstream out;
  const char* const models[] = {"paraxial", "pinhole", "thick"};
  out << world_of(s) << "camera { lenticular location 0 direction "
      << point({s.eye_slope_x, s.eye_slope_y, 1}) << " right " << number(s.width()) << "*x up "
      << number(s.height()) << "*y\n  lens_pitch " << number(s.pitch) << " lens_focal_length "
      << number(s.focal_length) << " lens_ior " << number(s.ior) << " lens_pixels "
      << number(s.pixels) << " lens_front " << number(kFront) << " view_distance "
      << number(s.distance) << " lens_slant " << number(s.slant) << " lens_model "
      << models[static_cast<int>(s.model)];
  if (s.model == Model::kThick) out << " lens_rays " << s.rays;
  out << " }\n";
  return out.str();
}

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
        const auto ray = slant_ray(s, column, row, (j + 0.5L) / s.rays);
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

SceneText text_of(const std::string& sdl, int width, int height) {
  SceneText scene;
  scene.sdl = sdl;
  scene.width = static_cast<std::uint32_t>(width);
  scene.height = static_cast<std::uint32_t>(height);
  return scene;
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
                     .eye_slope_y = 0.1}},
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

/// The pixel of view j of `views` at place i of a row, by counting: of the lens whose axis is nearest
/// to the place, the pixel whose middle is nearest to the view's offset.
int column_of_view(const SlantReference& s, int view, int views, int place, int row) {
  const double tangent = std::tan(static_cast<double>(s.angle()));
  const double up = (0.5 * s.rows - row - 0.5) * s.row_by_column * tangent;  // columns
  const double lens = std::round(place - up / s.pixels);
  double least = 1e9;
  int nearest = -1;
  for (int k = 0; k < s.columns; ++k) {
    const double at = (k + 0.5 - up) / s.pixels - lens - (view + 0.5) / views;
    if (std::fabs(at) < least) least = std::fabs(at), nearest = k;
  }
  return nearest;
}

class ImageSlantedViews : public ::testing::Test {
 protected:
  void SetUp() override {
    tool::write_text(m_folder / "scene.pov", sheet_scene(m_sheet));
    render("sheet.png", {});
  }
  tool::RunResult render(const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments{"+Iscene.pov", "+O" + name, "-V",
                                       "+W" + std::to_string(m_sheet.columns),
                                       "+H" + std::to_string(m_sheet.rows)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const tool::RunResult result = run_lentray(arguments, m_folder.path());
    EXPECT_EQ(result.status, 0) << result.output;
    return result;
  }
  tool::RunResult run(const std::string& tool, const std::vector<std::string>& arguments) {
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), program(tool).string());
    return tool::run_program(words, m_folder.path());
  }
  StoredImage picture(const std::string& name) { return core::read_image(m_folder / name); }

  /// tan a = 0.3 and N = 7.37: no place hangs between two pixels.
  SlantReference m_sheet{.model = Model::kParaxial,
                         .slant = 16.69924423399362,
                         .pixels = 7.37,
                         .distance = 300.0,
                         .columns = 118,
                         .rows = 60};
  tool::TemporaryFolder m_folder;
};
using ErrorSlantedViews = ImageSlantedViews;

TEST_F(ImageSlantedViews, TakenOutTheyAreTheRenderedOnes) {
  const StoredImage sheet = picture("sheet.png");
  for (const int view : {0, 3, 6}) {
    const std::string j = std::to_string(view);
    render("view.png", {"View=" + j});
    const auto result = run("lentray-views", {"sheet.png", "--view", j, "--out", "taken.png"});
    ASSERT_EQ(result.status, 0) << result.output;
    const StoredImage rendered = picture("view.png"), taken = picture("taken.png");
    ASSERT_EQ(rendered.width, 16u);
    EXPECT_TRUE(reaches(taken, rendered, Grade::exact));
    for (int row = 0; row < m_sheet.rows; ++row) {
      for (int i = 1; i < 15; ++i) {
        const int k = column_of_view(m_sheet, view, 7, i, row);
        EXPECT_EQ(
            core::level(taken, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(row)),
            core::level(sheet, static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(row)))
            << view << ' ' << i << ' ' << row;
      }
    }
  }
}

/// A view in any size is what stock's own camera sees from the view's eye.
TEST_F(ImageSlantedViews, PicturesOfViewsAreStocks) {
  for (const int view : {0, 2}) {
    const StoredImage ours = lentray_render(text_of(sheet_scene(m_sheet), 80, 45),
                                            {"Views=4", "View=" + std::to_string(view)});
    const SlantReal e =
        ((view + 0.5L) / 4 - 0.5L) * m_sheet.print_pitch() / std::cos(m_sheet.angle());
    const SlantReal aside = m_sheet.ior * e / m_sheet.focal_length;
    const SlantReal v = m_sheet.distance;
    std::ostringstream stock;
    // Rays of the sheet begin kFront before it; from the eye nothing stands in their way.
    stock << world_of(m_sheet) << "camera { location " << point({-v * aside, 0, -v})
          << " direction " << point({v * aside, 0, v}) << " right " << number(m_sheet.width())
          << "*x up " << number(m_sheet.height()) << "*y }\n";
    EXPECT_TRUE(reaches(ours, stock_render(text_of(stock.str(), 80, 45)), Grade::match));
  }
}

/// The eye of a view sees it through the sheet.
TEST_F(ImageSlantedViews, TheEyeOfAViewSeesIt) {
  const int view = 3;
  const double e = ((view + 0.5) / 7 - 0.5) * static_cast<double>(m_sheet.print_pitch()) /
                   std::cos(static_cast<double>(m_sheet.angle()));
  const double angle =
      -std::atan(m_sheet.ior * e / m_sheet.focal_length) * 180.0 / std::numbers::pi;
  const auto seen =
      run("lentray-views", {"sheet.png", "--eye", number(angle) + ",300", "--out", "eye.png"});
  ASSERT_EQ(seen.status, 0) << seen.output;
  run("lentray-views", {"sheet.png", "--view", "3", "--out", "view.png"});
  EXPECT_TRUE(reaches(picture("eye.png"), picture("view.png"), Grade::exact));
}

TEST_F(ImageSlantedViews, AreSaidInTheFile) {
  const std::string said = run("lentray-views", {"sheet.png"}).output;
  EXPECT_NE(said.find("slanted by 16.7 degrees"), std::string::npos) << said;
  const std::string report = render("again.png", {"Lens_Slant=-1/6"}).output;
  EXPECT_NE(report.find("slanted by -9.462 degrees, a tangent of -0.1667: their tops lean to the "
                        "left"),
            std::string::npos)
      << report;
}

TEST_F(ErrorSlantedViews, EveryMessage) {
  const auto expect = [&](const tool::RunResult& result, const char* message) {
    EXPECT_NE(result.status, 0) << message;
    EXPECT_NE(result.output.find(message), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find("nan"), std::string::npos) << result.output;
  };
  expect(run("lentray-views", {"sheet.png", "--lens", "3"}),
         "'sheet.png' is for lenses slanted by 16.7 degrees: no columns lie behind one of them");
  expect(run("lentray-views",
             {"sheet.png", "sheet.png", "--interlace", "--like", "sheet.png", "--out", "a.png"}),
         "'sheet.png' is for lenses slanted by 16.7 degrees: pictures are interlaced for upright");
  expect(run("lentray-views", {"sheet.png", "--view", "7"}), "there is no view 7");
  for (const char* bad : {"steep", "90", "1/0", "1e300"}) {
    expect(run("lentray-views", {"sheet.png", "--lens-slant", bad, "--view", "0"}),
           "an angle of -80 to 80 degrees (9.46) or its tangent as a fraction (1/6) is expected");
  }
  expect(run("lentray-print", {"sheet.png", "--out", "page.pdf"}),
         "'sheet.png' is for lenses slanted by 16.6992 degrees; pages are for upright ones");
  expect(run_diff({(m_folder / "scene.pov").string(), "+W30", "+H20"}),
         "there is no reference for slanted lenses (Lens_Slant)");
}

}  // namespace
}  // namespace lentray::test::slanted
