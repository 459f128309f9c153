// Parts of lentray-print: gratings, letters, pages and their turns, sheets, tiles, pictures for another pitch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/image/orientation.h"
#include "tools/lentray-print/letters.h"
#include "tools/lentray-print/lines.h"
#include "tools/lentray-print/page_error.h"
#include "tools/lentray-print/page_raster.h"
#include "tools/lentray-print/pixels.h"
#include "tools/lentray-print/repitch.h"
#include "tools/lentray-print/sheet.h"
#include "tools/lentray-print/test_pages.h"
#include "tools/lentray-print/tiles.h"

namespace lentray::print {
namespace {

/// RGB of 8 bits; each sample tells its place.
core::StoredImage numbered_picture(std::uint32_t width, std::uint32_t height) {
  core::StoredImage image;
  image.width = width;
  image.height = height;
  image.channels = 3;
  auto& samples = image.samples.store<std::uint8_t>(std::size_t{3} * width * height);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::uint8_t>((i * 37 + i / 1000) % 251);
  return image;
}

bool same_samples(const core::StoredImage& a, const core::StoredImage& b) {
  if (a.width != b.width || a.height != b.height || a.samples.size() != b.samples.size())
    return false;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    if (a.samples[i] != b.samples[i]) return false;
  }
  return true;
}

template <class Work>
std::string page_error(const Work& work) {
  try {
    work();
  } catch (const PageError& e) {
    return e.what();
  }
  return "no error";
}

LensData lens_of_pixels(double pixels, double dpi = 600.0) {
  LensData data;
  data.pixels = pixels;
  data.dpi_x = data.dpi_y = dpi;
  return data;
}

TEST(UnitPrintLines, SharesAddUpExactly) {
  const Lines lines{.period = 15.037, .origin = 3.3};
  double sum = 0.0;
  for (int k = 0; k < 10000; ++k) {
    const double share = inked_share(lines, k, k + 1.0);
    ASSERT_GE(share, -1e-12);
    ASSERT_LE(share, 1.0 + 1e-12);
    sum += share;
  }
  EXPECT_NEAR(sum, 10000.0 * inked_share(lines, 0.0, 10000.0), 1e-7);
  EXPECT_NEAR(sum / 10000.0, 0.5, 1e-3);
  // A line of half a period in the middle of the period that begins at the origin.
  EXPECT_NEAR(inked_share(lines, 3.3, 3.3 + 0.25 * 15.037), 0.0, 1e-12);
  EXPECT_NEAR(inked_share(lines, 3.3 + 0.25 * 15.037, 3.3 + 0.75 * 15.037), 1.0, 1e-12);
}

TEST(UnitPrintLines, HardEdgesAreHalfAPixelOffAtMost) {
  const Page page = page_of(100.0, 10.0, 600.0, 600.0);
  const Lines lines{.period = 15.037};
  const Picture grey = grating({lines, 0.0, 2000.0}, 0, 1, page);
  const Picture hard = grating({lines, 0.0, 2000.0, true}, 0, 1, page);
  bool has_grey = false;
  for (std::uint32_t k = 0; k < 2000; ++k) {
    has_grey = has_grey || (grey.image.at(k, 0, 0) > 0 && grey.image.at(k, 0, 0) < 255);
    EXPECT_EQ(hard.image.at(k, 0, 0), grey.image.at(k, 0, 0) < 127.6f ? 0.0f : 255.0f) << k;
  }
  EXPECT_TRUE(has_grey);
}

TEST(UnitPrintLetters, AllThatAreUsed) {
  const Page pages[] = {pitch_test({}, {39.9, 40.0, 40.1}), phase_test({}, {39.9, 40.0, 40.1}, 8),
                        eye_test({}, {})};
  EXPECT_GT(pages[0].strokes.size(), 300u);
  const auto shape = [](char c) {
    std::vector<double> numbers;
    for (const Stroke& stroke : text_strokes(std::string(1, c), {}, 2.0)) {
      for (const Point& p : stroke.points) numbers.insert(numbers.end(), {p.x, p.y});
    }
    return numbers;
  };
  const std::vector<double> unknown = shape('\xe4');
  for (char c = 'A'; c <= 'Z'; ++c) EXPECT_NE(shape(c), unknown) << c;
  for (char c = 'a'; c <= 'z'; ++c) EXPECT_NE(shape(c), unknown) << c;
  for (const char c : std::string("0123456789 .,:;-+/()%='|_")) EXPECT_NE(shape(c), unknown) << c;
  EXPECT_GT(text_width("\xe4", 2.0), 0.5);
  EXPECT_EQ(text_width("", 2.0), 0.0);
  // Letters stay within their width.
  for (const Stroke& stroke : text_strokes("Wg%", {10.0, 10.0}, 3.0)) {
    for (const Point& p : stroke.points) {
      EXPECT_GE(p.x, 10.0 - 1e-9);
      EXPECT_LE(p.x, 10.0 + text_width("Wg%", 3.0) + 1e-9);
      EXPECT_GE(p.y, 7.0 - 1e-9);
      EXPECT_LE(p.y, 11.0 + 1e-9);
    }
  }
}

Page decorated_page() {
  Page page = page_of(60.0, 40.0, 254.0, 508.0);
  page.pictures.push_back({numbered_picture(30, 20), 7, 11});
  page.bars.push_back({1.0, 2.0, 3.0, 0.25});
  add_text(page, "Ab", {20.0, 30.0}, 4.0);
  page.trim = {1.0, 2.0, 30.0, 20.0};
  return page;
}

void expect_same_page(const Page& a, const Page& b) {
  EXPECT_NEAR(a.width, b.width, 1e-9);
  EXPECT_NEAR(a.height, b.height, 1e-9);
  EXPECT_EQ(a.dpi_x, b.dpi_x);
  ASSERT_EQ(a.pictures.size(), b.pictures.size());
  for (std::size_t i = 0; i < a.pictures.size(); ++i) {
    EXPECT_EQ(a.pictures[i].column, b.pictures[i].column);
    EXPECT_EQ(a.pictures[i].row, b.pictures[i].row);
    EXPECT_TRUE(same_samples(a.pictures[i].image, b.pictures[i].image));
  }
  for (std::size_t i = 0; i < a.bars.size(); ++i) {
    EXPECT_NEAR(a.bars[i].left, b.bars[i].left, 1e-9);
    EXPECT_NEAR(a.bars[i].top, b.bars[i].top, 1e-9);
  }
  for (std::size_t i = 0; i < a.strokes.size(); ++i)
    EXPECT_NEAR(a.strokes[i].points[0].x, b.strokes[i].points[0].x, 1e-9);
  EXPECT_NEAR(a.trim.left, b.trim.left, 1e-9);
}

TEST(UnitPrintPage, MirroredTwiceAndTurnedFourTimes) {
  const Page page = decorated_page();
  expect_same_page(mirrored(mirrored(page)), page);
  expect_same_page(turned(turned(turned(turned(page)))), page);
  const Page once = turned(page);
  EXPECT_EQ(once.width, page.height);
  EXPECT_EQ(once.dpi_x, page.dpi_y);
  // What was at the left is on top, what was on top at the right.
  EXPECT_NEAR(once.bars[0].top, 1.0, 1e-9);
  EXPECT_NEAR(once.bars[0].right(), page.height - 2.0, 1e-9);
}

TEST(UnitPrintPage, PixelsAreThoseOfTheMirroredPage) {
  const Page page = decorated_page(), mirror = mirrored(page);
  const Window all{0, 0, page.columns(), page.rows()};
  const core::StoredImage plain = stored_window(page, all, 8);
  EXPECT_TRUE(same_samples(core::upright(stored_window(mirror, all, 8), core::kMirrored), plain));
  const Page turn = turned(page);
  EXPECT_TRUE(same_samples(stored_window(turn, {0, 0, turn.columns(), turn.rows()}, 8),
                           core::upright(plain, core::kTurned)));
  // The picture is on it as it was.
  for (std::uint32_t x = 0; x < 30; ++x)
    EXPECT_EQ(plain.at(x + 7, 15, 1), page.pictures[0].image.at(x, 4, 1));
  // Bars by the share of a pixel they cover: at 254 dpi a pixel is 0.1 mm, at 508 half of it.
  EXPECT_EQ(plain.at(10, 40, 0), 0.0f);
  EXPECT_EQ(plain.at(9, 40, 0), 255.0f);
  EXPECT_EQ(plain.at(10, 45, 0), 255.0f);
  // 16 bits.
  const core::StoredImage fine = stored_window(page, all, 16);
  EXPECT_EQ(fine.bits, 16);
  EXPECT_EQ(fine.at(8, 15, 1), page.pictures[0].image.at(1, 4, 1) * 257.0f);
}

TEST(UnitPrintTests, LabelsAreTheValues) {
  std::vector<double> thirds = series(40.0, 1.0, 1.0 / 3.0);
  EXPECT_EQ(round_to_labels(thirds), 4);
  EXPECT_DOUBLE_EQ(thirds[0], 39.0);
  EXPECT_DOUBLE_EQ(thirds[1], 39.3333);
  std::vector<double> tenths = series(40.0, 0.5, 0.1);
  EXPECT_EQ(tenths.size(), 11u);
  EXPECT_EQ(round_to_labels(tenths), 1);
  EXPECT_DOUBLE_EQ(tenths[7], 40.2);
}

TEST(UnitPrintTests, NoRoom) {
  EXPECT_EQ(page_error([] { pitch_test({.width = 50.0}, {40.0}); }),
            "a page of 50 x 100 mm is too small for a test; 60 x 40 mm is the least");
  EXPECT_NE(page_error([] {
              pitch_test({.height = 50.0}, series(40.0, 0.5, 0.1));
            }).find("a page of 200 x 50 mm has no room for 11 bands, which need "),
            std::string::npos);
  EXPECT_EQ(page_error([] { pitch_test({.dpi = 70.0}, {40.0}); }),
            "gratings of 40 lpi at 70 dpi: a line and its gap need 2 pixels at least");
  EXPECT_EQ(
      page_error([] { phase_test({.width = 60.0}, {10.0}, 8); }),
      "8 cells of 8 lenses side by side do not fit on a page of 60 mm; give a larger --size or "
      "fewer --phases");
  EXPECT_NE(
      page_error([] { eye_test({}, {.distance = 100.0}); }).find("eyes 65 mm apart have no room"),
      std::string::npos);
}

/// What an eye sees of a row of the eye test behind each lens: the place in the print that the lens shows it.
TEST(UnitPrintTests, LeftEyeBlackRightEyeWhite) {
  const EyeTest test{.lens_pitch = 0.635, .focal_length = 1.8, .ior = 1.56, .distance = 400.0};
  const Page page = eye_test({}, test);
  ASSERT_EQ(page.pictures.size(), 5u);
  const double shares[] = {0.8, 0.9, 1.0, 1.1, 1.2};
  for (std::size_t row = 0; row < 5; ++row) {
    const Picture& picture = page.pictures[row];
    const double distance = test.distance * shares[row];
    for (int lens = -100; lens <= 100; ++lens) {
      const double axis = lens * test.lens_pitch;
      for (const double eye : {-32.5, 32.5}) {
        const double place = axis + test.focal_length / test.ior * (axis - eye) / distance;
        const double column = page.columns() / 2.0 + place / page.pixel_width();
        const auto k = static_cast<std::int64_t>(std::floor(column)) - picture.column;
        ASSERT_GE(k, 0);
        EXPECT_EQ(picture.image.at(static_cast<std::uint32_t>(k), 0, 0), eye < 0.0 ? 0.0f : 255.0f)
            << "row " << row << " lens " << lens << " eye " << eye;
      }
    }
  }
}

TEST(UnitPrintSheet, WholeLensesAlone) {
  const auto whole = [](std::uint32_t width, double pixels) {
    return of_whole_lenses(numbered_picture(width, 2), pixels).width;
  };
  EXPECT_EQ(whole(150, 15.0), 150u);
  EXPECT_EQ(whole(151, 15.0), 150u);
  EXPECT_EQ(whole(164, 15.0), 150u);
  EXPECT_EQ(whole(2400, 15.1839), 2399u);
  // 100 lenses are 1197.0075 and 1793.2752 columns: what is missing is rounding.
  EXPECT_EQ(whole(1197, 11.970075), 1197u);
  EXPECT_EQ(whole(1793, 17.932752), 1793u);
  EXPECT_EQ(whole(1196, 11.970075), 1185u);
  const SheetArt art =
      sheet_art(of_whole_lenses(numbered_picture(161, 8), 15.5), lens_of_pixels(15.5), {});
  EXPECT_EQ(art.end_lens, 10);
  EXPECT_EQ(art.image.width, 155u);
  EXPECT_EQ(page_error([] { of_whole_lenses(numbered_picture(10, 8), 15.0); }),
            "the picture is 10 pixels wide, less than a lens of 15");
}

TEST(UnitPrintSheet, BleedGoesOnViewByView) {
  const core::StoredImage picture = numbered_picture(150, 100);
  SheetStyle style;
  style.bleed = 1.0;  // 0.635 mm a lens: 2 lenses
  const SheetArt art = sheet_art(picture, lens_of_pixels(15.0), style);
  EXPECT_EQ(art.first_column, -30);
  EXPECT_EQ(art.image.width, 210u);
  EXPECT_EQ(art.first_row, -24);  // of 0.0423 mm
  for (std::uint32_t k = 0; k < 30; ++k) {
    EXPECT_EQ(art.image.at(k, 24, 0), picture.at(k % 15, 0, 0));
    EXPECT_EQ(art.image.at(180 + k, 0, 2), picture.at(135 + k % 15, 0, 2));
  }
  EXPECT_EQ(art.trim_left, 0);
  EXPECT_EQ(art.trim_right, 150);
  style.bleed_of_picture = true;
  const SheetArt inner = sheet_art(picture, lens_of_pixels(15.0), SheetStyle(style));
  EXPECT_EQ(page_error([&] {
              SheetStyle wide = style;
              wide.bleed = 30.0;
              sheet_art(picture, lens_of_pixels(15.0), wide);
            }),
            "nothing of the picture is left within that bleed; give a smaller --bleed");
  EXPECT_EQ(inner.trim_left, 30);
  EXPECT_EQ(inner.trim_right, 120);
  EXPECT_TRUE(same_samples(inner.image, picture));
}

TEST(UnitPrintSheet, FractionalLensesGoOnAtTheSamePlace) {
  const double pixels = 15.3;
  const std::vector<std::uint32_t> columns = continued_columns(-31, 60, 306, {pixels});
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double k = static_cast<double>(i) - 31.0 + 0.5, from = columns[i] + 0.5;
    const double phase = k / pixels - std::floor(k / pixels);
    // The nearest that the lens has; at its edge that may be a pixel off.
    EXPECT_NEAR(from / pixels - std::floor(from / pixels), phase, 1.01 / pixels) << i;
    if (k > 0) {
      EXPECT_EQ(from, k);
    }
  }
}

