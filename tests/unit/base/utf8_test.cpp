// Names that are no UTF-8 in texts that must be, and back.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "parser/base/shown.h"
#include "parser/base/utf8.h"
#include "tools/common/companion.h"
#include "tools/common/json_text.h"

namespace lentray {
namespace {

using nlohmann::json;
using parser::bytes_of_utf8;
using parser::utf8_of_bytes;

bool is_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = parser::utf8_length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

TEST(UnitUtf8, WhatIsUtf8StaysAsItIs) {
  for (const char* text :
       {"", "scene.pov",
        "\xC3\x9C"
        "berblick",
        "a\nb\\c\"", "\xE2\x80\xAE", "\xF0\x9F\x98\x80", "\xEE\xBC\x80", "\xEF\xBF\xBD"}) {
    EXPECT_EQ(utf8_of_bytes(text), text);
    EXPECT_EQ(bytes_of_utf8(text), text);
  }
}

TEST(UnitUtf8, EveryOtherByteHasACharacter) {
  EXPECT_EQ(utf8_of_bytes("caf\xE9"), "caf\xEE\xBF\xA9");  // U+EFE9
  for (const char* none :
       {"\x80", "\xFF", "\xC0\x80", "\xE2\x82", "\xED\xA0\x80", "\xF5\x80\x80\x80",
        "\xF0\x80\x80\x80", "a\xE9z", "\xEE\xBE\x80", "\xEE\xBF\xBF"}) {
    const std::string text = utf8_of_bytes(none);
    EXPECT_NE(text, none);
    EXPECT_TRUE(is_utf8(text));
    EXPECT_EQ(bytes_of_utf8(text), none);
  }
}

TEST(UnitUtf8, NoTwoNamesHaveOneText) {
  std::mt19937 random(1);
  const std::string letters = "a\x80\xC3\xA9\xEE\xBE\xBF\xE2\x82\xFF";
  std::set<std::string> names, texts;
  for (int i = 0; i < 20000; ++i) {
    std::string name;
    for (unsigned k = random() % 7; k > 0; --k) name += letters[random() % letters.size()];
    const std::string text = utf8_of_bytes(name);
    EXPECT_TRUE(is_utf8(text));
    EXPECT_EQ(bytes_of_utf8(text), name);
    names.insert(name);
    texts.insert(text);
  }
  EXPECT_EQ(names.size(), texts.size());
}

TEST(UnitUtf8, JsonOfAnyBytesComesBack) {
  const json all{{"caf\xE9", {1, "\xFF\xFE", {{"deep\x9B", "\xEE\xBE\x80"}}}}, {"plain", nullptr}};
  for (const bool ascii : {false, true}) {
    const std::string text = tool::json_text(all, 1, ascii);
    EXPECT_FALSE(json::parse(text, nullptr, false).is_discarded());
    EXPECT_EQ(tool::parse_json(text), all);
    EXPECT_EQ(tool::json_if_any(text), all);
  }
  EXPECT_TRUE(tool::json_if_any("{").is_discarded());
  EXPECT_THROW(tool::parse_json("{"), json::exception);
}

TEST(UnitUtf8, MessagesShowBytesAndMarksOfDirection) {
  EXPECT_EQ(parser::shown_name("caf\xE9 \x9B"
                               "31m \xC3\xA9"),
            "caf\\xe9 \\x9b31m \xC3\xA9");
  EXPECT_EQ(parser::shown_text("\xE2\x80\xAEgnp.\xE2\x81\xA6"), "\\u202egnp.\\u2066");
  EXPECT_EQ(parser::shown_bytes("\xE9\n\xC3\xA9"), "\\xe9\n\xC3\xA9");
  const parser::ShownLine line = parser::shown_line("\xE9\x9B\xE2\x80\xAE#", 6);
  EXPECT_EQ(line.line, "???#");
  EXPECT_EQ(line.indent.size(), 3u);
}

TEST(UnitUtf8, LongNamesHaveCompanions) {
  const std::string end = ".lentray-state";
  EXPECT_EQ(tool::journal_path("folder/a.png"), "folder/a.png" + end);
  const std::string one = "f/" + std::string(246, 'x') + ".png", two = one + "g";
  for (const std::string& name : {one, two}) {
    const std::string path = tool::journal_path(name);
    EXPECT_LE(path.size() - 2, 255u);
    EXPECT_TRUE(path.starts_with("f/xxx") && path.ends_with(end)) << path;
  }
  EXPECT_NE(tool::journal_path(one), tool::journal_path(two));
}

}  // namespace
}  // namespace lentray
