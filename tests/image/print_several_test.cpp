// lentray-print's sheets of measured pitches and of several pictures: lines that stand in the middle of every lens are
// found again in what it writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "core/image/writer.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// White with a black line `line` columns wide in the middle of each lens, drawn by the share of each pixel; rows from
/// `marked` on are black.
StoredImage lens_lines(std::uint32_t width, std::uint32_t height, double pixels, double line,
                       std::uint32_t marked) {
  StoredImage image;
  image.width = width;
  image.height = height;
  image.channels = 1;
  image.bits = 16;
  auto& samples = image.samples.store<std::uint16_t>(0);
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t k = 0; k < width; ++k) {
      double black = row >= marked ? 1.0 : 0.0;
      for (double lens = std::floor(k / pixels) - 1.0; lens <= std::floor(k / pixels) + 1.0;
           ++lens) {
        const double middle = (lens + 0.5) * pixels;
        black += std::clamp(
            std::min(k + 1.0, middle + line / 2.0) - std::max(1.0 * k, middle - line / 2.0), 0.0,
            1.0);
      }
      samples.push_back(
          static_cast<std::uint16_t>(std::lround(65535.0 * (1.0 - std::min(1.0, black)))));
    }
  }
  return image;
}

/// Where the lines of a row lie from one column to before another: runs that are not white, by their darkness.
std::vector<double> lines_in(const StoredImage& image, std::uint32_t row, std::uint32_t first,
                             std::uint32_t end) {
  const double most = static_cast<double>((1u << image.bits) - 1u);
  std::vector<double> out;
  double sum = 0.0, moment = 0.0;
  for (std::uint32_t k = first; k <= end; ++k) {
    const double dark = k < end ? 1.0 - image.at(k, row, 0) / most : 0.0;
    if (dark > 1e-3) {
      sum += dark;
      moment += dark * (k + 0.5);
    } else if (sum > 0.0) {
      out.push_back(moment / sum);
      sum = moment = 0.0;
    }
  }
  return out;
}

class ImagePrintSeveral : public ::testing::Test {
 protected:
  tool::RunResult run(std::vector<std::string> words) const {
    words.insert(words.begin(), program("lentray-print").string());
    return tool::run_program(words, m_folder.path(), 200);
  }
  std::string print(const std::vector<std::string>& words) const {
    const auto result = run(words);
    EXPECT_EQ(result.status, 0) << result.output;
    return result.output;
  }
  StoredImage read(const std::string& name) const { return core::read_image(m_folder / name); }
  /// The file's page as pixels: of a PDF as poppler draws it.
  StoredImage page(const std::string& name, int dpi) const {
    if (!name.ends_with(".pdf")) return read(name);
    const auto drawn =
        tool::run_program({"pdftoppm", "-r", std::to_string(dpi), "-singlefile", "-gray",
                           (m_folder / name).string(), (m_folder / "drawn").string()});
    EXPECT_EQ(drawn.status, 0) << drawn.output;
    return read("drawn.pgm");
  }
  void write(const std::string& name, const StoredImage& image) const {
    core::write_stored(image, m_folder / name);
  }

  const tool::TemporaryFolder m_folder;
};

/// Least squares: place = a + b i.
std::pair<double, double> straight_line(const std::vector<double>& places) {
  const auto n = static_cast<double>(places.size());
  double sum = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sum += places[i];
    moment += (static_cast<double>(i) - (n - 1.0) / 2.0) * places[i];
  }
  const double slope = moment / (n * (n * n - 1.0) / 12.0);
  return {sum / n - slope * (n - 1.0) / 2.0, slope};
}

/// 100 lenses need 1197.0075 columns, and so on: none of them is lost, and their lines lie where the pitch has them.
TEST_F(ImagePrintSeveral, AHundredLensesOfAMeasuredPitch) {
  write("c.png", lens_lines(1200, 40, 12.0, 2.0, 40));
  for (const double lpi : {60.14, 60.15, 60.16, 59.95, 59.85}) {
    for (const char* kind : {"png", "tif", "pdf"}) {
      const std::string name = std::string("o.") + kind;
      const std::string report =
          print({"sheet", "c.png", "--dpi", "720", "--pixels", "12", "--pitch",
                 std::to_string(lpi) + "lpi", "--marks", "none", "--margin", "0mm", "--out", name});
      EXPECT_NE(report.find(" pixels, 100 lenses of "), std::string::npos) << report;
      const StoredImage image = page(name, 720);
      const std::vector<double> lines = lines_in(image, 20, 0, image.width);
      ASSERT_EQ(lines.size(), 100u) << name << " " << lpi;
      const auto [first, pitch] = straight_line(lines);
      EXPECT_NEAR(pitch / (720.0 / lpi), 1.0, 2e-5) << name << " " << lpi;
      // Poppler draws grey of 8 bits.
      const double allowed = std::string(kind) == "pdf" ? 0.02 : 0.01;
      for (std::size_t i = 0; i < lines.size(); ++i)
        EXPECT_NEAR(lines[i], first + pitch * static_cast<double>(i), allowed) << i;
      // The middle has kept its place behind the lenses: half way between the lines of lenses 49 and 50.
      const double middle = (lines[49] + lines[50]) / 2.0;
      EXPECT_NEAR(middle, std::round(middle), 0.01);
      EXPECT_NEAR(middle, image.width / 2.0, 0.51);
    }
  }
}

