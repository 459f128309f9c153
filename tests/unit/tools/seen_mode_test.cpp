// lentray-diff --seen: its words, what files say of their sheets, what is refused, and what is
// written.
#include "tools/lentray-diff/seen_mode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/image/picture_encoder.h"
#include "core/image/reader.h"
#include "core/image/run_files.h"
#include "parser/options/ini.h"
#include "tools/common/process.h"
#include "tools/lentray-diff/arguments.h"
#include "tools/lentray-diff/eye_measure.h"
#include "tools/lentray-diff/seen_sheet.h"

namespace lentray::diff {
namespace {

namespace fs = std::filesystem;
using core::StoredImage;
using SeenFields = std::map<std::string, std::string>;

const SeenFields kSeenFacts{{"lens.pixels", "7.5"},          {"lens.lenses", "8"},
                            {"lens.pitch_mm", "0.635"},      {"lens.view_distance_mm", "400"},
                            {"lens.print_dpi_x", "300"},     {"lens.print_dpi_y", "600"},
                            {"lens.sheet_width_mm", "5.08"}, {"lens.sheet_height_mm", "1.27"}};

SeenFields seen_facts_with(const std::string& name, const std::string& value) {
  SeenFields out = kSeenFacts;
  out[name] = value;
  return out;
}

/// 60 x 30 pixels, sRGB, grey that changes with the row.
StoredImage seen_mode_picture(const SeenFields& facts, int add = 0) {
  StoredImage out = core::black_rgb(60, 30, 8);
  for (std::uint32_t y = 0; y < out.height; ++y) {
    for (std::uint32_t x = 0; x < out.width; ++x) {
      for (int c = 0; c < 3; ++c) out.at(x, y, c) = static_cast<float>(90 + 2 * (y % 20) + add);
    }
  }
  for (const auto& [name, value] : facts) out.attributes["lentray:" + name] = value;
  return out;
}

std::string seen_refusal(const SeenFields& facts, const std::vector<std::string>& words = {}) {
  std::vector<std::string> all{"--seen", "a.png", "b.png"};
  all.insert(all.end(), words.begin(), words.end());
  try {
    seen_sheet_of(seen_mode_picture(facts), parse_seen_arguments(all), "a.png");
  } catch (const core::ImageError& error) {
    return error.what();
  }
  return {};
}

TEST(UnitSeenMode, WordsAreTaken) {
  const Arguments all = parse_arguments(
      {"--seen", "a.png", "b.exr", "--out", "there", "--json=f.json", "--lens-pixels", "15.02",
       "--dpi", "1440x720", "--view-distance", "40cm", "--arc-minutes=0.7"});
  ASSERT_TRUE(all.seen);
  EXPECT_EQ(all.seen->pictures, (std::vector<fs::path>{"a.png", "b.exr"}));
  EXPECT_EQ(all.seen->out, "there");
  EXPECT_EQ(all.seen->json, "f.json");
  EXPECT_EQ(all.seen->arc_minutes, 0.7);
  const SeenSheet sheet = seen_sheet_of(seen_mode_picture({}), *all.seen, "a.png");
  EXPECT_EQ(sheet.lenses.pixels, 15.02);
  EXPECT_EQ(sheet.eye.rows_an_inch, 720.0);
  EXPECT_EQ(sheet.columns_an_inch, 1440.0);
  EXPECT_EQ(sheet.eye.distance, 400.0);
  EXPECT_EQ(sheet.eye.arc_minutes, 0.7);
  EXPECT_FALSE(parse_arguments({"a.png", "b.png"}).seen);
}

TEST(UnitSeenMode, WordsThatCannotBeMeantAreRefused) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--seen", "a.png"},
        {"--seen", "a.png", "b.png", "c.png"},
        {"--seen", "a.png", "b.png", "--grade", "exact"},
        {"--seen", "a.png", "b.png", "--arc-minutes", "0"},
        {"--seen", "a.png", "b.png", "--arc-minutes", "61"},
        {"--seen", "a.png", "b.png", "--view-distance", "inf"},
        {"--seen", "a.png", "b.png", "--dpi", "600x"},
        {"--seen", "a.png", "b.png", "--lens-pixels", "0.5"}}) {
    EXPECT_THROW(parse_arguments(words), parser::OptionError) << words.back();
  }
}

TEST(UnitSeenMode, FilesSayTheirSheets) {
  const SeenArguments arguments = parse_seen_arguments({"--seen", "a.png", "b.png"});
  const SeenSheet sheet = seen_sheet_of(seen_mode_picture(kSeenFacts), arguments, "a.png");
  EXPECT_EQ(sheet.lenses.pixels, 7.5);
  EXPECT_TRUE(sheet.lenses.origins.empty());
  EXPECT_EQ(sheet.eye.rows_an_inch, 600.0);
  EXPECT_EQ(sheet.columns_an_inch, 300.0);
  EXPECT_EQ(sheet.eye.distance, 400.0);
  EXPECT_EQ(sheet.eye.arc_minutes, 1.0);
  SeenFields square = kSeenFacts;
  square.erase("lens.print_dpi_x");
  square.erase("lens.print_dpi_y");
  square["lens.print_dpi"] = "450";
  EXPECT_EQ(seen_sheet_of(seen_mode_picture(square), arguments, "a.png").eye.rows_an_inch, 450.0);
}

