// The page of a batch: small pictures, what stands on it for each kind of row, escaping, and its size.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "core/image/reader.h"
#include "core/image/thumbnail.h"
#include "tools/common/page_text.h"
#include "tools/common/process.h"
#include "tools/lentray-batch/page.h"
#include "tools/lentray-batch/page_cards.h"
#include "tools/lentray-batch/page_data.h"
#include "tools/lentray-batch/page_pictures.h"

namespace lentray::batch {
namespace {

namespace fs = std::filesystem;
using core::StoredImage;
using nlohmann::json;
using tool::base64;
using tool::link_to;
using Bytes = std::vector<std::uint8_t>;

StoredImage picture(std::uint32_t width, std::uint32_t height, int channels, Bytes samples) {
  StoredImage image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.samples.store<std::uint8_t>(std::move(samples));
  return image;
}

using Colour = std::array<int, 3>;

/// Column x has the colour of x.
template <typename Of>
StoredImage columns(std::uint32_t width, std::uint32_t height, const Of& colour_of) {
  Bytes samples;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      for (const int part : Colour(colour_of(x)))
        samples.push_back(static_cast<std::uint8_t>(part));
    }
  }
  return picture(width, height, 3, std::move(samples));
}

StoredImage noise(std::uint32_t width, std::uint32_t height, unsigned seed) {
  std::mt19937 random(seed);
  Bytes samples(std::size_t{3} * width * height);
  for (std::uint8_t& sample : samples) sample = static_cast<std::uint8_t>(random());
  return picture(width, height, 3, std::move(samples));
}

// --- small pictures

TEST(UnitThumbnail, AveragesLight) {
  const StoredImage two = picture(2, 2, 1, {0, 255, 255, 0});
  EXPECT_EQ(core::thumbnail_of(two, {1, 1}).rgb,
            (Bytes{188, 188, 188}));  // half of the light, in sRGB
  StoredImage linear = two;
  linear.gamma = 1.0;
  linear.samples.store<std::uint8_t>(Bytes{55, 55, 55, 55});  // 0.2157 of the light is 128 in sRGB
  EXPECT_EQ(core::thumbnail_of(linear, {1, 1}).rgb, (Bytes{128, 128, 128}));
}

TEST(UnitThumbnail, SameSizeKeepsEveryValue) {
  Bytes all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  const core::Thumbnail same = core::thumbnail_of(picture(256, 1, 1, all), {256, 1});
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(same.rgb[3 * i], i);
}

TEST(UnitThumbnail, OtherProportionsAndLargerSizes) {
  const StoredImage three = picture(3, 1, 1, {0, 255, 0});
  const core::Thumbnail wide = core::thumbnail_of(three, {6, 2});
  EXPECT_EQ(wide.rgb[0], 0);
  EXPECT_EQ(wide.rgb[3 * 2], 255);
  EXPECT_EQ(wide.rgb[3 * 3], 255);
  EXPECT_EQ(wide.rgb[3 * 4], 0);
  // Two thirds of a pixel are black in each half, and one white.
  EXPECT_EQ(core::thumbnail_of(three, {2, 1}).rgb[0], 156);
  EXPECT_THROW(core::thumbnail_of(three, {0, 1}), std::invalid_argument);
}

TEST(UnitThumbnail, SixteenBitsFloatsAndAlpha) {
  StoredImage deep = picture(1, 1, 3, {});
  deep.bits = 16;
  deep.samples.store<std::uint16_t>(std::vector<std::uint16_t>{0, 32896, 65535});
  EXPECT_EQ(core::thumbnail_of(deep, {1, 1}).rgb, (Bytes{0, 128, 255}));
  StoredImage light = picture(1, 1, 3, {});
  light.bits = 32;
  light.gamma = 1.0;
  light.samples.store<float>(std::vector<float>{std::nanf(""), 0.2158605f, 1e30f});
  EXPECT_EQ(core::thumbnail_of(light, {1, 1}).rgb, (Bytes{0, 128, 255}));
  const StoredImage clear = picture(2, 1, 4, {200, 10, 10, 255, 200, 10, 10, 0});
  const core::Thumbnail shown = core::thumbnail_of(clear, {2, 1});
  EXPECT_EQ(shown.rgb[0], 200);
  EXPECT_EQ(shown.rgb[3], shown.rgb[4]);  // the grey behind
}