TEST(UnitPrintSheet, PaperTooSmall) {
  SheetStyle style;
  style.paper = parser::Extent{20.0, 15.0};
  const LensData data = lens_of_pixels(15.0);
  const SheetArt art = sheet_art(numbered_picture(300, 200), data, style);
  EXPECT_NE(
      page_error([&] { sheet_page(art, data, style); })
          .find("with its marks and margins, and the paper has 20 x 15 mm; --tiles cuts it into "
                "pages"),
      std::string::npos);
  EXPECT_NE(page_error([&] {
              SheetStyle alone;
              const SheetPage whole = sheet_page(art, data, alone);
              tile_plan(whole.page, whole.boundaries, {.paper = {20.0, 15.0}});
            }).find("paper of 20 x 15 mm is too small for tiles of a sheet of "),
            std::string::npos);
}

TEST(UnitPrintTiles, TogetherTheyAreTheWhole) {
  const LensData data = lens_of_pixels(15.3);
  SheetStyle style;
  style.margin = 1.0;
  style.background = {0.8, 0.9, 1.0};
  const SheetPage sheet =
      sheet_page(sheet_art(numbered_picture(1530, 900), data, style), data, style);
  const core::StoredImage whole =
      stored_window(sheet.page, {0, 0, sheet.page.columns(), sheet.page.rows()}, 8);
  const TilePlan plan = tile_plan(sheet.page, sheet.boundaries,
                                  {.paper = {60.0, 50.0}, .margin = 3.0, .overlap = 4.0});
  EXPECT_GT(plan.rows, 1);
  EXPECT_GT(plan.columns, 1);
  std::vector<char> seen(std::size_t{whole.width} * whole.height, 0);
  for (const Tile& tile : plan.tiles) {
    for (const std::int64_t cut : tile.cut_columns) {
      EXPECT_NE(std::ranges::find(sheet.boundaries, cut), sheet.boundaries.end());
      EXPECT_GT(cut, tile.window.column);
      EXPECT_LT(cut, tile.window.column + tile.window.width);
    }
    const Page page = tile_page(sheet.page, plan, tile, 8);
    const core::StoredImage pixels = stored_window(page, {0, 0, page.columns(), page.rows()}, 8);
    EXPECT_LE(page.width, plan.paper.width);
    for (std::uint32_t y = 0; y < tile.window.height; ++y) {
      for (std::uint32_t x = 0; x < tile.window.width; ++x) {
        const auto column = static_cast<std::uint32_t>(tile.window.column) + x;
        const auto row = static_cast<std::uint32_t>(tile.window.row) + y;
        ++seen[std::size_t{row} * whole.width + column];
        for (int c = 0; c < 3; ++c) {
          ASSERT_EQ(pixels.at(static_cast<std::uint32_t>(plan.left) + x,
                              static_cast<std::uint32_t>(plan.top) + y, c),
                    whole.at(column, row, c));
        }
      }
    }
  }
  EXPECT_EQ(std::ranges::count(seen, 0), 0);
}