TEST(UnitSeenMode, SlantedLensesMoveWithTheRows) {
  const SeenArguments arguments = parse_seen_arguments({"--seen", "a.png", "b.png"});
  const SeenFields facts = seen_facts_with("lens.slant_deg", "45");
  const auto origins = seen_sheet_of(seen_mode_picture(facts), arguments, "a.png").lenses.origins;
  ASSERT_EQ(origins.size(), 30u);
  // A row is 1.27/30 mm high, and at 45 degrees the lens moves as far to the left: of 0.635 mm
  // across the lenses, 7.5 columns along a row take 0.898 mm.
  const double step = 1.27 / 30.0 * 7.5 / (0.635 * std::sqrt(2.0));
  for (std::size_t row = 0; row < origins.size(); ++row) {
    EXPECT_NEAR(origins[row], (14.5 - static_cast<double>(row)) * step, 1e-9);
  }
}

TEST(UnitSeenMode, WhatIsNotKnownIsAskedFor) {
  EXPECT_NE(seen_refusal({}).find("--lens-pixels N, --dpi D, --view-distance MM"),
            std::string::npos);
  EXPECT_NE(seen_refusal({}, {"--dpi", "600"}).find("--lens-pixels N, --view-distance MM"),
            std::string::npos);
  EXPECT_EQ(seen_refusal({}, {"--dpi", "600", "--lens-pixels", "15", "--view-distance", "400"}),
            "");
  EXPECT_NE(seen_refusal(seen_facts_with("lens.view_distance_mm", "0")).find("infinite"),
            std::string::npos);
  EXPECT_EQ(seen_refusal(seen_facts_with("lens.view_distance_mm", "0"), {"--view-distance", "400"}),
            "");
  EXPECT_EQ(seen_refusal(kSeenFacts), "");
}

TEST(UnitSeenMode, WhatIsNoWholeSheetIsRefused) {
  EXPECT_NE(seen_refusal(seen_facts_with("lens.view", "3")).find("no integral image"),
            std::string::npos);
  EXPECT_NE(seen_refusal({{"quilt.columns", "8"}}).find("no integral image"), std::string::npos);
  EXPECT_NE(seen_refusal(seen_facts_with("lens.lenses", "9")).find("--lens-pixels"),
            std::string::npos);
  SeenFields slanted = seen_facts_with("lens.slant_deg", "9");
  slanted.erase("lens.sheet_height_mm");
  EXPECT_NE(seen_refusal(slanted).find("slanted"), std::string::npos);
}

TEST(UnitSeenMode, SheetsThatAreNotOfOneKindAreNamed) {
  const SeenArguments arguments = parse_seen_arguments({"--seen", "a.png", "b.png"});
  const auto sheet = [&](const char* name, const char* value) {
    return seen_sheet_of(seen_mode_picture(seen_facts_with(name, value)), arguments, "a.png");
  };
  const SeenSheet own = seen_sheet_of(seen_mode_picture(kSeenFacts), arguments, "a.png");
  EXPECT_EQ(other_sheet(own, own), "");
  EXPECT_EQ(other_sheet(own, sheet("lens.pixels", "7.51")), "7.5 and 7.51 pixels a lens");
  EXPECT_EQ(other_sheet(own, sheet("lens.print_dpi_y", "720")), "600 and 720 rows an inch");
  EXPECT_EQ(other_sheet(own, sheet("lens.view_distance_mm", "300")),
            "400 and 300 mm of viewing distance");
  EXPECT_EQ(other_sheet(own, sheet("lens.slant_deg", "9")), "0 and 9 degrees of slant");
  EXPECT_NE(other_sheet(own, sheet("lens.lenses_lie", "across")), "");
}

class UnitSeenModeFiles : public ::testing::Test {
 protected:
  void TearDown() override { core::forget_run_files(); }

  std::string write(const std::string& name, const StoredImage& image,
                    const SeenFields& facts = kSeenFacts) {
    core::PictureSpec spec;
    spec.type = core::file_type_of(name);
    spec.width = image.width;
    spec.height = image.height;
    spec.bits = image.bits;
    spec.tagged = true;
    for (const auto& [field, value] : facts) {
      spec.metadata.fields.emplace_back("lentray:" + field, value);
    }
    core::write_stored(image, m_folder / name, spec);
    return (m_folder / name).string();
  }
  /// Returns what is said.
  std::string compare(std::vector<std::string> words) {
    core::forget_run_files();  // that it made the pictures
    words.emplace_back("--seen");
    const Arguments arguments = parse_arguments(words);
    testing::internal::CaptureStdout();
    int status = -1;
    try {
      status = compare_seen(*arguments.seen);
    } catch (const std::exception& error) {
      return testing::internal::GetCapturedStdout() + error.what();
    }
    EXPECT_EQ(status, 0);
    return testing::internal::GetCapturedStdout();
  }
  tool::TemporaryFolder m_folder;
};