TEST(UnitThumbnail, ColumnsOfViews) {
  using Columns = std::vector<std::uint32_t>;
  EXPECT_EQ(core::view_columns(15, 5.0, 0.0), (Columns{0, 5, 10}));
  EXPECT_EQ(core::view_columns(15, 5.0, 2.0), (Columns{2, 7, 12}));
  EXPECT_EQ(core::view_columns(18, 5.0, 4.0), (Columns{4, 9, 14})) << "the cut lens is left out";
  EXPECT_EQ(core::view_columns(14, 4.7, 0.0), (Columns{0, 5, 9}));
  EXPECT_EQ(core::view_columns(15, 4.7, 1.85), (Columns{2, 7, 11}));
  EXPECT_EQ(core::view_columns(3, 5.0, 4.0), (Columns{2})) << "less than a lens";
  EXPECT_THROW(core::view_columns(3, 0.5, 0.0), std::invalid_argument);
}

TEST(UnitThumbnail, ViewsAndStacks) {
  const StoredImage sheet = columns(20, 4, [](std::uint32_t x) {
    return Colour{int(x % 5) * 60, 0, 0};
  });
  const auto views = core::view_thumbnails(sheet, 5.0, {4.0, 0.0, 2.2}, {4, 2});
  ASSERT_EQ(views.size(), 3u);
  EXPECT_EQ(views[0].rgb[0], 240);
  EXPECT_EQ(views[1].rgb[0], 0);
  EXPECT_EQ(views[2].rgb[0], 120);
  const core::Thumbnail all = core::stacked(views);
  EXPECT_EQ(all.height, 6u);
  EXPECT_EQ(all.rgb[3u * 4 * 4], 120);
}

TEST(UnitThumbnail, JpegIsReadBack) {
  const tool::TemporaryFolder folder;
  const core::Thumbnail grey = core::thumbnail_of(picture(1, 1, 3, {200, 100, 50}), {33, 17});
  const std::string jpeg = core::jpeg_of(grey, 90);
  EXPECT_LT(jpeg.size(), 1000u);
  std::ofstream(folder / "a.jpg", std::ios::binary) << jpeg;
  const StoredImage back = core::read_image(folder / "a.jpg");
  EXPECT_EQ(back.width, 33u);
  EXPECT_EQ(back.height, 17u);
  EXPECT_NEAR(back.at(20, 10, 0), 200, 3);
  EXPECT_NEAR(back.at(20, 10, 2), 50, 3);
  EXPECT_LT(core::jpeg_of(core::thumbnail_of(noise(64, 64, 1), {64, 64}), 20).size(),
            core::jpeg_of(core::thumbnail_of(noise(64, 64, 1), {64, 64}), 80).size());
}

// --- cards

Row done(const std::string& name, double wall) {
  Row row;
  row.name = name;
  row.source = "/scenes/" + name + ".pov";
  row.state = State::done;
  row.wall = row.cpu = wall;
  return row;
}

Verdict graded(const std::string& grade, double stock_cpu = 0.0) {
  Verdict verdict;
  verdict.grade = grade;
  verdict.stock_cpu = stock_cpu;
  return verdict;
}

Verdict graded(const std::string& grade, const std::string& stock, const std::string& difference,
               double stock_cpu = 0.0) {
  Verdict verdict = graded(grade, stock_cpu);
  verdict.stock = stock;
  verdict.difference = difference;
  return verdict;
}

