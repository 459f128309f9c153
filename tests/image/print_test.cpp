// lentray-print as a program: what it writes is measured in the files. Frequencies by a direct Fourier sum at any
// frequency, places by the darkness of lines, sizes as the files and poppler tell them.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "core/image/writer.h"
#include "tests/support/render.h"
#include "tools/lentray-print/test_pages.h"
#include "tools/lentray-print/tiles.h"

namespace lentray::test {
namespace {

constexpr double kPrintInch = 25.4;

/// A row or column of a picture, 0 black to 1 white.
std::vector<double> print_line(const StoredImage& image, std::uint32_t row, std::uint32_t first,
                               std::uint32_t count, bool is_upright = false) {
  const double most = static_cast<double>((1u << image.bits) - 1u);
  std::vector<double> values;
  for (std::uint32_t k = first; k < first + count; ++k)
    values.push_back((is_upright ? image.at(row, k, 0) : image.at(k, row, 0)) / most);
  return values;
}

/// The value at a frequency in cycles a pixel, under a window that keeps other frequencies out.
std::complex<double> print_spectrum(const std::vector<double>& line, double frequency) {
  double mean = 0.0;
  for (const double v : line) mean += v / static_cast<double>(line.size());
  std::complex<double> sum = 0.0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double at = static_cast<double>(k) + 0.5;
    const double window = 0.5 - 0.5 * std::cos(2.0 * M_PI * at / static_cast<double>(line.size()));
    sum += window * (line[k] - mean) * std::polar(1.0, -2.0 * M_PI * frequency * at);
  }
  return sum;
}

/// Cycles a pixel where the spectrum is highest, near a guess.
double print_peak(const std::vector<double>& line, double guess) {
  const double reach = 1.0 / static_cast<double>(line.size());
  double low = guess - reach, high = guess + reach;
  const double ratio = (std::sqrt(5.0) - 1.0) / 2.0;
  for (int i = 0; i < 40; ++i) {
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    const bool is_left = std::abs(print_spectrum(line, a)) > std::abs(print_spectrum(line, b));
    (is_left ? high : low) = is_left ? b : a;
  }
  return (low + high) / 2.0;
}

/// Where the darkness of some pixels lies, in pixels from the first's left edge.
double print_centroid(const std::vector<double>& line) {
  double sum = 0.0, moment = 0.0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    sum += 1.0 - line[k];
    moment += (1.0 - line[k]) * (static_cast<double>(k) + 0.5);
  }
  return moment / sum;
}

std::vector<double> numbers_in(const std::string& text, const std::string& pattern) {
  std::smatch match;
  std::vector<double> out;
  if (std::regex_search(text, match, std::regex(pattern))) {
    for (std::size_t i = 1; i < match.size(); ++i) out.push_back(std::stod(match[i]));
  }
  return out;
}

class ImagePrint : public ::testing::Test {
 protected:
  tool::RunResult print(std::vector<std::string> words) const {
    words.insert(words.begin(), program("lentray-print").string());
    return tool::run_program(words, m_folder.path(), 200);
  }
  void expect_print(const std::vector<std::string>& words) {
    const auto result = print(words);
    ASSERT_EQ(result.status, 0) << result.output;
    m_report = result.output;
  }
  StoredImage read(const std::string& name) const { return core::read_image(m_folder / name); }

