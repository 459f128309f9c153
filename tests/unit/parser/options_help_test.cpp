// --help and --help=all against the table of options: nothing is left out, nothing is made up.
#include "parser/options/options_help.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "parser/options/ini.h"
#include "parser/options/options_table.h"

namespace lentray::parser {
namespace {

const OptionRow* row_named(std::string_view name) {
  for (const OptionRow& row : option_table()) {
    if (same_word(row.name, name)) return &row;
  }
  return nullptr;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

TEST(UnitOptionsHelp, EveryOptionHasItsLinesOnce) {
  std::multiset<std::string> told;
  for (const OptionGroup& group : option_groups()) {
    for (const OptionHelp& row : group.rows) told.emplace(row.name);
  }
  for (const OptionRow& row : option_table())
    EXPECT_EQ(told.count(std::string(row.name)), 1u) << row.name;
}

TEST(UnitOptionsHelp, WhatIsToldIsThere) {
  for (const OptionGroup& group : option_groups()) {
    for (const OptionHelp& help : group.rows) {
      if (help.name.starts_with("--")) continue;
      const OptionRow* row = row_named(help.name);
      ASSERT_NE(row, nullptr) << help.name;
      const std::string forms = option_forms(help);
      EXPECT_TRUE(forms.starts_with(std::string(help.name) + "=")) << forms;
      const bool has_switch = !row->switch_name.empty();
      EXPECT_EQ(forms.find(", +" + std::string(row->switch_name)) != std::string::npos, has_switch)
          << forms;
    }
  }
  EXPECT_EQ(option_forms({"Width", "n", "", ""}), "Width=n, +Wn");
  EXPECT_EQ(option_forms({"Output_Alpha", "on|off", "", ""}), "Output_Alpha=on|off, +UA, -UA");
  EXPECT_EQ(option_forms({"Lens_Pitch", "mm", "", ""}), "Lens_Pitch=mm");
}

/// docs/options.md, which a slow test writes, has every option of stock's in at least one line.
TEST(UnitOptionsHelp, EveryOptionOfStocksIsComparedWithStock) {
  std::ifstream file(std::string(LENTRAY_SOURCE_DIR) + "/docs/options.md");
  std::ostringstream document;
  document << file.rdbuf();
  ASSERT_TRUE(file);
  const std::string text = document.str();
  bool own = false;
  for (const OptionRow& row : option_table()) {
    own = own || row.name == "Restrict_IO";  // ours from here on, but for Light_Buffer
    if (row.name == "Antialias_Angle" || row.name == "Antialias_Grid" ||
        (own && row.switch_name.empty()))
      continue;
    const bool named = text.find(std::string(row.name) + "=") != text.npos;
    const bool switched =
        !row.switch_name.empty() && (text.find("+" + std::string(row.switch_name)) != text.npos ||
                                     text.find("-" + std::string(row.switch_name)) != text.npos);
    EXPECT_TRUE(named || switched) << row.name;
  }
}

/// Names in front of a = and switches of the short help.
TEST(UnitOptionsHelp, TheShortHelpFitsAScreenAndTellsWhatIsThere) {
  const auto all = lines(help_text());
  EXPECT_GE(all.size(), 18u);
  EXPECT_LE(all.size(), 23u);  // and the prompt
  for (const std::string& line : all) EXPECT_LE(line.size(), 79u) << line;
  for (const std::string& line : all) {
    if (!line.starts_with("  ")) continue;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (const std::size_t at = word.find('=');
          at != std::string::npos && at > 0 && !word.starts_with("--")) {
        EXPECT_NE(row_named(word.substr(0, at)), nullptr) << word;
      }
    }
  }
}

TEST(UnitOptionsHelp, TheLongHelpIsWrappedAndWhole) {
  const std::string text = full_help_text();
  for (const std::string& line : lines(text)) {
    // One list of words is longer than a line.
    if (!line.starts_with("  Pixel_Order=")) {
      EXPECT_LE(line.size(), 79u) << line;
    }
  }
  for (const OptionGroup& group : option_groups()) {
    for (const OptionHelp& help : group.rows)
      EXPECT_NE(text.find("\n  " + option_forms(help) + "\n"), std::string::npos) << help.name;
  }
}

}  // namespace
}  // namespace lentray::parser