TEST(UnitBatchPage, FramesShareACard) {
  std::vector<Row> rows{done("a", 1), done("b#10", 2), done("c", 1), done("b#9", 3),
                        done("odd#name", 1)};
  rows[1].frame = 10;
  rows[3].frame = 9;
  rows[3].state = State::failed;
  rows[1].warnings = 2;
  const std::vector<Card> cards = cards_of(rows);
  ASSERT_EQ(cards.size(), 4u);
  EXPECT_EQ(cards[1].name, "b");
  EXPECT_EQ(cards[1].rows, (std::vector<std::size_t>{3, 1}));
  EXPECT_EQ(cards[1].state, State::failed);
  EXPECT_EQ(cards[1].warnings, 2);
  EXPECT_EQ(cards[1].time, 5.0);
  EXPECT_EQ(cards[3].name, "odd#name");
}

TEST(UnitBatchPage, SlowIsTheSlowestTenthOrTenTimesTheMedian) {
  std::vector<Row> rows;
  for (int i = 0; i < 30; ++i) rows.push_back(done("s" + std::to_string(i), 1.0 + i));
  const std::vector<Card> many = cards_of(rows);
  EXPECT_FALSE(many[26].is_slow);
  EXPECT_TRUE(many[27].is_slow);
  EXPECT_EQ(summary_of(rows, many).slow, 3u);
  const std::vector<Card> few = cards_of({done("a", 1), done("b", 1), done("c", 11)});
  EXPECT_FALSE(few[0].is_slow);
  EXPECT_TRUE(few[2].is_slow);
  const std::vector<Card> equal = cards_of(std::vector<Row>(20, done("a", 1)));
  EXPECT_FALSE(equal[0].is_slow);
}

TEST(UnitBatchPage, WhatWillBeWrongWithASheet) {
  std::vector<Row> rows{done("a#1", 1), done("a#2", 1), done("b", 1), done("c", 1), done("d", 1)};
  rows[0].frame = 1;
  rows[1].frame = 2;
  rows[0].warnings = 3;
  rows[0].kinds = {{"jumps", "by 3.1 pixels\nby 4 pixels"}};
  rows[1].warnings = 1;
  rows[1].kinds = {{"flat", "nothing moves"}};
  rows[2].warnings = 1;
  rows[2].kinds = {{"jumps", "by 9 pixels"}, {"of a manifest from elsewhere", "x"}};
  rows[4].state = State::waiting;
  const std::vector<Card> cards = cards_of(rows);
  EXPECT_EQ(cards[0].warnings, 4);
  EXPECT_EQ(cards[0].others, 1);
  EXPECT_EQ(cards[0].kinds.at("flat"), "nothing moves");
  EXPECT_EQ(cards[3].state, State::waiting);
  const Summary sum = summary_of(rows, cards);
  EXPECT_EQ(sum.kinds, (std::map<std::string, std::size_t>{{"flat", 1}, {"jumps", 2}}));
  EXPECT_EQ(sum.waiting, 1u);
  EXPECT_EQ(sum.made, 4u);
  EXPECT_EQ(text_of(sum.kinds, sum.done), "2 of 3 sheets jump, 1 is flat");
}

TEST(UnitBatchPage, ACardIsDoneOnceAllItsFramesAre) {
  std::vector<Row> rows{done("a#1", 1), done("a#2", 1), done("a#3", 1)};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].frame = static_cast<int>(i);
  EXPECT_EQ(cards_of(rows)[0].state, State::done);
  rows[2].state = State::waiting;
  EXPECT_EQ(cards_of(rows)[0].state, State::waiting);
  rows[0].state = State::failed;
  EXPECT_EQ(cards_of(rows)[0].state, State::failed);
}

TEST(UnitBatchPage, GradesAndRatios) {
  std::vector<Row> rows{done("a#1", 2), done("a#2", 2), done("b", 1), done("c", 1)};
  rows[0].frame = 1;
  rows[1].frame = 2;
  rows[0].verdict = graded("exact", 10.0);
  rows[1].verdict = graded("close", 6.0);
  rows[2].verdict = graded("differs", 8.0);
  rows[3].verdict = Verdict{};
  const std::vector<Card> cards = cards_of(rows);
  EXPECT_EQ(cards[0].grade, "close");
  EXPECT_EQ(cards[0].ratio, 4.0);
  const Summary sum = summary_of(rows, cards);
  EXPECT_TRUE(sum.is_compared);
  EXPECT_EQ(sum.differing, 1u);
  EXPECT_EQ(sum.grades, (std::map<std::string, std::size_t>{{"close", 1}, {"differs", 1}}));
  EXPECT_EQ(sum.median_ratio, 8.0);
}