/// A sheet that was made for 40.15 lpi at 720 dpi.
TEST_F(ImagePrintSeveral, AHundredLensesAsTheyAre) {
  const double pixels = 720.0 / 40.15;
  write("e.png", lens_lines(1793, 40, pixels, 3.0, 40));
  const std::string report = print({"sheet", "e.png", "--dpi", "720", "--lpi", "40.15", "--marks",
                                    "none", "--margin", "0mm", "--out", "o.tif"});
  EXPECT_NE(report.find("picture: 1793 x 40 pixels, 100 lenses of "), std::string::npos) << report;
  EXPECT_EQ(report.find("left out"), std::string::npos) << report;
  EXPECT_EQ(lines_in(read("o.tif"), 20, 0, 1793).size(), 100u);
}

/// What the middle of the picture shows is not mixed, and what is mixed is so symmetrically.
TEST_F(ImagePrintSeveral, APitchIsFittedFromTheMiddle) {
  StoredImage ramp;
  ramp.width = 1212;  // 101 lenses
  ramp.height = 4;
  ramp.channels = 1;
  ramp.bits = 16;
  auto& samples = ramp.samples.store<std::uint16_t>(0);
  for (std::uint32_t k = 0; k < 4 * ramp.width; ++k)
    samples.push_back(static_cast<std::uint16_t>(5000 * (k % 12)));
  write("r.png", ramp);
  print({"sheet", "r.png", "--dpi", "720", "--pixels", "12", "--pitch", "60.15lpi", "--marks",
         "none", "--margin", "0mm", "--out", "o.tif"});
  const StoredImage image = read("o.tif");
  // The middle lens's 12 columns: nearly the whole numbers that they were, the more so the nearer to the middle.
  std::vector<std::uint32_t> exact;
  for (std::uint32_t k = 0; k < image.width; ++k) {
    const double view = image.at(k, 1, 0) / 5000.0;
    if (std::fabs(view - std::round(view)) < 0.002) exact.push_back(k);
  }
  ASSERT_FALSE(exact.empty());
  const double middle = image.width / 2.0;
  const auto nearest = *std::ranges::min_element(
      exact, {}, [&](std::uint32_t k) { return std::fabs(k + 0.5 - middle); });
  EXPECT_LT(std::fabs(nearest + 0.5 - middle), 2.0);
}

/// Rows and columns, and where each picture is, as the report has them.
struct PrintPlace {
  std::string name;
  double width, height, left, top;
};
std::vector<PrintPlace> places_told(const std::string& report) {
  const std::regex line(
      R"(row \d+ column \d+: (\S+), ([0-9.]+) x ([0-9.]+) mm at ([0-9.]+), ([0-9.]+) mm)");
  std::vector<PrintPlace> out;
  for (std::sregex_iterator at(report.begin(), report.end(), line), end; at != end; ++at) {
    out.push_back({(*at)[1], std::stod((*at)[2]), std::stod((*at)[3]), std::stod((*at)[4]),
                   std::stod((*at)[5])});
  }
  return out;
}