TEST(UnitPrintRepitch, SamePitchIsTheSamePicture) {
  const core::StoredImage picture = numbered_picture(153, 9);
  const Repitched same = repitched(picture, 15.3, {15.3});
  EXPECT_TRUE(same_samples(same.image, picture));
  EXPECT_NEAR(same.largest_offset, 0.0, 1e-9);
  EXPECT_EQ(page_error([&] { repitched(picture, 15.3, {0.5}); }),
            "at that pitch a lens is less than one pixel of the print wide");
}

/// Where a value is linear in the place under the lens, interpolation keeps it.
TEST(UnitPrintRepitch, LinearViewsStayLinear) {
  core::StoredImage picture;
  picture.width = 200;
  picture.height = 1;
  picture.channels = 1;
  picture.bits = 16;
  auto& samples = picture.samples.store<std::uint16_t>(200);
  const auto value = [](double column, double pixels) {
    const double u = (column + 0.5) / pixels;
    return 60000.0 * (u - std::floor(u));
  };
  for (int k = 0; k < 200; ++k)
    samples[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(std::lround(value(k, 20.0)));
  const Repitched made = repitched(picture, 20.0, {17.3});
  EXPECT_EQ(made.image.width, 173u);
  for (std::uint32_t k = 0; k < 173; ++k) {
    const double expected = value(k, 17.3);
    const double end = 60000.0 * 0.5 / 20.0;  // nearer to a lens's edge than its last view
    if (expected < end || expected > 60000.0 - end) continue;
    EXPECT_NEAR(made.image.at(k, 0, 0), expected, 1.5) << k;
  }
  EXPECT_LE(made.largest_offset, 0.5 + 0.5);
}

TEST(UnitPrintLensData, ContradictionsAndGaps) {
  core::StoredImage image = numbered_picture(150, 10);
  const auto error = [&image](const GivenLensData& given) {
    return page_error([&] { lens_data_of(image, given, "a.png"); });
  };
  EXPECT_EQ(error({}), "'a.png' does not say at what resolution it is printed; give --dpi D");
  EXPECT_EQ(error({.lens_pitch = {}, .pixels = {}, .dpi_x = 600.0, .dpi_y = {}}),
            "'a.png' has no lens data of lentray; give --pixels N, the pixels a lens, or --lpi L");
  EXPECT_EQ(
      lens_data_of(image, {.lens_pitch = 0.635, .pixels = {}, .dpi_x = 600.0, .dpi_y = {}}, "a")
          .pixels,
      15.0);
  EXPECT_EQ(error({.lens_pitch = {}, .pixels = 15.0, .dpi_x = 0.5, .dpi_y = {}}),
            "'a.png': a resolution of 0.5 x 0.5 dpi; 1 to 100000 are possible");
  EXPECT_EQ(error({.lens_pitch = 1e-3, .pixels = {}, .dpi_x = 600.0, .dpi_y = {}}),
            "'a.png': 0.023622 pixels a lens; 1 to 100000 are possible");
  image.attributes = {{"lentray:lens.pixels", "15"},       {"lentray:lens.print_dpi_x", "600"},
                      {"lentray:lens.print_dpi_y", "300"}, {"lentray:lens.lenses", "10"},
                      {"lentray:lens.pitch_mm", "0.63"},   {"lentray:lens.focal_length_mm", "1.8"},
                      {"lentray:lens.ior", "1.5"}};
  EXPECT_EQ(error({}), "no error");
  EXPECT_EQ(
      error({.lens_pitch = {}, .pixels = 14.0, .dpi_x = {}, .dpi_y = {}}),
      "'a.png' says 15 pixels a lens, which --pixels 14 contradicts; a picture for another print "
      "is rendered anew");
  EXPECT_NE(error({.lens_pitch = {}, .pixels = {}, .dpi_x = 720.0, .dpi_y = {}}).find("--dpi 720"),
            std::string::npos);
  EXPECT_EQ(
      error({.lens_pitch = 0.7, .pixels = {}, .dpi_x = {}, .dpi_y = {}}),
      "'a.png' was rendered for lenses of 0.63 mm, not of 0.7 mm; --pitch fits it to a measured "
      "pitch");
  image.attributes["lentray:lens.lenses"] = "20";
  EXPECT_EQ(
      error({}),
      "'a.png' was rendered 300 pixels wide and has 150 now: resizing and cropping destroy the "
      "strips behind the lenses; render it anew");
  image.attributes["lentray:lens.view"] = "3";
  EXPECT_EQ(error({}), "'a.png' is a single view; an integral image is needed");
  // A TIFF file tells the same in lines of its description.
  core::StoredImage tiff = numbered_picture(150, 10);
  tiff.attributes = {{"ImageDescription",
                      "integral image\nlentray:lens.pixels=15\nlentray:lens.print_dpi_x=600.5\n"}};
  EXPECT_EQ(lens_data_of(tiff, {}, "a.tif").dpi_x, 600.5);
}

TEST(UnitPrintPixels, AlphaOverTheBackgroundAndBits) {
  core::StoredImage image;
  image.width = image.height = 1;
  image.channels = 4;
  image.samples.store<std::uint8_t>(std::vector<std::uint8_t>{255, 0, 0, 51});
  const core::StoredImage on_white = as_printed(image, 8, kWhite);
  EXPECT_EQ(on_white.channels, 3);
  EXPECT_EQ(on_white.at(0, 0, 0), 255.0f);
  EXPECT_EQ(on_white.at(0, 0, 1), 204.0f);
  const core::StoredImage fine = as_printed(image, 16, Colour{});
  EXPECT_EQ(fine.at(0, 0, 0), 13107.0f);
  core::StoredImage linear;
  linear.width = linear.height = 1;
  linear.channels = 1;
  linear.bits = 32;
  linear.samples.assign(1, 0.214041f);
  EXPECT_NEAR(as_printed(linear, 8, kWhite).at(0, 0, 0), 127.5f, 0.51f);
}

}  // namespace
}  // namespace lentray::print