// --- the page

class UnitBatchPageOf : public ::testing::Test {
 protected:
  PageOptions options() const {
    PageOptions out;
    out.title = "Scenes";
    out.folder = m_folder / ".";
    return out;
  }
  /// A row of that picture, which is written.
  Row shown(const std::string& name, const StoredImage& image, const std::string& file) const {
    fs::create_directories((m_folder / file).parent_path());
    core::write_stored(image, m_folder / file);
    Row row = done(name, 1.0);
    row.picture = file;
    row.width = image.width;
    row.height = image.height;
    row.bytes = fs::file_size(m_folder / file);
    return row;
  }
  static json data_of(const std::string& text) {
    const std::string begin = "<script type=\"application/json\" id=\"data\">";
    const std::size_t from = text.find(begin) + begin.size();
    return json::parse(text.substr(from, text.find("</script>", from) - from));
  }
  json data(const std::vector<Row>& rows) const { return data_of(page(rows, options())); }
  StoredImage decoded(const json& base64_text) const {
    const tool::TemporaryFolder folder;
    const std::string text = base64_text.get<std::string>();
    std::ofstream(folder / "a.jpg", std::ios::binary) << bytes_of(text);
    return core::read_image(folder / "a.jpg");
  }
  static std::string bytes_of(const std::string& text) {
    static const std::string digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned group = 0, bits = 0;
    for (const char c : text) {
      if (c == '=') break;
      group = group << 6 | static_cast<unsigned>(digits.find(c));
      bits += 6;
      if (bits >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255u);
    }
    return bytes;
  }
  std::set<fs::path> kept() const {
    std::set<fs::path> files;
    for (const auto& file : fs::directory_iterator(m_folder / ".lentray-batch/thumbnails"))
      files.insert(file.path());
    return files;
  }
  const tool::TemporaryFolder m_folder;
};

TEST_F(UnitBatchPageOf, Base64) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(bytes_of(base64("\xff\x01\xfe")), "\xff\x01\xfe");
}

TEST_F(UnitBatchPageOf, LinksAreRelativeAndEscaped) {
  const fs::path folder = "/batch";
  EXPECT_EQ(link_to("a b/c#1?.png", folder), "./a%20b/c%231%3F.png");
  EXPECT_EQ(link_to("javascript:alert(1).png", folder), "./javascript%3Aalert%281%29.png");
  EXPECT_EQ(link_to("\"<\xff\xc3\xbc%20.png", folder), "./%22%3C%FF%C3%BC%2520.png");
  EXPECT_EQ(link_to("/batch/x/a.png", folder), "./x/a.png");
  EXPECT_EQ(link_to("/other/a.png", folder), "../other/a.png");
}

TEST_F(UnitBatchPageOf, StrangersTextStaysText) {
  Row row = done("</script><script>alert(1)</script> \"ü\" \x01\x1b[31m \xff\xc3", 1);
  row.state = State::failed;
  row.reason = "<!--<script> & \xf0\x9f\x92\xa1 \xed\xa0\x80";
  row.messages = {"]]></script>", std::string("nul\0byte", 8)};
  row.command = {"lentray", "</script>"};
  row.left_out = {"<b>"};
  row.seen.files["/a/</script>"] = {};
  PageOptions with = options();
  with.title = "<script>&\"\x07\xff";
  const std::string text = page({row}, with);
  const json data = data_of(text);
  EXPECT_EQ(data["cards"][0]["name"],
            "</script><script>alert(1)</script> \"ü\" \x01\x1b[31m \xEE\xBF\xBF\xEE\xBF\x83")
      << "a byte b that is no UTF-8 is U+EF00 + b";
  EXPECT_EQ(data["rows"][0]["messages"][1], std::string("nul\0byte", 8));
  EXPECT_NE(text.find("<title>&lt;script&gt;&amp;&quot; \\xff</title>"), std::string::npos);
  std::size_t scripts = 0;
  for (std::size_t at = 0; (at = text.find("<script", at)) != std::string::npos; ++at) ++scripts;
  EXPECT_EQ(scripts, 2u);
  EXPECT_EQ(text.find("alert(1)</script"), std::string::npos);
}

