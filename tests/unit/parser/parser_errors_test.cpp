// Every message of the interpreter once: its place, its words, what it points at.
#include <gtest/gtest.h>

#include "tests/unit/parser/parser_text.h"

namespace lentray::test {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void expect_error(const Parsed& parsed, const std::string& part, std::uint32_t line) {
  EXPECT_TRUE(has(parsed.message, part)) << "wanted: " << part << "\ngot: " << parsed.error;
  EXPECT_EQ(parsed.where.line, line) << parsed.error;
}

TEST(ErrorParser, UnknownIdentifierWithNearName) {
  const Parsed p = parse_text("#version 3.7;\n#declare Radius = 2;\n#declare B = 3*Radiis;\n");
  expect_error(p, "undeclared identifier 'Radiis', did you mean 'Radius'?", 3);
  EXPECT_EQ(p.where.column, 16u);
  EXPECT_TRUE(has(p.error, "scene.pov:3:16: error: "));
  EXPECT_TRUE(has(p.error, "  #declare B = 3*Radiis;\n                 ^\n")) << p.error;
}

TEST(ErrorParser, MissingBrace) {
  expect_error(parse_text("#version 3.7;\n#declare T = transform { rotate x\n#declare U = 1;\n"),
               "expected '}' but found the end of the scene", 3);
}

TEST(ErrorParser, ExpectedNamesWhatWasFound) {
  expect_error(parse_text("#declare A = (1 + ;\n"),
               "expected a number, vector or identifier of one but found ';'", 1);
  expect_error(parse_text("#declare A = vlength 3;\n"), "expected '(' but found a number", 1);
}

TEST(ErrorParser, MissingInclude) {
  const Parsed p = parse_text("#include \"colors.inc\"\n#include \"nosuch.inc\"\n");
  expect_error(p, "cannot find the include file 'nosuch.inc'", 2);
  EXPECT_TRUE(has(p.message, "/usr/share/povray-3.7/include")) << p.message;
}

TEST(ErrorParser, TheHeaderIsIncludedFromNowhere) {
  parser::ParserOptions options;
  options.include_header = "header";
  const Parsed lacking = parse_text("#debug \"scene\"", {}, options);
  EXPECT_TRUE(has(lacking.message, "cannot find the include file 'header'")) << lacking.error;
  const Parsed bad = parse_text("", {{"header.inc", "#declare A = ;\n"}}, options);
  EXPECT_TRUE(has(bad.error, "header.inc:1:14: error")) << bad.error;
  EXPECT_FALSE(has(bad.error, "included from")) << bad.error;
}

TEST(ErrorParser, NoReservedLetterIsProposed) {
  const Parsed p = parse_text("#declare A = T;\n");
  EXPECT_FALSE(has(p.message, "did you mean")) << p.message;
  EXPECT_TRUE(
      has(parse_text("#declare Red = 1; #declare A = red2;\n").message, "did you mean 'Red'"))
      << p.message;
}

TEST(ErrorParser, AWarningIsGivenAtEightPlacesAtMost) {
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  const std::uint32_t file = sources.add("a.pov", std::string(100, '\n'));
  for (std::uint32_t i = 0; i < 11; ++i) diagnostics.warn({file, i}, "something");
  EXPECT_EQ(diagnostics.warnings().size(), 8u);
  diagnostics.report_repeats();
  ASSERT_EQ(diagnostics.warnings().size(), 9u);
  EXPECT_EQ(diagnostics.warnings().back().message, "at 3 more places: something");
}

TEST(ErrorParser, StackOfIncludesAndMacros) {
  const Parsed p =
      parse_text("#include \"a.inc\"\n",
                 {{"a.inc", "#macro Outer(n)\n  Inner(n*2)\n#end\n#include \"b.inc\"\n"},
                  {"b.inc", "#macro Inner(n)\n  #local q = n + Oops;\n#end\nOuter(1)\n"}});
  expect_error(p, "undeclared identifier 'Oops'", 2);
  EXPECT_TRUE(has(p.error, "b.inc:2:18: error"));
  const std::size_t inner = p.error.find("in macro Inner, invoked from");
  const std::size_t outer = p.error.find("in macro Outer, invoked from");
  const std::size_t second = p.error.find("included from", outer);
  const std::size_t first = p.error.find("included from", second + 1);
  EXPECT_LT(inner, outer);
  EXPECT_LT(outer, second);
  EXPECT_LT(second, first);
  EXPECT_NE(first, std::string::npos) << p.error;
  EXPECT_TRUE(has(p.error, "a.inc:2:3\n")) << p.error;       // where Inner was invoked
  EXPECT_TRUE(has(p.error, "scene.pov:1:10\n")) << p.error;  // where a.inc was included
}

TEST(ErrorParser, UnterminatedComment) {
  expect_error(parse_text("#declare A = 1;\n  /* one /* two */\n"), "comment without its end", 2);
}

TEST(ErrorParser, UnterminatedString) {
  expect_error(parse_text("#declare A = 1;\n#debug \"abc\n"), "string without its end", 2);
}

TEST(ErrorParser, UnknownCharacter) {
  expect_error(parse_text("#declare A = 1;\n\x80\n"), "unknown character 0x80", 2);
}

TEST(ErrorParser, IllegalEscape) {
  expect_error(parse_text("#debug \"a\\qb\""), "escape that does not exist", 1);
}

TEST(ErrorParser, ErrorDirective) {
  expect_error(parse_text("#version 3.7;\n#error concat(\"no\", \" way\")\n"),
               "parse halted by #error: no way", 2);
}

TEST(ErrorParser, MissingEnd) {
  expect_error(parse_text("#declare A=1;\n#if (A)\n#declare B=2;\n"), "#if without its #end", 2);
  expect_error(parse_text("#declare A=0;\n#if (A)\n#declare B=2;\n"), "#if without its #end", 2);
  expect_error(parse_text("#while (1)\n  #break\n"), "#while without its #end", 1);
  expect_error(parse_text("\n#macro M()\n 1\n"), "#macro without its #end", 2);
}

TEST(ErrorParser, StrayParts) {
  expect_error(parse_text("\n#end\n"), "#end without #if", 2);
  expect_error(parse_text("#else\n"), "#else without #if", 1);
  expect_error(parse_text("#case (1)\n"), "#case without #switch", 1);
  expect_error(parse_text("#break\n"), "#break without", 1);
  expect_error(parse_text("#switch (1) 5 #end"), "expected #case or #range", 1);
}

TEST(ErrorParser, UnknownDirective) {
  expect_error(parse_text("#declre A = 1;\n"), "unknown directive #declre, did you mean #declare?",
               1);
}

TEST(ErrorParser, EndlessRecursion) {
  expect_error(parse_text("#macro R(n)\nR(n+1)\n#end\nR(1)\n"), "endless recursion", 2);
  expect_error(parse_text("#macro R(n) (1+R(n)) #end\n#declare A = R(1);\n"), "endless recursion",
               1);
}

TEST(ErrorParser, Subscripts) {
  const std::string array = "#declare A = array[3] {1,2,3}\n";
  expect_error(parse_text(array + "#declare B = A[3];\n"), "array subscript 3 out of range", 2);
  expect_error(parse_text(array + "#declare B = A[-1];\n"), "out of range", 2);
  expect_error(parse_text("#declare A = array[2]\n#declare B = A[1];\n"), "has no value yet", 2);
  expect_error(parse_text("#declare A = array[2] {1}\n"), "value 2 of the array's 2", 1);
  expect_error(parse_text("#declare A = array[0]\n"), "an array cannot have", 1);
}

TEST(ErrorParser, DivisionByZeroWarnsAndIsInfinite) {
  const Parsed p =
      parse_text("#version 3.7;\n#debug str(-1/0,0,0)\n#debug vstr(2,<1,2>/0,\",\",0,0)");
  EXPECT_EQ(p.error, "");
  EXPECT_EQ(p.debug, "infinf,inf");
  ASSERT_EQ(p.warnings.size(), 2u);  // one a place
  EXPECT_EQ(p.warnings[0], "division by zero");
}

TEST(ErrorParser, ArgumentsOutOfDomain) {
  expect_error(parse_text("#declare A = sqrt(-1);"), "sqrt of the negative number", 1);
  expect_error(parse_text("#declare A = ln(0);"), "ln of 0", 1);
  expect_error(parse_text("#declare A = atan2(0,0);"), "atan2(0, 0)", 1);
  expect_error(parse_text("#declare A = rand(0);"), "rand() of a stream", 1);
  expect_error(parse_text("#declare A = substr(\"abc\",2,3);"), "substr()", 1);
  EXPECT_EQ(parse_text("#debug str(acos(1.5),0,1)").debug, "0.0");
}

TEST(ErrorParser, KindsThatDoNotFit) {
  expect_error(parse_text("#declare A = <1,2,3>;\n#declare B = sqrt(A);\n"),
               "expected a float but found a vector", 2);
  expect_error(parse_text("#declare A = <1,2>;\n#declare B = A.z;\n"), ".z of something with 2", 2);
  expect_error(parse_text("#declare S = \"a\";\n#declare B = 1+S;\n"),
               "expected a number, vector or identifier of one but found string 'S'", 2);
  expect_error(parse_text("#debug 5"), "expected a string but found a number", 1);
  expect_error(parse_text("#declare A = <1>;"), "at least 2 components", 1);
  expect_error(parse_text("#declare A = <1,2,3,4,5,6>;"), "'>' after the 5 components", 1);
}

TEST(ErrorParser, ReservedWordDeclared) {
  expect_error(parse_text("#declare sphere = 1;\n"), "reserved word 'sphere'", 1);
}

TEST(ErrorParser, Semicolon) {
  expect_error(parse_text("#version 3.7;\n#declare A = 1\n#declare B = 2;\n"),
               "must end with a semicolon", 2);
  const Parsed old = parse_text(
      "#version 3.1;\n#declare A = 1\n#declare B = A+1\n"
      "#debug str(B,0,0)");
  EXPECT_EQ(old.error, "");
  EXPECT_EQ(old.debug, "2");
  EXPECT_EQ(old.warnings.size(), 2u);
}

TEST(ErrorParser, MacroArguments) {
  expect_error(parse_text("#macro M(a,b) a #end\n#declare A = M(1);\n"),
               "takes 2 arguments, found 1", 2);
  expect_error(parse_text("#macro M(a) a #end\n#declare A = M(1,2);\n"),
               "expected ')' after the 1 arguments of macro M", 2);
}

TEST(ErrorParser, Functions) {
  expect_error(parse_text("#declare f = function { x + Q }\n"),
               "undeclared identifier 'Q' in a function", 1);
  expect_error(parse_text("#declare f = function(a) { a }\n#declare B = f(1,2);\n"),
               "function f takes 1 arguments, found more", 2);
  expect_error(parse_text("#declare f = function(a) { a }\n#declare g = function { f(x,y) }\n"),
               "function f takes 1 arguments, found 2", 2);
  expect_error(parse_text("#declare V = <1,2,3>;\n#declare g = function { x*V }\n"),
               "a function is made of floats", 2);
  expect_error(parse_text("#declare f = function { internal(99) }\n"), "no internal function 99",
               1);
}

TEST(ErrorParser, LoopsThatCannotEnd) {
  expect_error(parse_text("#for (I,1,3,0)\n#end"), "step of zero", 1);
  expect_error(parse_text("#for (I,1,3)\n#undef I\n#end"), "must stay a float", 1);
}

TEST(ErrorParser, ScaleByZeroBecomesOne) {
  const Parsed p = parse_text(
      "#declare f = function { transform { scale <0,2,1> } }\n"
      "#debug vstr(3, f(1,1,1), \",\", 0, 0)");
  EXPECT_EQ(p.debug, "1,2,1");
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0], "scale by 0 along x, changed to 1");
}

TEST(ErrorParser, FilesOfTheScene) {
  expect_error(parse_text("#fopen F \"/nonexistent/x\" write\n"),
               "cannot open '/nonexistent/x' for writing", 1);
  expect_error(parse_text("#write (F, 1)\n"), "'F' is not an open file", 1);
  expect_error(parse_text("#fopen F \"/dev/null\" write\n#write (F, 1 #fclose F, 2)\n"),
               "'/dev/null' was closed while #write was read", 2);
}

TEST(ErrorParser, MissingScene) {
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  NoProductions productions;
  parser::Parser parser(sources, diagnostics, {}, productions);
  try {
    parser.open("/nonexistent/scene.pov");
    FAIL();
  } catch (const parser::ParseError& error) {
    EXPECT_TRUE(has(error.message(), "cannot read the scene '/nonexistent/scene.pov'"));
  }
}

}  // namespace
}  // namespace lentray::test