TEST_F(UnitSeenModeFiles, EqualSheetsDoNotDiffer) {
  const std::string a = write("a.png", seen_mode_picture({})),
                    b = write("b.tif", seen_mode_picture({}));
  EXPECT_EQ(compare({a, b}).find("L* does not differ"), 0u);
}

TEST_F(UnitSeenModeFiles, AnotherGreyIsMeasuredAndWritten) {
  const std::string a = write("a.png", seen_mode_picture({})),
                    b = write("b.png", seen_mode_picture({}, 10));
  const fs::path report = m_folder / "report.json", out = m_folder / "new" / "pictures";
  compare({a, b, "--json", report.string(), "--out", out.string()});
  const auto json = nlohmann::json::parse(tool::read_text(report));
  EXPECT_EQ(json["lens_pixels"], 7.5);
  EXPECT_EQ(json["lenses"], 8);
  EXPECT_EQ(json["rows"], 20);
  EXPECT_EQ(json["parts"].size(), kSeenParts.size());
  EXPECT_EQ(json["parts"][1]["part"], 0.3);
  EXPECT_EQ(json["l_star"]["points"], 5 * 8 * 20);
  // 10 of 255 is 4 L* in the greys of sRGB.
  EXPECT_NEAR(json["l_star"]["rms"].get<double>(), 4.0, 0.2);
  EXPECT_NEAR(json["l_star"]["bias"].get<double>(), 4.0, 0.2);
  EXPECT_NEAR(json["l_star"]["largest"].get<double>(), 4.0, 0.4);
  const StoredImage first = core::read_image(out / "first.png"),
                    second = core::read_image(out / "second.png"),
                    heat = core::read_image(out / "heat.png");
  for (const StoredImage* image : {&first, &second, &heat}) {
    EXPECT_EQ(image->width, 120u);  // twice as many rows an inch as columns
    EXPECT_EQ(image->height, 20u);
  }
  for (std::uint32_t row = 0; row < 10; ++row) {
    EXPECT_NEAR(second.at(64, row, 1) - first.at(64, row, 1), 10.0, 1.0);
    EXPECT_NEAR(heat.at(64, row, 0), 255.0, 30.0);  // yellow
    EXPECT_NEAR(heat.at(64, row, 1), 255.0, 30.0);
    EXPECT_NEAR(heat.at(64, row, 2), 0.0, 10.0);
  }
  EXPECT_NEAR(first.at(64, 5, 0), 90 + 2 * 10, 1.0);  // row 5 of what is seen is row 10
}

TEST_F(UnitSeenModeFiles, LensesThatLieAcrossAreRows) {
  // Upright 30 pixels wide and 60 high; on its side its strips are columns.
  const SeenFields facts = seen_facts_with("lens.lenses_lie", "across");
  StoredImage upright = core::black_rgb(30, 60, 8);
  for (std::uint32_t y = 0; y < 60; ++y) {
    for (std::uint32_t x = 0; x < 30; ++x) {
      for (int c = 0; c < 3; ++c)
        upright.at(x, y, c) = static_cast<float>(50 + 20 * ((2 * y + 1) / 15));
    }
  }
  const std::string a = write("a.png", upright, facts), b = write("b.png", upright, facts);
  const fs::path out = m_folder / "out";
  EXPECT_NE(compare({a, b, "--out", out.string()}).find("of 8 lenses"), std::string::npos);
  const StoredImage seen = core::read_image(out / "first.png");
  EXPECT_EQ(seen.width, 20u);
  EXPECT_EQ(seen.height, 120u);
  for (std::uint32_t lens = 0; lens < 8; ++lens) {
    EXPECT_NEAR(seen.at(9, 15 * lens + 7, 0), 50.0 + 20.0 * lens, 1.0) << lens;
  }
}

TEST_F(UnitSeenModeFiles, WhatDiffersInSizeOrLensIsRefused) {
  const std::string a = write("a.png", seen_mode_picture({})),
                    cut = write("cut.png", core::black_rgb(60, 29, 8)),
                    other = write("other.png", seen_mode_picture({}),
                                  seen_facts_with("lens.print_dpi_y", "720")),
                    bare = write("bare.png", seen_mode_picture({}), {});
  EXPECT_NE(compare({a, cut}).find("60 x 30 and 60 x 29 pixels"), std::string::npos);
  EXPECT_NE(compare({a, other}).find("600 and 720 rows an inch"), std::string::npos);
  EXPECT_NE(compare({a, other, "--dpi", "600"}).find("L* does not differ"), std::string::npos);
  EXPECT_NE(compare({a, bare}).find("'" + bare + "' does not say"), std::string::npos);
  EXPECT_NE(compare({a, a, "--view-distance", "40m"}).find("the eye blends"), std::string::npos);
  const std::string before = tool::read_text(a);
  EXPECT_NE(compare({a, a, "--json", a}).find("this run reads that file"), std::string::npos);
  EXPECT_EQ(tool::read_text(a), before);
}

}  // namespace
}  // namespace lentray::diff
