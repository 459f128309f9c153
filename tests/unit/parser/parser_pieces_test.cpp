// A long text is made tokens in pieces: it says the same in the smallest pieces as in one.
#include <gtest/gtest.h>

#include <filesystem>

#include "parser/dump/scene_json.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

constexpr std::size_t kOne = 1u << 30;

std::string read_in(std::size_t piece_tokens, const std::string& text) {
  ParserOptions options;
  options.piece_tokens = piece_tokens;
  try {
    const SceneText read(text, options);
    return scene_json(read.scene, read.sources()).dump(1);
  } catch (const ParseError& error) {
    return error.what();
  }
}

// Every statement here has commas and braces at which a piece may end.
const char* const kText = R"(
#declare A = array[3] { 1, 2, <1, 2, 3>.y };
#declare B = array[2] { sphere { 0, 1 }, box { -1, 1 pigment { rgb <1, .5, 0> } } }
#macro Ball(P, R) sphere { P, R pigment { rgb R } } #end
#declare T = texture { pigment { checker rgb 1, rgb 0 scale 2 } }
  texture { pigment { rgbt <1, 1, 1, .5> } }
#declare F = function { pattern { bozo } }
#declare V = spline { linear_spline 0, <0, 0, 0>, 1, <1, 2, 3> }
#declare Last = box { 0, 1 } Ball(x*A[0], .2)
#declare C = color rgb <1, 2, 3>/4;
#for (I, 0, 3) object { B[mod(I, 2)] translate I*x rotate <0, 10, 0> } #end
#if (A[1] = 2) union { Ball(0, 1) Ball(y, V(.5).z) texture { T } matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 4, 5> }
#else sphere { 0, 7 } #end
mesh2 { vertex_vectors { 4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <0, 0, 1> }
  face_indices { 2, <0, 1, 2>, <1, 2, 3> } pigment { rgb C } }
prism { linear_sweep linear_spline 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }
lathe { linear_spline 3, <0, 0>, <A[0], 1>, <0, 2> }
blob { threshold .5 sphere { 0, 1, 1 } cylinder { 0, y, .5, 1 } }
intersection { object { Last } plane { y, .5 } texture { T scale <1, 2, 3> } }
light_source { <1, 2, -9>, rgb 1 spotlight radius 3 falloff 5 point_at <0, 0, 0> }
object { Last texture { pigment { gradient x color_map { [0, rgb 0] [1, rgb <1, 1, 0>] } } } }
isosurface { function { x*x + y*y + z*z - 1 + F(x, y, z)*.1 } contained_by { box { -2, 2 } } }
)";

TEST(UnitParserPieces, SayTheSameAsOne) {
  std::string text = kText;
  const std::string whole = read_in(kOne, text);
  EXPECT_NE(whole.find("isosurface"), std::string::npos) << whole;
  EXPECT_EQ(read_in(1, text), whole);
  EXPECT_EQ(read_in(7, text), whole);
}

TEST(UnitParserPieces, MistakesAreFoundWhereTheyAre) {
  for (const char* wrong :
       {"sphere { 0, 1 } }", "#declare X = box { 0, 1 }, ,", "sphere { 0, 1 ", "#end",
        "#if (1) sphere { 0, 1 }", "union { sphere { 0, 1 }, 5 }", "sphere { 0, 1, 2, }",
        "mesh2 { vertex_vectors { 1, <0, 0, 0>, <1", "* 3",
        "#macro M(A, B) box { A, B } #end M(1, )", "#declare Y = 5 sphere { 0, 1 }"}) {
    const std::string text = std::string(kText) + wrong;
    EXPECT_EQ(read_in(1, text), read_in(kOne, text)) << wrong;
  }
}

TEST(UnitParserPieces, ScenesSayTheSame) {
  const std::filesystem::path scenes = std::filesystem::path(LENTRAY_SOURCE_DIR) / "scenes";
  for (const char* name : {"demo.pov", "mosaic.pov", "spd_mount.pov", "spd_rings.pov"}) {
    const auto read = [&](std::size_t piece_tokens) {
      SourceManager sources;
      Diagnostics diagnostics(sources);
      ParserOptions options;
      options.piece_tokens = piece_tokens;
      options.library_paths = {"/usr/share/povray-3.7/include"};
      return scene_json(read_descriptions((scenes / name).string(), sources, diagnostics, options),
                        sources)
          .dump();
    };
    EXPECT_TRUE(read(1) == read(kOne)) << name;
  }
}

}  // namespace
}  // namespace lentray::parser::test