  /// Width and height in mm that the pixels have by the file's resolution.
  std::pair<double, double> extent(const StoredImage& image) const {
    return {image.width / std::stod(image.attributes.at("XResolution")) * kPrintInch,
            image.height / std::stod(image.attributes.at("YResolution")) * kPrintInch};
  }
  std::pair<double, double> pdf_extent(const std::string& name) const {
    const auto info = tool::run_program({"pdfinfo", (m_folder / name).string()});
    const auto size = numbers_in(info.output, R"(Page size: +([0-9.]+) x ([0-9.]+) pts)");
    if (size.size() != 2) throw std::runtime_error(info.output);
    return {size[0] / 72.0 * kPrintInch, size[1] / 72.0 * kPrintInch};
  }
  /// Pictures of a PDF file in their order, as they are in it.
  std::vector<StoredImage> pdf_pictures(const std::string& name) const {
    const auto run = tool::run_program(
        {"pdfimages", "-png", (m_folder / name).string(), (m_folder / "got").string()});
    EXPECT_EQ(run.status, 0) << run.output;
    std::vector<StoredImage> all;
    for (int i = 0;; ++i) {
      char number[32];
      std::snprintf(number, sizeof number, "got-%03d.png", i);
      if (!std::filesystem::exists(m_folder / number)) return all;
      all.push_back(core::read_image(m_folder / number));
      std::filesystem::remove(m_folder / number);
    }
  }
  std::set<std::string> files() const {
    std::set<std::string> all;
    for (const auto& file : std::filesystem::directory_iterator(m_folder.path()))
      all.insert(file.path().filename());
    return all;
  }

  /// A sheet as lentray renders it, "s.png": 40 lpi, 600 dpi, 15 pixels a lens.
  void render_sheet(const std::vector<std::string>& more = {}) {
    tool::write_text(m_folder / "a.pov", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,1,-5> look_at 0 right x*2 }
light_source { <5,8,-6> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb <0.4,0.1,0.1> } }
sphere { 0, 1 pigment { rgb <1,0.6,0.1> } finish { phong 0.6 } }
)");
    std::vector<std::string> words{"+Ia.pov",
                                   "-V",
                                   "+W600",
                                   "+H300",
                                   "Lenticular=On",
                                   "Lens_LPI=40",
                                   "Print_DPI=600",
                                   "View_Distance=inf",
                                   "Lens_Focal_Length=1.8",
                                   "Lens_IOR=1.56",
                                   "+Os.png"};
    words.insert(words.end(), more.begin(), more.end());
    const auto result = run_lentray(words, m_folder.path());
    ASSERT_EQ(result.status, 0) << result.output;
  }

  const tool::TemporaryFolder m_folder;
  std::string m_report;
};

constexpr const char* kPrintKinds[] = {"tif", "png", "pdf"};

TEST_F(ImagePrint, EveryBandHasThePitchOfItsLabel) {
  const std::vector<double> lpis = print::series(40.0, 0.5, 0.1);
  const print::Page page = print::pitch_test({}, lpis);
  for (const char* kind : kPrintKinds) {
    expect_print({"pitch-test", "--lpi", "40", "--out", std::string("p.") + kind});
    const bool is_pdf = std::string(kind) == "pdf";
    const std::vector<StoredImage> bands =
        is_pdf ? pdf_pictures("p.pdf") : std::vector<StoredImage>{};
    const StoredImage whole = is_pdf ? StoredImage{} : read(std::string("p.") + kind);
    if (is_pdf) {
      ASSERT_EQ(bands.size(), lpis.size());
    }
    for (std::size_t i = 0; i < lpis.size(); ++i) {
      const print::Picture& band = page.pictures[i];
      const auto left = static_cast<std::uint32_t>(is_pdf ? 0 : band.column);
      const auto top = static_cast<std::uint32_t>(is_pdf ? 0 : band.row);
      const StoredImage& image = is_pdf ? bands[i] : whole;
      ASSERT_GT(band.image.width, 4000u);
      for (const std::uint32_t row : {top, top + band.image.height - 1}) {
        const double measured =
            600.0 * print_peak(print_line(image, row, left, band.image.width), lpis[i] / 600.0);
        EXPECT_NEAR(measured / lpis[i], 1.0, 1e-4) << kind << " " << lpis[i];
      }
    }
  }
}