TEST_F(UnitBatchPageOf, NothingIsLoadedFromElsewhere) {
  const std::string text = page({done("a", 1)}, options());
  for (const char* const mark :
       {"http://", "https://", "//cdn", "@import", "url(", "src=\"", "<link"}) {
    EXPECT_EQ(text.find(mark), std::string::npos) << mark;
  }
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(text.find("{{"), std::string::npos);
}

TEST_F(UnitBatchPageOf, PictureTimesAndMessages) {
  Row row = shown("a/b",
                  columns(40, 30,
                          [](std::uint32_t) {
                            return Colour{200, 40, 90};
                          }),
                  "p/a b.png");
  row.messages = {"a.pov:3: warning: x"};
  row.warnings = 1;
  row.rendering = 0.123456;
  row.memory = 5000;
  row.views = {"v 1.png"};
  row.seen.files["/x/colors.inc"] = {1};
  row.seen.missing = {"/x/none.inc"};
  const json all = data({row}), one = all["rows"][0];
  const StoredImage small = decoded(one["picture"]);
  EXPECT_EQ(small.width, 40u);
  EXPECT_NEAR(small.at(20, 15, 0), 200, 4);
  EXPECT_EQ(one["href"], "./p/a%20b.png");
  EXPECT_EQ(one["shown"], true);
  EXPECT_EQ(one["views"][0], "./v%201.png");
  EXPECT_EQ(one["rendering"], 0.1235);
  EXPECT_EQ(one["memory"], 5000);
  EXPECT_EQ(all["paths"][one["files"][0].get<int>()], "/x/colors.inc");
  EXPECT_EQ(all["paths"][one["missing"][0].get<int>()], "/x/none.inc");
  EXPECT_EQ(all["summary"]["warned"], 1);
  EXPECT_FALSE(one.contains("tilt"));
  EXPECT_FALSE(one.contains("verdict"));
}

TEST_F(UnitBatchPageOf, FailedAndSkippedRows) {
  Row failed = done("a", 0), skipped = done("b", 0);
  failed.state = State::failed;
  failed.reason = "a.pov:1:1: error";
  failed.status = 139;
  skipped.state = State::skipped;
  const json all = data({failed, skipped});
  EXPECT_EQ(all["rows"][0]["reason"], "a.pov:1:1: error");
  EXPECT_EQ(all["rows"][0]["status"], 139);
  EXPECT_EQ(all["cards"][1]["state"], "skipped");
  EXPECT_EQ(all["summary"]["failed"], 1);
  EXPECT_EQ(all["summary"]["skipped"], 1);
}

TEST_F(UnitBatchPageOf, MissingAndBrokenPicturesSayWhy) {
  Row gone = done("gone", 1), broken = done("broken", 1), folder = done("folder", 1);
  gone.picture = "gone.png";
  broken.picture = "broken.png";
  folder.picture = "folder.png";
  broken.verdict = graded("exact", "none.png", "broken.png");
  tool::write_text(m_folder / "broken.png", "\x89PNG\r\n\x1a\nand no more");
  fs::create_directory(m_folder / "folder.png");
  const json all = data({gone, broken, folder});
  for (const json& row : all["rows"]) {
    EXPECT_FALSE(row.contains("picture"));
    EXPECT_FALSE(row["problem"].get<std::string>().empty());
  }
  EXPECT_EQ(all["rows"][1]["verdict"]["stock"], "./none.png");
  EXPECT_FALSE(all["rows"][1]["verdict"].contains("stock_picture"));
}

