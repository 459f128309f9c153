// Every recursion of the grammar ends in a message: in the text, where one brace opens behind the
// other, and by names, where each turn of a loop puts what it has into something new.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/fuzz/read_input.h"

namespace lentray::test {
namespace {

std::string all_of(const std::vector<std::string>& messages) {
  std::string all;
  for (const std::string& message : messages) all += message + "\n";
  return all;
}

struct Text {
  const char* before;
  const char* again;  ///< what opens once more
};

TEST(GrammarNesting, TextsEndInAMessage) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "one thread, and more than 7 GB with the thread sanitizer";
#endif
  constexpr int kDeep = 300'000;
  const Text texts[] = {
      {"#declare A = ", "("},
      {"#declare A = ", "-"},
      {"#declare A = ", "!"},
      {"#declare A = ", "<1,"},
      {"#declare A = ", "sin("},
      {"#declare A = ", "array[1] {"},
      {"#declare A = (", "1 ? 1 : "},
      {"#declare A = ", "concat("},
      {"#declare F = function { ", "("},
      {"#declare F = function { ", "-"},
      {"#declare F = function { ", "sin("},
      {"#declare F = ", "function { pigment { function { pattern { "},
      {"#declare A = transform {", "transform {"},
      {"", "#if (1) "},
      {"", "#if (0) "},
      {"", "#while (1) "},
      {"", "#switch (1) #case (1) "},
      {"", "#macro M() "},
      {"", "#declare A = #declare A = "},
      {"", "#debug "},
      {"", "#version "},
      {"", "#include "},
      {"", "#for (A, "},
      {"", "#ifdef ("},
      {"", "#write ("},
      {"", "#default {"},
      {"", "union {"},
      {"", "object {"},
      {"", "light_group {"},
      {"", "sphere { 0, 1 clipped_by {"},
      {"", "sphere { 0, 1 bounded_by {"},
      {"", "light_source { 0 looks_like {"},
      {"", "light_source { 0 projected_through {"},
      {"", "sphere { 0, 1 pigment { object {"},
      {"", "mesh { triangle { x, y, z texture { pigment { object {"},
      {"", "blob { sphere { 0, 1, 1 pigment { object {"},
      {"", "isosurface { function { pigment { object {"},
      {"", "height_field { function 2, 2 { pigment { object {"},
      {"#declare P = ", "pigment { bozo pigment_map { [0 "},
      {"#declare P = pigment {", "pigment_pattern {"},
      {"#declare P = pigment {", "uv_mapping "},
      {"#declare P = pigment {", "checker pigment {"},
      {"#declare P = pigment {", "image_map { function 2, 2 { pigment {"},
      {"#declare N = normal {", "bozo normal_map { [0 "},
      {"#declare N = normal {", "checker normal {"},
      {"#declare T = texture {", "bozo texture_map { [0 "},
      {"#declare T = texture {", "tiles { texture {"},
      {"#declare T = texture {", "checker texture {"},
      {"#declare T = texture {", "material_map { function 2, 2 {x} texture {"},
      {"#version 2.0; #declare T = texture {", "tiles { texture {"},
      {"#declare M = media {", "density { bozo density_map { [0 "},
      {"#declare M = media { density {", "checker density {"},
      {"", "sphere { 0, 1 interior { media { density { object {"},
      {"", "sphere { 0, 1 material { interior { media { density { object {"},
      {"", "sky_sphere { pigment { object { sphere { 0, 1 pigment {"},
      {"camera { normal {", "checker normal {"},
      {"fog {", "transform {"},
  };
  for (const Text& text : texts) {
    std::string program = text.before;
    const std::size_t size = std::string(text.again).size();
    for (int i = 0; i < kDeep && program.size() < 4'000'000; ++i) program += text.again;
    EXPECT_FALSE(read_input(program, {}).empty()) << text.before << text.again << size;
  }
}

TEST(GrammarNesting, NamesEndInAMessage) {
  // What is declared, and what each turn makes of it.
  const std::vector<std::pair<std::string, std::string>> loops = {
      {"sphere { 0, 1 }", "union { object { A } }"},
      {"sphere { 0, 1 }", "sphere { 0, 1 clipped_by { A } }"},
      {"sphere { 0, 1 }", "sphere { 0, 1 bounded_by { A } }"},
      {"sphere { 0, 1 }", "sphere { 0, 1 pigment { object { A } } }"},
      {"sphere { 0, 1 }", "sphere { 0, 1 interior { media { density { object { A } } } } }"},
      {"sphere { 0, 1 }",
       "sphere { 0, 1 texture { pigment { rgb x } } interior_texture { pigment { object { A } } } "
       "}"},
      {"sphere { 0, 1 }", "mesh { triangle { x, y, z texture { pigment { object { A } } } } }"},
      {"sphere { 0, 1 }", "blob { sphere { 0, 1, 1 pigment { object { A } } } }"},
      {"sphere { 0, 1 }", "isosurface { function { pattern { object { A } } } }"},
      {"sphere { 0, 1 }", "height_field { function 2, 2 { pigment { object { A } } } }"},
      {"sphere { 0, 1 }", "light_source { 0 looks_like { A } }"},
      {"sphere { 0, 1 }", "light_source { 0 projected_through { A } }"},
      {"sphere { 0, 1 }",
       "light_source { 0 looks_like { sphere { 0, 1 } pigment { object { A } } } }"},
      {"sphere { 0, 1 }", "light_group { object { A } }"},
      {"pigment { rgb x }", "pigment { bozo pigment_map { [0 A] } }"},
      {"pigment { rgb x }", "pigment { average pigment_map { [1 A] [1 A] } }"},
      {"pigment { rgb x }", "pigment { checker pigment { A } pigment { A } }"},
      {"pigment { rgb x }", "pigment { uv_mapping A }"},
      {"pigment { rgb x }", "pigment { pigment_pattern { A } }"},
      {"pigment { rgb x }", "pigment { function { pigment { A } } }"},
      {"pigment { rgb x }", "pigment { image_map { function 2, 2 { pigment { A } } } }"},
      {"function { pigment { bozo } }", "function { pigment { function { A(x, y, z).x } } }"},
      {"function { pattern { bozo } }",
       "function { pattern { pigment_pattern { average pigment_map { [1 function { A(x, y, z) }] "
       "[1 function { A(x, y, z) }] } } } }"},
      {"normal { bozo }", "normal { bozo normal_map { [0 A] } }"},
      {"normal { bozo }", "normal { average normal_map { [1 A] [1 A] } }"},
      {"normal { bozo }", "normal { checker normal { A } normal { A } }"},
      {"normal { bozo }", "normal { uv_mapping A }"},
      {"texture { pigment { rgb x } }", "texture { bozo texture_map { [0 A] } }"},
      {"texture { pigment { rgb x } }", "texture { average texture_map { [1 A] [1 A] } }"},
      {"texture { pigment { rgb x } }", "texture { tiles { texture { A } tile2 texture { A } } }"},
      {"texture { pigment { rgb x } }", "texture { checker texture { A } texture { A } }"},
      {"texture { pigment { rgb x } }", "texture { A } texture { A }"},
      {"texture { pigment { rgb x } }", "texture { uv_mapping A }"},
      {"density { bozo }", "density { bozo density_map { [0 A] } }"},
      {"density { bozo }", "density { average density_map { [1 A] [1 A] } }"},
      {"density { bozo }", "density { checker density { A } density { A } }"},
      {"pigment_map { [0 rgb x] }", "pigment_map { [0 bozo pigment_map { A }] }"},
      {"normal_map { [0 bozo] }", "normal_map { [0 bozo normal_map { A }] }"},
      {"texture_map { [0 pigment { rgb x }] }", "texture_map { [0 bozo texture_map { A }] }"},
      {"density_map { [0 rgb x] }", "density_map { [0 bozo density_map { A }] }"},
      {"material { texture { pigment { rgb x } } }",
       "material { texture { pigment { object { sphere { 0, 1 material { A } } } } } }"},
  };
  for (const auto& [first, turn] : loops) {
    const std::string program =
        "#declare A = " + first + "\n#while (1) #declare B = " + turn + "\n#declare A = B\n#end";
    const std::string heard = all_of(read_input(program, {}));
    const bool told = heard.find("within each other, more than") != std::string::npos ||
                      heard.find("made of too many others") != std::string::npos ||
                      heard.find("layers") != std::string::npos ||
                      heard.find("functions call functions more than") != std::string::npos ||
                      heard.find("the function makes too many calls") != std::string::npos;
    EXPECT_TRUE(told) << turn << "\n" << heard.substr(0, 300);
  }
}

}  // namespace
}  // namespace lentray::test
