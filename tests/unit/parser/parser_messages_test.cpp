// Every message of the interpreter is provoked: the sources are searched for the places that give
// one, and each of them must be heard from a program below. A new message without a program fails.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/fuzz/read_input.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;

const char* const kParserMessagesPrograms[] = {
    // directives
    "#delcare A = 1;", "declare A = 1;", "#include \"scene.pov\"", "#error \"stop\"",
    "#version 3.7", "#version 0.5;", "#version 3.8;",
    "#declare A = array[1] {1} #while (1) #declare B = array[1] #declare B[0] = A #declare A = B "
    "#end",
    "#ifdef (+) #end", "#macro M() #end #declare M = 1;",
    "#version 3.7; #declare A = 1 sphere {0,1}", "#undef A", "#declare A = ;",
    "#declare A = array[0];", "#declare A = array;", "#declare A = array[2] {1}",
    "#declare A = array[1] {1, 2}",
    // conditions and loops
    "#if (1)", "#if (x) #end", "#if (0) #case (1) #end", "#else", "#end", "#switch (1) 2 #end",
    "#switch (2) #case (1) #elseif (1) #end", "#case (1)",
    "#declare A = array[1] #for (A[0], 1, 2) #end", "#for (I, 1, 2, 0) #end",
    "#for (I, 1, 2) #undef I #end", "#break",
    // macros
    "#macro M() #end #macro N(#declare F = 1; A) #end", "#macro M(A +) #end",
    "#macro M(A, B) #end M(1)", "#macro M() M() #end M()", "#macro M(A) #end M(1 2)",
    "#macro H(A #include \"half.inc\"",
    // expressions
    "#declare A = sin(x);", "#declare A = <x, 1>;", "sphere { <1,2,3,4>, 1 }",
    "background { rgb 1 } camera { location <1,2,3,4,5> }", "#declare A = (x ? 1 : 2);",
    "#if (\"a\" + 1) #end", "#declare A = 1/0;", "#declare A = 1 + ;",
    "#declare A = array[2] {1, 2} #undef A[1] #declare B = A[1] + 1;", "#declare A = B + 1;",
    "#macro M(A) #declare B = A + 1; #end #declare S = array[1] M(S[0])",
    "#declare P = sphere {0, 1} #declare A = 1 + P;", "#declare A = <1,2,3,4,5,6>;",
    "#declare A = <1>;", "#declare A = (1).gray;", "#declare A = x.pigment;", "#declare A = x.t;",
    "#declare S = spline {}", "#declare S = spline {0, x 1, y} #declare A = S(1, pi);",
    "#declare F = function(a) {a} #declare A = F(1, 2);", "#declare A = rgb <1,2,3,4>;",
    "#declare A = srgb .5;", "#declare A = color ;  light_source { 0 pigment }",
    "#declare A = rand(5);", "#declare A = dimensions(1);",
    "#declare A = array[1] #declare B = dimension_size(A, 2);", "#declare A = acos(2);",
    "#declare A = ln(0);", "#declare A = atan2(0, 0);", "#declare A = sqrt(-1);",
    "#declare A = pow(0, 0);", "#declare A = \"\\q\"", "#debug \"\xC3\xA9\"", "#debug 1",
    "#render \"a\"", "#declare S = \"0123456789\" #while (1) #declare S = concat(S, S) #end",
    "#debug chr(70000)", "#debug substr(\"abc\", 2, 5)", "#debug datetime(0, \"\")",
    "sphere {0, 1 scale 0}", "sphere {0, 1 matrix <0,0,0,0,0,0,0,0,0,0,0,0>}",
    "sphere {0, 1 matrix <0,0,0,0,0,0,0,0,0,0,0,0,0>}", "sphere {0, 1 transform A}",
    "sphere {0, 1 transform {A}}", "#declare A = inside(1, 0);",
    "#declare O = sphere {0, 1} #declare N = 1; #declare A = trace(O, y, -y, N);",
    "#version 3.7; #declare A = vnormalize(0);",
    // functions
    "#declare F = function {internal(500)}",
    "#declare F = function {x} #while (1) #local G = function {F(x,y,z)} #undef F #declare F = "
    "function {G(x,y,z)} #undef G #end",
    "#declare F = function {x} #while (1) #local G = function {F(x,y,z) + F(y,x,z)} #undef F "
    "#declare F = function {G(x,y,z) + G(z,y,x)} #undef G #end",
    "isosurface { function A }", "#declare F = function(1) {x}", "MANY_PARAMETERS", "MANY_OPERANDS",
    "#declare F = function {x + }", "#declare F = function {max(x)}",
    "#declare F = function {select(x)}",
    "#declare F = function {transform {scale 1}} #declare G = function {F(x,y,z).pigment}",
    "#declare V = <1,2>; #declare F = function {V.z}",
    "#declare V = <1,2,3>; #declare F = function {V}",
    "#declare A = array[1] #macro M(V) #declare F = function {V} #end M(A[0])",
    "#declare F = function {A}", "#declare S = sphere {0, 1} #declare F = function {S}",
    "#declare F = function {pigment}", "#declare F = function {x} #declare G = function {F(x)}",
    "#declare F = function {transform {scale 1}} #declare G = function {F(x,y,z)}",
    // limits and files
    "NESTED", "#while (1) #end", "#include \"COLORS.inc\"", "/* never", "\"never", "\x01",
    "global_settings { charset utf8 max_trace_level 1e300 }", "#fopen F \"none\" read",
    "#include concat(\"a\", chr(0))",
    "#declare S = \"0123456789\" #for (I, 1, 9) #declare S = concat(S, S) #end #fopen F \"f\" "
    "write #while (1) #write (F, S) #end",
    "#fopen F \"\" write", "#declare A = 1; #write (A, 1)",
    "#fopen F \"f\" write #fclose F #fopen F \"f\" read #write (F, 1)",
    "#fopen F \"f\" write #write (F, pigment)", "#fopen F \"f\" write #write (F, 1 #fclose F, 2)",
    "#fopen F \"f\" write #read (F, A)", "FILE -\"a\"", "FILE <1,2,3,4,5,6>", "FILE <1>", "FILE }",
    "FILE 1 2", "#declare F = function {x/0}", "# 5",
    "#declare A = array[1] #declare B = A[1] + 1;", "#declare sphere = 1;",
    "#version 3.0; #declare C = color red 1 alpha .5;"};

