// What messages and the console show of a scene's text.
#include <gtest/gtest.h>

#include "parser/base/shown.h"

namespace lentray::parser::test {
namespace {

TEST(UnitShown, ControlCharactersAreEscaped) {
  EXPECT_EQ(shown_name("a\nb\x1b[2Jc"), "a\\x0ab\\x1b[2Jc");
  EXPECT_EQ(shown_text("a\nb\tc\x1b[31m\x7f\x07"), "a\nb\tc\\x1b[31m\\x7f\\x07");
  EXPECT_EQ(shown_text("10 %\r20 %\b\b"), "10 %\r20 %\b\b");
  EXPECT_EQ(shown_text("gr\xC3\xBC\xC3\x9F \xC2\x9B"
                       "31m"),
            "gr\xC3\xBC\xC3\x9F \\x9b31m");
}

TEST(UnitShown, BytesThatAreControlsOfTerminalsAreEscaped) {
  EXPECT_EQ(shown_text("a\x9b[31m"), "a\\x9b[31m");
  EXPECT_EQ(shown_name("\x80\x85\x9f\xa0"), "\\x80\\x85\\x9f\\xa0");
  EXPECT_EQ(shown_text("\xE0\x82\x9B"), "\\xe0\\x82\\x9b") << "a longer form of it";
  EXPECT_EQ(shown_text("\xE2\x82\xAC \xC3\x9F \xF0\x9F\x98\x80"),
            "\xE2\x82\xAC \xC3\x9F \xF0\x9F\x98\x80");
  EXPECT_EQ(shown_text("caf\xE9 \xE2\x82"), "caf\\xe9 \\xe2\\x82") << "cut off, and Latin-1";
  EXPECT_EQ(shown_line("a\x9b"
                       "b\xE2\x80\xAE"
                       "c",
                       7)
                .line,
            "a?b?c");
}

TEST(UnitShown, TextCannotBeTurnedRound) {
  EXPECT_EQ(shown_text("a\xE2\x80\xAE"
                       "gnp.exe"),
            "a\\u202egnp.exe");
  for (const char* turn :
       {"\xE2\x80\xAA", "\xE2\x80\xAD", "\xE2\x81\xA6", "\xE2\x81\xA9", "\xE2\x80\x8F", "\xD8\x9C"})
    EXPECT_EQ(shown_name(turn).substr(0, 2), "\\u") << turn;
  EXPECT_EQ(shown_text("\xD7\xA9\xD7\x9C"), "\xD7\xA9\xD7\x9C") << "Hebrew itself stays";
}

TEST(UnitShown, LongNamesAndMessagesAreCut) {
  EXPECT_LT(shown_name(std::string(1'000'000, 'x')).size(), 500u);
  EXPECT_LT(shown_message(std::string(50'000'000, 'x')).size(), 4100u);
  EXPECT_EQ(shown_message("short"), "short");
}

TEST(UnitShown, TheCaretStaysUnderItsColumn) {
  const auto at_caret = [](const std::string& line, std::size_t column) {
    const ShownLine shown = shown_line(line, column);
    EXPECT_LT(shown.line.size(), 200u);
    return shown.indent.size() < shown.line.size() ? shown.line[shown.indent.size()] : '\0';
  };
  const std::string line = "sphere {\t0, X }";
  for (std::size_t c = 1; c <= line.size(); ++c) EXPECT_EQ(at_caret(line, c), line[c - 1]) << c;
  EXPECT_EQ(shown_line(line, 12).indent, "        \t  ");
  std::string text(1'000'000, '.');
  for (const std::size_t c : {1ul, 50ul, 150ul, 5000ul, 999'990ul, 1'000'000ul}) {
    text[c - 1] = '#';
    EXPECT_EQ(at_caret(text, c), '#') << c;
    text[c - 1] = '.';
  }
  EXPECT_EQ(shown_line("a\x1b[2Jb", 6).line, "a?[2Jb");
  EXPECT_EQ(shown_line("ab", 9).indent.size(), 2u);
  EXPECT_EQ(shown_line("", 1).line, "");
}

}  // namespace
}  // namespace lentray::parser::test