/// Each picture's lens middles are a whole number of lenses from each other, whatever N.
TEST_F(ImagePrintSeveral, LensesOfAllPicturesAreInPhase) {
  for (const double pixels : {12.0, 12.37, 12.5, 15.1839}) {
    const auto width = static_cast<std::uint32_t>(std::lround(40.0 * pixels));
    const auto narrow = static_cast<std::uint32_t>(std::lround(23.0 * pixels));
    write("a.png", lens_lines(width, 300, pixels, 3.0, 200));
    write("b.png", lens_lines(narrow, 260, pixels, 3.0, 100));
    for (const char* kind : {"tif", "pdf"}) {
      const std::string name = std::string("o.") + kind;
      const std::string report =
          print({"sheet", "a.png", "b.png", "--copies", "3x2", "--dpi", "600", "--pixels",
                 std::to_string(pixels), "--gap", "4mm", "--bleed", "1mm", "--out", name});
      const std::vector<PrintPlace> told = places_told(report);
      ASSERT_EQ(told.size(), 6u) << report;
      const StoredImage image = page(name, 600);
      const double mm = 600.0 / 25.4;
      double origin = -1.0;
      for (std::size_t i = 0; i < told.size(); ++i) {
        const PrintPlace& place = told[i];
        EXPECT_EQ(place.name, i % 2 == 0 ? "a.png" : "b.png");
        const auto left = static_cast<std::uint32_t>(std::lround(place.left * mm));
        const auto right = static_cast<std::uint32_t>(std::lround((place.left + place.width) * mm));
        const auto top = static_cast<std::uint32_t>(std::lround(place.top * mm));
        const std::vector<double> lines = lines_in(image, top + 50, left, right);
        ASSERT_EQ(lines.size(), i % 2 == 0 ? 40u : 23u) << report;
        if (origin < 0.0) origin = lines[0];
        for (const double line : lines) {
          const double lenses = (line - origin) / pixels;
          EXPECT_NEAR((lenses - std::round(lenses)) * pixels, 0.0,
                      std::string(kind) == "pdf" ? 0.03 : 0.01)
              << name << " N " << pixels << " picture " << i;
        }
        // The right picture: black from its marked row on.
        const std::uint32_t marked = top + (i % 2 == 0 ? 200 : 100);
        EXPECT_GT(image.at(left + 1, marked - 2, 0),
                  0.9f * static_cast<float>((1u << image.bits) - 1u));
        EXPECT_EQ(image.at(left + 1, marked + 2, 0), 0.0f);
      }
    }
  }
}

/// Whole N: bit for bit. Tiles show the same.
TEST_F(ImagePrintSeveral, PicturesOfWholePixelsAreAsTheyWere) {
  const StoredImage one = lens_lines(360, 200, 12.0, 3.0, 150);
  write("a.png", one);
  const std::string report = print({"sheet", "a.png", "--copies", "4", "--dpi", "600", "--pixels",
                                    "12", "--out", "o.tif", "--margin", "1mm"});
  EXPECT_EQ(report.find("mean of two"), std::string::npos) << report;
  const StoredImage image = read("o.tif");
  const std::vector<PrintPlace> told = places_told(report);
  ASSERT_EQ(told.size(), 4u) << report;
  std::size_t differing = 0;
  for (const PrintPlace& place : told) {
    const auto left = static_cast<std::uint32_t>(std::lround(place.left / 25.4 * 600.0));
    const auto top = static_cast<std::uint32_t>(std::lround(place.top / 25.4 * 600.0));
    for (std::uint32_t y = 0; y < one.height; ++y) {
      for (std::uint32_t x = 0; x < one.width; ++x)
        if (image.at(left + x, top + y, 0) != one.at(x, y, 0)) ++differing;
    }
  }
  EXPECT_EQ(differing, 0u);
  const std::string tiled =
      print({"sheet", "a.png", "--copies", "4", "--dpi", "600", "--pixels", "12", "--paper",
             "50x45mm", "--tiles", "--overlap", "5mm", "--out", "t.tif"});
  EXPECT_NE(tiled.find("row 1 column 2 of "), std::string::npos) << tiled;
}

/// Near eyes: strips are wider apart than lenses, and pictures that are cut apart stand at whole lenses of the sheet.
TEST_F(ImagePrintSeveral, PicturesForANearEyeAreEachCentred) {
  tool::write_text(
      m_folder / "a.pov",
      "#version 3.7;\ncamera { location -5*z look_at 0 right x*2 }\nbackground { rgb 1 }\n");
  const auto rendered = run_lentray(
      {"+Ia.pov", "-V", "+W600", "+H120", "Lenticular=On", "Lens_LPI=40", "Lens_Pixels=15",
       "View_Distance=300", "Lens_Focal_Length=1.8", "Lens_IOR=1.5", "+Os.png"},
      m_folder.path());
  ASSERT_EQ(rendered.status, 0) << rendered.output;
  const double growth = 1.0 + 1.8 / (1.5 * 300.0);
  const double pixel = 0.635 * growth / 15.0;
  for (const bool together : {false, true}) {
    const std::string report = print({"sheet", "s.png", "--copies", "3x1", "--seen",
                                      together ? "together" : "apart", "--out", "o.tif"});
    const std::vector<PrintPlace> told = places_told(report);
    ASSERT_EQ(told.size(), 3u) << report;
    const double pitch = together ? 0.635 * growth : 0.635;
    for (const std::size_t i : {1u, 2u}) {
      const double lenses = (told[i].left - told[0].left) / pitch;
      // Within half a pixel, for the place of a picture is told in whole ones.
      EXPECT_NEAR(lenses, std::round(lenses), 0.51 * pixel / pitch + 0.002) << report;
    }
    EXPECT_EQ(report.find("mean of two") == std::string::npos, together) << report;
  }
}