TEST_F(ImagePrint, LyingBandsAndOddResolutions) {
  expect_print({"pitch-test", "--lens-pitch", "0.337mm", "--bands", "3", "--span", "0.2", "--dpi",
                "604.4", "--size", "120x80mm", "--horizontal", "--out", "p.tif"});
  std::vector<double> lpis{25.4 / 0.337 - 0.2, 25.4 / 0.337, 25.4 / 0.337 + 0.2};
  print::round_to_labels(lpis);
  const print::Page page =
      print::turned(print::pitch_test({.width = 80.0, .height = 120.0, .dpi = 604.4}, lpis));
  const StoredImage image = read("p.tif");
  for (std::size_t i = 0; i < 3; ++i) {
    const print::Picture& band = page.pictures[i];
    const auto line = print_line(image, static_cast<std::uint32_t>(band.column) + 3,
                                 static_cast<std::uint32_t>(band.row), band.image.height, true);
    EXPECT_NEAR(604.4 * print_peak(line, lpis[i] / 604.4) / lpis[i], 1.0, 1e-4);
  }
  EXPECT_NEAR(extent(image).first, 120.0, kPrintInch / 604.4 / 2.0 + 1e-3);
}

TEST_F(ImagePrint, RulersInTheFile) {
  expect_print({"pitch-test", "--lpi", "40", "--out", "p.tif"});
  const StoredImage image = read("p.tif");
  // Through the long ticks of the millimetres, below the line: every 10 mm.
  const double mm = 600.0 / kPrintInch;
  const auto row = static_cast<std::uint32_t>((100.0 - 6.0 - 4.9 + 2.7) * mm);
  for (int i = 1; i < 18; ++i) {
    const double expected = (10.0 + 10.0 * i) * mm;
    const auto first = static_cast<std::uint32_t>(expected - 10.0);
    EXPECT_NEAR((first + print_centroid(print_line(image, row, first, 20))) / mm, 10.0 + 10.0 * i,
                0.01);
  }
}

TEST_F(ImagePrint, PhasesOfCells) {
  expect_print({"phase-test", "--lpi", "40", "--phases", "4", "--bands", "1", "--out", "p.png"});
  const print::Page page = print::phase_test({}, {40.0}, 4);
  const StoredImage image = read("p.png");
  ASSERT_EQ(page.pictures.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const print::Picture& cell = page.pictures[i];
    const auto line = print_line(image, static_cast<std::uint32_t>(cell.row) + 5,
                                 static_cast<std::uint32_t>(cell.column), cell.image.width);
    // Dark where lines are: the spectrum's phase, seen from the middle of the page.
    const double shift = page.columns() / 2.0 - static_cast<double>(cell.column);
    const std::complex<double> turned_back =
        print_spectrum(line, 1.0 / 15.0) * std::polar(1.0, 2.0 * M_PI * shift / 15.0);
    double phase = std::arg(-turned_back) / (-2.0 * M_PI) - static_cast<double>(i) / 4.0;
    phase -= std::round(phase);
    EXPECT_NEAR(phase, 0.0, 0.01) << i;
  }
}

