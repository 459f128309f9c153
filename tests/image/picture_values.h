// Values that functions of pictures have, as numbers: written by a program for stock and for lentray.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {

using Files = std::vector<std::pair<std::string, std::string>>;

/// The program begins with this, behind its #version.
inline const char* const kOpenValues = "\n#fopen OUT \"values.txt\" write\n";

/// What a program writes with #write(OUT, ...), or its complaint.
inline std::string written(bool stock, const std::string& sdl, const Files& files) {
  const tool::TemporaryFolder folder;
  for (const auto& [name, contents] : files) tool::write_text(folder / name, contents);
  tool::write_text(folder / "scene.pov", sdl);
  const tool::RunResult run =
      stock ? tool::run_program({"povray", "+Iscene.pov", "-F", "+W4", "+H4", "-D"}, folder.path(),
                                60.0)
            : run_lentray({"scene.pov", "-F", "+W4", "+H4"}, folder.path());
  return run.status == 0 ? tool::read_text(folder / "values.txt") : "FAILED\n" + run.output;
}

/// The same words, numbers but for the last bits of a single one.
inline void expect_same_values(const std::string& sdl, const Files& files) {
  const std::string wanted = written(true, sdl, files), found = written(false, sdl, files);
  EXPECT_FALSE(wanted.starts_with("FAILED")) << wanted;
  EXPECT_FALSE(wanted.empty());
  std::istringstream ours(found), stock(wanted);
  std::string about, word, wanted_word;
  while (stock >> wanted_word) {
    ASSERT_TRUE(ours >> word) << found;
    if (wanted_word[0] >= 'a') about = wanted_word;
    if (wanted_word == word) continue;
    const double value = std::stod(wanted_word);
    EXPECT_NEAR(std::stod(word), value, 1e-6 * std::max(1.0, value))
        << about << " in " << sdl.substr(0, 90);
  }
}

constexpr int kValueColumns = 8;

/// SDL that writes what a function F(x, y, z) has at the middles of eight columns.
inline std::string values(const std::string& function, const std::string& name,
                          const std::string& value) {
  const std::string columns = std::to_string(kValueColumns);
  return "#declare " + name + " = function { " + function + " }\n#local I = 0; #while (I < " +
         columns + ") #local C = " + name + "((I+.5)/" + columns + ", .5, 0); #write(OUT, " +
         value + ", \"\\n\") #local I = I + 1; #end\n";
}

/// The picture's colours, greys and the greys of its colours. `image`: file and words; `number` is one more each time.
inline std::string picture_values(const std::string& image, int number) {
  const std::string n = std::to_string(number);
  return values("pigment { image_map { " + image + " } }", "C" + n, "vstr(5, C, \" \", 0, 9)") +
         values("pattern { image_pattern { " + image + " } }", "P" + n, "str(C, 0, 9)") +
         values("pattern { pigment_pattern { image_map { " + image + " } } }", "G" + n,
                "str(C, 0, 9)");
}

}  // namespace lentray::test