TEST_F(UnitBatchPageOf, ViewsGoFromTheLeftEyeToTheRight) {
  // Whole and fractional N: the colour tells the place in the lens.
  for (const double n : {5.0, 4.5}) {
    const StoredImage sheet = columns(90, 64, [n](std::uint32_t x) {
      return Colour{std::min(255, int(std::fmod(x + 0.5, n) / n * 250)), 60, 60};
    });
    Row row = shown("a", sheet, "sheet.png");
    row.lens_pixels = n;
    const json one = data({row})["rows"][0];
    const StoredImage middle = decoded(one["picture"]), tilt = decoded(one["tilt"]);
    const int count = one["tilt_views"];
    EXPECT_EQ(count, int(n));
    EXPECT_EQ(tilt.height % static_cast<unsigned>(count), 0u);
    const std::uint32_t height = tilt.height / static_cast<unsigned>(count);
    EXPECT_EQ(height % 16, 0u);
    EXPECT_EQ(middle.width, static_cast<std::uint32_t>(90 / n));
    EXPECT_NEAR(middle.at(5, 20, 0), 125, 30);
    EXPECT_GT(tilt.at(5, height / 2, 0), 190);  // the last column is what the left eye sees
    EXPECT_LT(tilt.at(5, tilt.height - height / 2, 0), 60);
  }
}

TEST_F(UnitBatchPageOf, ComparisonsAndTheirPictures) {
  Row row = shown("a", noise(40, 30, 1), "a.png");
  shown("s", noise(40, 30, 2), "s.png");
  shown("d", noise(40, 30, 3), "d.png");
  row.verdict = graded("match", "s.png", "d.png", 6.0);
  row.verdict->psnr = 44.5;
  row.verdict->lens_grades = {{"exact", 3}};
  row.verdict->block_rms = 0.5;
  row.verdict->noise_rms = 0.25;
  row.verdict->noise_cpu = 9.5;
  Row none = done("none", 1);
  none.state = State::failed;
  none.verdict = graded("fails", "s.png", "");
  const json all = data({row, none}), v = all["rows"][0]["verdict"];
  EXPECT_EQ(v["ratio"], 6.0);
  EXPECT_EQ(v["psnr"], 44.5);
  EXPECT_EQ(v["block_rms"], 0.5);
  EXPECT_EQ(v["noise_rms"], 0.25);
  EXPECT_EQ(v["noise_bias"], 0.0);
  EXPECT_EQ(v["noise_cpu"], 9.5);
  EXPECT_FALSE(all["rows"][1]["verdict"].contains("noise_rms"));
  EXPECT_EQ(v["lens_grades"]["exact"], 3);
  EXPECT_EQ(decoded(v["stock_picture"]).width, 40u);
  EXPECT_EQ(decoded(v["difference_picture"]).width, 40u);
  EXPECT_TRUE(all["rows"][1]["verdict"].contains("stock_picture"))
      << "stock's picture stands where ours failed";
  EXPECT_EQ(all["summary"]["differing"], 1);
}

TEST_F(UnitBatchPageOf, AnAnimationShowsAtMostSixtyFrames) {
  std::vector<Row> rows;
  const Row first = shown("f", noise(16, 16, 1), "f.png");
  for (int i = 1; i <= 200; ++i) {
    rows.push_back(first);
    rows.back().name = "f#" + std::to_string(i);
    rows.back().frame = i;
  }
  const json all = data(rows);
  EXPECT_EQ(all["cards"].size(), 1u);
  int count = 0;
  for (const json& row : all["rows"]) count += row.contains("picture");
  EXPECT_EQ(count, 60);
  EXPECT_TRUE(all["rows"][0].contains("picture"));
  EXPECT_TRUE(all["rows"][199].contains("picture"));
}