TEST_F(ImagePrint, ExactSizesInEveryKindOfFile) {
  render_sheet();
  for (const char* kind : kPrintKinds) {
    const std::string name = std::string("s4.") + kind;
    expect_print({"sheet", "s.png", "--marks", "none", "--margin", "0mm", "--out", name});
    const auto size = std::string(kind) == "pdf" ? pdf_extent(name) : extent(read(name));
    EXPECT_NEAR(size.first, 25.4, 0.01) << kind;
    EXPECT_NEAR(size.second, 12.7, 0.01) << kind;
  }
  expect_print({"sheet", "s.png", "--paper", "A4", "--bleed", "2mm", "--out", "a.pdf"});
  EXPECT_NEAR(pdf_extent("a.pdf").first, 210.0, 0.01);
  EXPECT_NEAR(pdf_extent("a.pdf").second, 297.0, 0.01);
  // The first picture that the page draws, and the boxes, in points from the lower left.
  const std::string pdf = tool::read_text(m_folder / "a.pdf");
  const auto matrix = numbers_in(pdf, R"(q ([0-9.]+) 0 0 ([0-9.]+) ([0-9.]+) ([0-9.]+) cm /P0 Do)");
  ASSERT_EQ(matrix.size(), 4u);
  const double mm = kPrintInch / 72.0;
  EXPECT_NEAR(matrix[0] * mm, 25.4 + 2 * 4 * 0.635, 0.01);
  EXPECT_NEAR(matrix[1] * mm, 12.7 + 2 * 48 * kPrintInch / 600.0, 0.01);
  const auto trim = numbers_in(pdf, R"(/TrimBox\[([0-9.]+) ([0-9.]+) ([0-9.]+) ([0-9.]+)\])");
  ASSERT_EQ(trim.size(), 4u);
  EXPECT_NEAR((trim[2] - trim[0]) * mm, 25.4, 0.01);
  EXPECT_NEAR((trim[3] - trim[1]) * mm, 12.7, 0.01);
  EXPECT_NEAR((trim[0] - matrix[2]) * mm, 4 * 0.635, 0.01);
  EXPECT_NEAR((matrix[2] + matrix[0] / 2.0) * mm, 105.0, kPrintInch / 600.0);
  EXPECT_NE(pdf.find("/PrintScaling/None"), std::string::npos);
}

TEST_F(ImagePrint, PictureInThePdfIsThePictureBitForBit) {
  render_sheet();
  expect_print({"sheet", "s.png", "--out", "a.pdf"});
  const std::vector<StoredImage> pictures = pdf_pictures("a.pdf");
  ASSERT_EQ(pictures.size(), 5u);
  EXPECT_TRUE(same_bits(pictures[0], read("s.png")));
}

/// The first picture of a PDF file, inflated, its predictor undone: pdfimages keeps 8 bits alone.
std::string print_first_picture(const std::string& pdf, std::size_t row_bytes, std::size_t rows) {
  const std::size_t start = pdf.find("stream\n", pdf.find("/Subtype/Image")) + 7;
  std::string coded((row_bytes + 1) * rows, '\0'), plain;
  uLongf size = coded.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(coded.data()), &size,
                       reinterpret_cast<const Bytef*>(pdf.data() + start), pdf.size() - start),
            Z_OK);
  EXPECT_EQ(size, coded.size());
  for (std::size_t row = 0; row < rows; ++row) {
    EXPECT_EQ(coded[row * (row_bytes + 1)], 2);
    for (std::size_t i = 0; i < row_bytes; ++i) {
      const char above = row == 0 ? '\0' : plain[(row - 1) * row_bytes + i];
      plain += static_cast<char>(coded[row * (row_bytes + 1) + 1 + i] + above);
    }
  }
  return plain;
}

TEST_F(ImagePrint, PictureOf16BitsInThePdf) {
  render_sheet({"+FN16"});
  expect_print({"sheet", "s.png", "--out", "a.pdf"});
  const StoredImage image = read("s.png");
  ASSERT_EQ(image.bits, 16);
  const std::string bytes =
      print_first_picture(tool::read_text(m_folder / "a.pdf"), 6u * image.width, image.height);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    const auto high = static_cast<unsigned char>(bytes[2 * i]);
    const auto low = static_cast<unsigned char>(bytes[2 * i + 1]);
    if (image.samples[i] != static_cast<float>(high * 256 + low)) ++differing;
  }
  EXPECT_EQ(differing, 0u);
  // Poppler reads it too.
  const auto list = tool::run_program({"pdfimages", "-list", (m_folder / "a.pdf").string()});
  EXPECT_TRUE(std::regex_search(list.output, std::regex(R"(image +600 +300 +rgb +3 +16 )")))
      << list.output;
}