TEST_F(ImagePrintSeveral, WhatDoesNotGoTogether) {
  write("a.png", lens_lines(120, 60, 12.0, 3.0, 60));
  write("b.png", lens_lines(240, 60, 12.0, 3.0, 60));
  const std::vector<std::string> words{"sheet", "a.png", "b.png", "--dpi", "600", "--pixels", "12"};
  const auto fails = [&](std::vector<std::string> more, const std::string& why) {
    more.insert(more.begin(), words.begin(), words.end());
    more.insert(more.end(), {"--out", "o.pdf"});
    const auto result = run(more);
    EXPECT_EQ(result.status, 1) << result.output;
    EXPECT_NE(result.output.find(why), std::string::npos) << result.output;
    EXPECT_FALSE(std::filesystem::exists(m_folder / "o.pdf"));
  };
  fails({"--grid", "1x1"}, "a grid of 1 x 1 has no room for 2 pictures");
  fails({"--copies", "1x1"}, "a grid of 1 x 1 has no room for 2 pictures");
  fails({"--bleed", "3mm", "--gap", "5mm"}, "give --gap 6mm or more");
  fails({"--copies", "60", "--paper", "A6"}, " of 120 pictures with their gaps and marks; --tiles");
  tool::write_text(m_folder / "a.pov",
                   "#version 3.7;\ncamera { location -5*z look_at 0 }\nbackground { rgb 1 }\n");
  const auto render = [&](const std::string& pixels, const std::string& name,
                          const std::string& more) {
    const auto result =
        run_lentray({"+Ia.pov", "-V", "+W120", "+H60", "Lenticular=On", "Lens_LPI=40",
                     "View_Distance=inf", "Lens_Pixels=" + pixels, more, "+O" + name},
                    m_folder.path());
    ASSERT_EQ(result.status, 0) << result.output;
  };
  render("12", "p.png", "-D");
  render("15", "q.png", "-D");
  render("12", "l.png", "Lens_Slant=9");
  const auto both = run({"sheet", "p.png", "q.png", "--out", "o.pdf"});
  EXPECT_NE(both.output.find("lentray-print: 'p.png' is for 480 x "), std::string::npos)
      << both.output;
  const auto slanted = run({"sheet", "p.png", "l.png", "--out", "o.pdf"});
  EXPECT_NE(slanted.output.find(
                "the lenses of 'p.png' are slanted by 0 degrees and those of 'l.png' by 9"),
            std::string::npos)
      << slanted.output;
}

/// Two resolutions: each page has its size, and gratings the pitch of their label, in every kind of file.
TEST_F(ImagePrintSeveral, TestPagesOfTwoResolutions) {
  const std::vector<std::vector<std::string>> commands{
      {"pitch-test", "--lpi", "40", "--bands", "3"},
      {"phase-test", "--lpi", "40", "--bands", "3"},
      {"eye-test", "--lpi", "40", "--focal-length", "1.8mm"}};
  for (const auto& command : commands) {
    for (const bool lying : {false, true}) {
      for (const char* kind : {"png", "tif", "pdf"}) {
        const std::string name = std::string("o.") + kind;
        std::vector<std::string> words = command;
        words.insert(words.end(), {"--dpi", "720x360", "--size", "150x100mm", "--out", name});
        if (lying) words.push_back("--horizontal");
        const std::string report = print(words);
        EXPECT_NE(report.find("720 dpi across the lenses, 360 along them"), std::string::npos);
        if (name == "o.pdf") {
          const auto info = tool::run_program({"pdfinfo", (m_folder / name).string()});
          EXPECT_NE(info.output.find("425.197 x 283.465 pts"), std::string::npos) << info.output;
          continue;
        }
        const StoredImage image = read(name);
        EXPECT_NEAR(image.width, 150.0 / 25.4 * (lying ? 360.0 : 720.0), 0.51);
        EXPECT_NEAR(image.height, 100.0 / 25.4 * (lying ? 720.0 : 360.0), 0.51);
        EXPECT_NEAR(std::stod(image.attributes.at("XResolution")), lying ? 360.0 : 720.0, 0.02);
        EXPECT_NEAR(std::stod(image.attributes.at("YResolution")), lying ? 720.0 : 360.0, 0.02);
      }
    }
  }
}

}  // namespace
}  // namespace lentray::test