TEST_F(UnitBatchPageOf, SmallPicturesAreKeptAndForgotten) {
  Row row = shown("a", noise(40, 30, 1), "a.png");
  const std::string first = page({row}, options());
  const auto files = kept();
  ASSERT_EQ(files.size(), 1u);
  // What is kept is what is shown.
  const std::string other = core::jpeg_of(core::thumbnail_of(noise(40, 30, 9), {40, 30}), 50);
  std::ofstream(*files.begin(), std::ios::binary) << other;
  EXPECT_EQ(data({row})["rows"][0]["picture"], base64(other));
  // Half a file is none.
  std::ofstream(*files.begin(), std::ios::binary) << other.substr(0, 300);
  EXPECT_EQ(page({row}, options()), first);
  // A new picture is a new one, and the old one goes.
  core::write_stored(noise(40, 30, 2), m_folder / "a.png");
  fs::last_write_time(m_folder / "a.png",
                      fs::file_time_type::clock::now() + std::chrono::seconds(5));
  EXPECT_NE(page({row}, options()), first);
  EXPECT_EQ(kept().size(), 1u);
  EXPECT_NE(kept(), files);
}

TEST_F(UnitBatchPageOf, WhereNothingCanBeKeptItIsMadeAgain) {
  Row row = shown("a", noise(40, 30, 1), "a.png");
  tool::write_text(m_folder / ".lentray-batch", "in the way");
  EXPECT_TRUE(data({row})["rows"][0].contains("picture"));
}

class UnitBatchPageSize : public UnitBatchPageOf {
 protected:
  /// Noise, the worst that JPEG can get, as integral images with comparisons; long messages.
  std::vector<Row> rows(std::size_t count, std::uint32_t width, std::uint32_t height,
                        std::size_t lines) {
    constexpr std::size_t kFiles = 24;
    std::vector<Row> all;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string file = "n" + std::to_string(i % kFiles) + ".png";
      if (i < kFiles) m_pictures.push_back(shown("n", noise(width, height, unsigned(i)), file));
      Row row = m_pictures[i % kFiles];
      row.name = "set/scene number " + std::to_string(i);
      row.lens_pixels = 15.0;
      row.verdict = graded("match", file, file);
      row.messages.assign(lines, "scene.pov:12: warning: <" + std::string(100, 'x') + ">");
      for (int k = 0; k < 20; ++k)
        row.seen.files["/usr/share/include/" + std::to_string(k) + ".inc"] = {};
      all.push_back(std::move(row));
    }
    return all;
  }
  std::vector<Row> m_pictures;
};

TEST_F(UnitBatchPageSize, FourHundredScenes) {
  const std::string text = page(rows(400, 320, 240, 10), options());
  EXPECT_LE(text.size(), 20'000'000u);
  EXPECT_GT(text.size(), 8'000'000u) << "room is used";
  const json data = data_of(text);
  for (const json& row : data["rows"]) {
    ASSERT_TRUE(row.contains("picture") && row.contains("tilt") &&
                row["verdict"].contains("stock_picture"));
  }
  RecordProperty("bytes", std::to_string(text.size()));
}

TEST_F(UnitBatchPageSize, TwoThousandScenes) {
  const std::string text = page(rows(2000, 320, 240, 10), options());
  EXPECT_LE(text.size(), 20'000'000u);
  EXPECT_TRUE(data_of(text)["rows"][1999].contains("picture"));
}