/// Poppler draws the page as we do.
TEST_F(ImagePrint, PdfAndTiffLookAlike) {
  render_sheet();
  expect_print({"sheet", "s.png", "--bleed", "1mm", "--out", "a.pdf"});
  expect_print({"sheet", "s.png", "--bleed", "1mm", "--out", "a.tif"});
  const auto run = tool::run_program({"pdftoppm", "-r", "600", "-singlefile",
                                      (m_folder / "a.pdf").string(), (m_folder / "a").string()});
  ASSERT_EQ(run.status, 0) << run.output;
  const StoredImage drawn = read("a.ppm"), ours = read("a.tif");
  ASSERT_EQ(drawn.width, ours.width);
  ASSERT_EQ(drawn.height, ours.height);
  double sum = 0.0;
  for (std::size_t i = 0; i < ours.samples.size(); ++i)
    sum += std::fabs(ours.samples[i] - drawn.samples[i]);
  EXPECT_LT(sum / static_cast<double>(ours.samples.size()), 1.0);  // of 255; edges of text and bars
}

TEST_F(ImagePrint, MarksInTheFile) {
  render_sheet();
  expect_print({"sheet", "s.png", "--bleed", "1mm", "--out", "a.tif"});
  const auto trimmed =
      numbers_in(m_report, R"(trimmed: ([0-9.]+) x ([0-9.]+) mm at ([0-9.]+), ([0-9.]+) mm)");
  ASSERT_EQ(trimmed.size(), 4u);
  EXPECT_NEAR(trimmed[0], 25.4, 0.001);
  const StoredImage image = read("a.tif");
  const double mm = 600.0 / kPrintInch;
  // Bleed: 2 lenses at the sides, 24 rows. Gratings begin 1 mm beyond it.
  const double left = trimmed[2] * mm, top = trimmed[3] * mm;
  // Crop marks: beyond the bleed and 1 mm, for 5 mm.
  for (const double x : {left, left + 600.0}) {
    const auto first = static_cast<std::uint32_t>(x - 8.0);
    const auto row = static_cast<std::uint32_t>(top - 24.0 - 3.5 * mm);
    EXPECT_NEAR(first + print_centroid(print_line(image, row, first, 16)), x, 0.01 * mm);
  }
  for (const double y : {top, top + 300.0}) {
    const auto first = static_cast<std::uint32_t>(y - 8.0);
    const auto column = static_cast<std::uint32_t>(left - 30.0 - 3.5 * mm);
    EXPECT_NEAR(first + print_centroid(print_line(image, column, first, 16, true)), y, 0.01 * mm);
  }
  // The grating above, at the lenses' pitch, dark in the middle of each lens.
  const auto row = static_cast<std::uint32_t>(top - 24.0 - 2.5 * mm);
  const auto first = static_cast<std::uint32_t>(std::lround(left)) + 4 * 15;
  const auto line = print_line(image, row, first, 32 * 15);
  EXPECT_NEAR(print_peak(line, 1.0 / 15.0) * 15.0, 1.0, 1e-4);
  EXPECT_NEAR(std::arg(-print_spectrum(line, 1.0 / 15.0) * std::polar(1.0, M_PI)), 0.0, 0.02);
  // The bar beside, 2 or 3 and a half lenses wide, as long as the picture but for the corners.
  const auto middle = static_cast<std::uint32_t>(top + 150.0);
  const auto beside =
      print_line(image, middle, 0, static_cast<std::uint32_t>(left) - 30 - 30 - 75 - 5);
  double dark = 0.0;
  for (const double v : beside) dark += 1.0 - v;
  const double lenses = dark / 15.0;
  EXPECT_NEAR(lenses - std::floor(lenses), 0.5, 0.01);
}