// What is long is made, and files are written before they are read.
std::string program(std::string text) {
  if (text.rfind("FILE ", 0) == 0) {
    std::string content;
    for (const char c : text.substr(5)) content += c == '"' ? "\\\"" : std::string(1, c);
    return "#fopen F \"f\" write #write (F, \"" + content +
           "\") #fclose F #fopen F \"f\" read #read (F, A)";
  }
  if (text == "NESTED") return "#declare A = " + std::string(100'000, '(');
  if (text == "MANY_OPERANDS") {
    text = "#declare F = function { x";
    for (int i = 0; i < 11'000; ++i) text += " + 1";
    return text + "}";
  }
  if (text == "MANY_PARAMETERS") {
    text = "#declare F = function (a";
    for (int i = 0; i < 60; ++i) text += ", a" + std::to_string(i);
    return text + ") {a}";
  }
  return text;
}

struct Site {
  std::string place, words;
};

// The longest string literal of a call that begins at `i`, behind its parenthesis.
std::string longest_literal(const std::string& text, std::size_t i) {
  std::string best, current;
  bool joined = false;  // literals with only space between them are one
  for (int depth = 1; depth > 0 && i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == '"') {
      if (!joined) current.clear();
      for (++i; text[i] != '"'; ++i) {
        if (text[i] == '\\') ++i;
        current += text[i];
      }
      joined = true;
      if (current.size() > best.size()) best = current;
    } else if (!std::isspace(static_cast<unsigned char>(c))) {
      joined = false;
    }
  }
  return best;
}

std::vector<Site> sites() {
  std::vector<Site> found;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(LENTRAY_SOURCE_DIR) / "parser")) {
    const std::string name = entry.path().filename().string();
    const auto is_one = [&](const char* start) { return name.rfind(start, 0) == 0; };
    if (entry.path().extension() != ".cpp" ||
        !(is_one("directives") || is_one("expression") || is_one("function_parser") ||
          is_one("lexer") || is_one("script") || is_one("token_reader") || is_one("interpreter"))) {
      continue;
    }
    const std::string text = tool::read_text(entry.path());
    for (const char* call : {"fail(", "fail_expected(", "warn(", "bad("}) {
      for (std::size_t at = text.find(call); at != std::string::npos;
           at = text.find(call, at + 1)) {
        if (at > 0 &&
            (std::isalnum(static_cast<unsigned char>(text[at - 1])) || text[at - 1] == '_'))
          continue;
        const std::string words = longest_literal(text, at + std::string(call).size());
        const auto line =
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        if (words.size() > 3) found.push_back({name + ":" + std::to_string(line), words});
      }
    }
  }
  return found;
}

TEST(ErrorMessages, EachIsHeard) {
  const MemoryFiles::Library library = {{"colors.inc", "#declare Red = rgb x;"},
                                        {"half.inc", ") #end"}};
  std::string heard;
  for (const char* text : kParserMessagesPrograms) {
    const auto messages = read_input(program(text), library);
    EXPECT_FALSE(messages.empty()) << "no message from: " << text;
    for (const std::string& message : messages) heard += message + "\n";
  }
  const std::vector<Site> all = sites();
  EXPECT_GT(all.size(), 100u);
  for (const Site& site : all) {
    EXPECT_NE(heard.find(site.words), std::string::npos)
        << site.place << ": no program provokes the message \"" << site.words << '"';
  }
}

}  // namespace
}  // namespace lentray::test
