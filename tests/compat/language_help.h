// The same SDL by stock POV-Ray and by our front end: what #debug writes.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/unit/parser/parser_text.h"

namespace lentray::test {

inline std::string stock_debug(const std::string& sdl) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", sdl);
  const tool::RunResult run =
      tool::run_program({"povray", "+Iscene.pov", "+Oscene.png", "+W4", "+H4", "-D",
                         "+L/usr/share/povray-3.7/include", "+GDdebug.txt"},
                        folder.path(), 60.0);
  const std::string text = tool::read_text(folder / "debug.txt");
  return run.status == 0 ? text : text + "\nSTOCK FAILED\n" + run.output;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Compares what #debug writes, line by line.
inline void expect_same_debug(const std::string& sdl) {
  parser::ParserOptions options;
  options.image_width = options.image_height = 4;
  const Parsed ours = parse_text(sdl, {}, options);
  EXPECT_EQ(ours.error, "");
  const std::string stock = stock_debug(sdl);
  const auto wanted = lines_of(stock), found = lines_of(ours.debug);
  ASSERT_EQ(found.size(), wanted.size()) << ours.debug << "\nand stock:\n" << stock;
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(found[i], wanted[i]);
}

/// Each string expression written on a line of its own, after its text.
inline void expect_same_strings(const std::string& setup, const std::vector<std::string>& strings) {
  std::string sdl = setup + "\n";
  for (std::size_t i = 0; i < strings.size(); ++i) {
    sdl += "#debug concat(\"" + std::to_string(i) + ": \", " + strings[i] + ", \"\\n\")\n";
  }
  expect_same_debug(sdl);
}

inline std::string number(const std::string& expression) { return "str((" + expression + "),0,9)"; }
inline std::string vector(int size, const std::string& expression) {
  return "vstr(" + std::to_string(size) + "," + expression + ",\" \",0,9)";
}

}  // namespace lentray::test