TEST_F(UnitBatchPageSize, SmallBudgets) {
  for (const std::size_t most : {200'000u, 1'000'000u, 3'000'000u}) {
    PageOptions with = options();
    with.most_bytes = most;
    EXPECT_LE(page(rows(300, 64, 48, 200), with).size(), most);
  }
  // Text alone is too much: failed rows stay, the page tells how many there were.
  std::vector<Row> many(4000, done("a", 1));
  many.back().state = State::failed;
  PageOptions with = options();
  with.most_bytes = 150'000;
  const std::string text = page(many, with);
  EXPECT_LE(text.size(), with.most_bytes);
  EXPECT_EQ(data_of(text)["summary"]["all_rows"], 4000);
  EXPECT_EQ(data_of(text)["summary"]["failed"], 1);
}

TEST_F(UnitBatchPageSize, SizesDoNotChangeWhileABatchGrows) {
  const std::vector<Row> all = rows(200, 320, 240, 5);
  PageOptions with = options();
  with.most_bytes = 4'000'000;
  with.expected_rows = all.size();
  std::vector<Row> waiting(all);
  for (std::size_t i = 20; i < waiting.size(); ++i) {
    waiting[i] = done(all[i].name, 0.0);
    waiting[i].state = State::waiting;
  }
  const json whole = data_of(page(all, with));
  const json begun = data_of(page({all.begin(), all.begin() + 20}, with));
  EXPECT_EQ(begun["rows"][3]["picture"], whole["rows"][3]["picture"]);
  EXPECT_EQ(data_of(page(waiting, with))["rows"][3]["picture"], whole["rows"][3]["picture"]);
  EXPECT_EQ(begun["rows"][3]["tilt"], whole["rows"][3]["tilt"]);
}

// --- for tests/batch/page_in_browser.py, which looks at the page in a browser

class UnitBatchPageForBrowser : public UnitBatchPageOf {};

TEST_F(UnitBatchPageForBrowser, Write) {
  std::vector<Row> rows;
  const auto plain = [](int shade) {
    return columns(160, 120, [=](std::uint32_t x) { return Colour{shade, int(x), 90}; });
  };
  const auto lens = [](std::uint32_t x) { return Colour{int(x % 5) * 40 + 40, 90, 90}; };
  rows.push_back(shown("plain/first scene", plain(200), "pictures/first scene.png"));
  rows.back().messages = {"first.pov:3: warning: dull", "Rendered."};
  rows.back().warnings = 1;
  rows.back().command = {"lentray", "first scene.pov", "+W160", "it's"};
  rows.back().seen.files["/scenes/plain/first scene.pov"] = {};
  // Five views of one colour each: red is 40 j + 40.
  rows.push_back(shown("lens/five", columns(400, 300, lens), "pictures/five.png"));
  rows.back().lens_pixels = 5.0;
  rows.push_back(shown("lens/tall", columns(90, 300, lens), "pictures/tall.png"));
  rows.back().lens_pixels = 4.5;
  rows.back().warnings = 2;
  rows.back().kinds = {{"jumps", "the <b>background</b> moves by 3.1 pixels a view"}};
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    rows.push_back(
        shown("moving/film#" + number, plain(60 * i), "pictures/film" + number + ".png"));
    rows.back().frame = i;
  }
  rows.push_back(shown("compared/one", plain(10), "pictures/one.png"));
  shown("", plain(20), "stock/one.png");
  shown("", plain(0), "difference/one.png");
  rows.back().verdict = graded("differs", "stock/one.png", "difference/one.png", 7.0);
  rows.back().verdict->psnr = 31.2;
  rows.back().verdict->beyond_1 = 0.02;
  rows.back().verdict->largest = 20.0;
  rows.back().left_out = {"media"};
  Row bad = done("bad/<img src=x onerror=\"window.harm=1\"></script>", 0.0);
  bad.state = State::failed;
  bad.reason = "<script>window.harm=2</script> is no scene " + std::string(300, 'w');
  rows.push_back(bad);
  rows.push_back(done("old/same", 0.0));
  rows.back().state = State::skipped;
  rows.push_back(done("plain/later", 0.0));
  rows.back().state = State::waiting;
  rows.back().reason = "not rendered yet";
  rows.push_back(shown("plain/slow", plain(120), "pictures/slow.png"));
  rows.back().wall = 300.0;
  rows.push_back(done("plain/gone", 1.0));
  rows.back().picture = "pictures/gone.png";
  PageOptions with = options();
  with.title = "Scenes <of> a test";
  with.wall = 320;
  with.stage = PageOptions::Stage::stopped;
  with.expected_rows = rows.size();
  tool::write_text(m_folder / "index.html", page(rows, with));
  const char* const to = std::getenv("LENTRAY_PAGE_FOLDER");
  if (to)
    fs::copy(m_folder / ".", to,
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

}  // namespace
}  // namespace lentray::batch