TEST_F(ImagePrint, MirroredAndTurnedFiles) {
  render_sheet();
  expect_print({"sheet", "s.png", "--marks", "crop", "--out", "a.png"});
  expect_print({"sheet", "s.png", "--marks", "crop", "--mirror", "--out", "m.png"});
  expect_print({"sheet", "s.png", "--marks", "crop", "--horizontal", "--out", "h.png"});
  const StoredImage a = read("a.png"), m = read("m.png"), h = read("h.png");
  ASSERT_EQ(a.width, m.width);
  ASSERT_EQ(a.width, h.height);
  std::size_t mirror_differs = 0, turn_differs = 0;
  for (std::uint32_t y = 0; y < a.height; ++y) {
    for (std::uint32_t x = 0; x < a.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        if (a.at(x, y, c) != m.at(a.width - 1 - x, y, c)) ++mirror_differs;
        if (a.at(x, y, c) != h.at(a.height - 1 - y, x, c)) ++turn_differs;
      }
    }
  }
  EXPECT_EQ(mirror_differs, 0u);
  EXPECT_EQ(turn_differs, 0u);
}

TEST_F(ImagePrint, TilesTogetherAreTheWhole) {
  render_sheet({"Lens_LPI=10", "Print_DPI=150"});  // 101.6 x 50.8 mm
  expect_print({"sheet", "s.png", "--margin", "1mm", "--out", "whole.png"});
  const StoredImage whole = read("whole.png");
  for (const char* kind : kPrintKinds) {
    const std::string name = std::string("t.") + kind;
    expect_print(
        {"sheet", "s.png", "--paper", "90x70mm", "--tiles", "--overlap", "8mm", "--out", name});
    const bool is_pdf = name == "t.pdf";
    const std::vector<StoredImage> windows =
        is_pdf ? pdf_pictures(name) : std::vector<StoredImage>{};
    std::vector<char> seen(whole.samples.size() / 3, 0);
    const std::regex told(
        R"((\S+): row \d+ column \d+ of (\d+) x (\d+): columns (\d+) to (\d+), rows (\d+) to (\d+))");
    std::size_t tiles = 0;
    for (std::sregex_iterator at(m_report.begin(), m_report.end(), told), end; at != end;
         ++at, ++tiles) {
      const StoredImage page = is_pdf ? windows.at(tiles) : read((*at)[1]);
      const auto border =
          static_cast<std::uint32_t>(is_pdf ? 0 : std::lround(10.0 / kPrintInch * 150.0));
      if (!is_pdf) {
        EXPECT_NEAR(extent(page).first * extent(page).second, 90.0 * 70.0, 90.0 * 0.2);
      }
      const auto number = [&](int i) { return static_cast<std::uint32_t>(std::stoul((*at)[i])); };
      for (std::uint32_t y = number(6); y <= number(7); ++y) {
        for (std::uint32_t x = number(4); x <= number(5); ++x) {
          seen[std::size_t{y} * whole.width + x] = 1;
          for (int c = 0; c < 3; ++c)
            ASSERT_EQ(page.at(x - number(4) + border, y - number(6) + border, c),
                      whole.at(x, y, c));
        }
      }
    }
    EXPECT_GE(tiles, 2u) << m_report;
    EXPECT_EQ(std::ranges::count(seen, 0), 0) << kind;
  }
}

TEST_F(ImagePrint, MeasuredPitchBesideTheNewRender) {
  render_sheet({"View_Distance=400", "+FN16"});
  // 39 lenses of 15.0433 pixels become wider by two pixels in all, so that the fit, which leaves the middle where it
  // is, begins its first strip with a whole column as the new render does.
  const double lpi = 600.0 / (15.0 * (1.0 + 1.8 / (1.56 * 400.0)) + 1.0 / 19.5);
  char pitch[32];
  std::snprintf(pitch, sizeof pitch, "%.12glpi", lpi);
  expect_print({"sheet", "s.png", "--pitch", pitch, "--marks", "none", "--margin", "0mm", "--out",
                "made.png"});
  const auto told = numbers_in(m_report, R"(about ([0-9]+) to ([0-9]+) dB PSNR)");
  ASSERT_EQ(told.size(), 2u) << m_report;
  // The command that is told renders the same sheet.
  const std::size_t at = m_report.find("exact: lentray SCENE.pov ");
  ASSERT_NE(at, std::string::npos) << m_report;
  std::vector<std::string> words{"+Ia.pov", "-V", "+FN16", "+Onew.png"};
  std::istringstream options(m_report.substr(at + 25, m_report.find('\n', at) - at - 25));
  for (std::string word; options >> word;) words.push_back(word);
  const auto run = run_lentray(words, m_folder.path());
  ASSERT_EQ(run.status, 0) << run.output;
  const StoredImage made = read("made.png"), fresh = read("new.png");
  EXPECT_NEAR(std::stod(fresh.attributes.at("lentray:lens.print_pitch_mm")) / (25.4 / lpi), 1.0,
              1e-9);
  EXPECT_NEAR(std::stod(fresh.attributes.at("lentray:lens.print_dpi_x")) / 600.0, 1.0, 1e-9);
  ASSERT_EQ(made.height, fresh.height);
  double sum = 0.0;
  const std::uint32_t width = std::min(made.width, fresh.width);
  for (std::uint32_t y = 0; y < made.height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double error = (made.at(x, y, c) - fresh.at(x, y, c)) / 65535.0;
        sum += error * error;
      }
    }
  }
  const double psnr = -10.0 * std::log10(sum / (3.0 * width * made.height));
  EXPECT_GT(psnr, told[0] - 3.0) << m_report;
  EXPECT_LT(psnr, told[1] + 3.0) << m_report;
}

TEST_F(ImagePrint, CutLensesAreLeftOut) {
  render_sheet({"+W607"});
  expect_print({"sheet", "s.png", "--marks", "none", "--margin", "0mm", "--out", "a.png"});
  EXPECT_NE(m_report.find("left out at the right: 7 pixels of a cut lens\n"), std::string::npos)
      << m_report;
  EXPECT_EQ(read("a.png").width, 600u);
}

TEST_F(ImagePrint, WholePixelsAMetreAreTooCoarseForLargePng) {
  core::StoredImage image;
  image.width = 4000;
  image.height = 10;
  image.channels = 1;
  image.samples.store<std::uint8_t>(40000);
  core::write_stored(image, m_folder / "w.png");
  const std::vector<std::string> words{"sheet", "w.png",   "--pixels", "16",   "--dpi",
                                       "25.12", "--marks", "none",     "--out"};
  const auto with = [&](const std::string& name) {
    std::vector<std::string> all = words;
    all.push_back(name);
    return print(all);
  };
  const auto png = with("a.png");
  EXPECT_EQ(png.status, 0) << png.output;
  EXPECT_NE(png.output.find("lentray-print: warning: 'a.png': PNG holds whole pixels a metre only"),
            std::string::npos)
      << png.output;
  EXPECT_EQ(with("a.tif").output.find("warning"), std::string::npos);
  EXPECT_NEAR(extent(read("a.tif")).first, read("a.tif").width * kPrintInch / 25.12, 0.01);
  EXPECT_EQ(with("a.pdf").status, 0);
}

TEST_F(ImagePrint, WhatFailsLeavesTheFileThatWasThere) {
  render_sheet();
  tool::write_text(m_folder / "a.pdf", "older");
  core::StoredImage plain;
  plain.width = 100;
  plain.height = 10;
  plain.channels = 1;
  plain.samples.store<std::uint8_t>(1000);
  core::write_stored(plain, m_folder / "plain.png");
  tool::write_text(m_folder / "broken.png", "no picture");
  const std::set<std::string> before = files();
  const auto fails = [&](const std::vector<std::string>& words, const std::string& why) {
    const auto result = print(words);
    EXPECT_EQ(result.status, 1) << result.output;
    EXPECT_NE(result.output.find("lentray-print: " + why), std::string::npos) << result.output;
    EXPECT_EQ(tool::read_text(m_folder / "a.pdf"), "older");
    EXPECT_EQ(files(), before);
  };
  fails({"sheet", "plain.png", "--out", "a.pdf"},
        "'plain.png' does not say at what resolution it is printed; give --dpi D\n");
  fails({"sheet", "plain.png", "--dpi", "600", "--out", "a.pdf"},
        "'plain.png' has no lens data of lentray; give --pixels N");
  fails({"sheet", "s.png", "--paper", "30x20mm", "--out", "a.pdf"}, "the sheet needs ");
  fails({"sheet", "s.png", "--paper", "20x20mm", "--tiles", "--out", "a.pdf"},
        "paper of 20 x 20 mm is too small");
  fails({"sheet", "s.png", "--bleed", "nan", "--out", "a.pdf"}, "option --bleed nan: a number");
  fails({"sheet", "s.png", "--pixels", "14", "--out", "a.pdf"}, "'s.png' says 15 pixels a lens");
  fails({"sheet", "s.png", "--pitch", "900lpi", "--out", "a.pdf"},
        "at that pitch a lens is less than one pixel of the print wide");
  fails({"sheet", "none.png", "--out", "a.pdf"}, "cannot read 'none.png': there is no such file");
  fails({"sheet", "broken.png", "--out", "a.pdf"}, "cannot read 'broken.png': ");
  fails({"sheet", "s.png", "--out", "none/a.pdf"}, "cannot write ");
  fails({"sheet", "s.png", "--out", "a.jpg"},
        "cannot write 'a.jpg': pages are .pdf, .tif or .png, not '.jpg'\n");
  fails({"sheet", "s.png", "--out", "a"},
        "cannot write 'a': pages are .pdf, .tif or .png, not ''\n");
  fails({"pitch-test", "--lpi", "40", "--size", "200x50mm", "--out", "a.pdf"},
        "a page of 200 x 50 mm has no room");
  fails({"pitch-test", "--lpi", "40", "--span", "1", "--step", "0.001", "--out", "a.pdf"},
        "a span of 1 lpi by 0.001 makes 2001 gratings; 201 are possible\n");
  fails({"pitch-test", "--lpi", "1.2", "--out", "a.pdf"},
        "gratings down to 0.7 lines an inch: 1 is the least");
  fails({"pitch-test", "--lpi", "40", "--size", "90x90m", "--out", "a.pdf"},
        "a test page of 90000 x 90000 mm at 600 dpi has more than 100000 pixels a side\n");
  fails({"sheet", "plain.png", "--pixels", "10", "--dpi", "10", "--dpi-y", "50000", "--out",
         "a.tif", "--margin", "1m"},
        "cannot write 'a.tif': a page of ");
  fails({"sheet", "plain.png", "--pixels", "10", "--dpi", "600", "--margin", "1m", "--paper",
         "7x8m", "--out", "a.pdf"},
        "cannot write 'a.pdf': a page of PDF is 5080 mm long at most");
  fails({}, "no command is given");
}

/// A full device: the message is the system's.
TEST_F(ImagePrint, FullDisk) {
  render_sheet();
  for (const char* kind : kPrintKinds) {
    const std::string name = std::string("full.") + kind;
    std::filesystem::create_symlink("/dev/full", m_folder / name);
    const auto result = print({"sheet", "s.png", "--out", name});
    EXPECT_EQ(result.status, 1) << result.output;
    EXPECT_NE(result.output.find("No space left on device"), std::string::npos) << result.output;
  }
}

TEST_F(ImagePrint, HelpAndVersion) {
  const auto help = print({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.output.rfind("usage: lentray-print pitch-test", 0), 0u);
  EXPECT_EQ(print({"sheet", "--help"}).output, help.output);
  EXPECT_EQ(print({"--version"}).output.rfind("lentray-print ", 0), 0u);
  // Every line fits on a terminal.
  std::istringstream lines(help.output);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

}  // namespace
}  // namespace lentray::test
