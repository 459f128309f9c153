// PlainTokens are the commonest expressions, read without what is done among ScriptTokens: the same values, bit for bit, the
// same messages, and the same random numbers, whatever stands in the way.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/unit/parser/parser_text.h"

namespace lentray::test {
namespace {

Parsed parser_plain_expressions_read(const std::string& text, bool raw) {
  parser::ParserOptions options;
  options.plain_expressions = raw;
  return parse_text("#version 3.7;\n" + text, {}, options);
}

void parser_plain_expressions_expect_same(const std::string& text) {
  const Parsed raw = parser_plain_expressions_read(text, true),
               grammar = parser_plain_expressions_read(text, false);
  EXPECT_EQ(raw.debug, grammar.debug) << text;
  EXPECT_EQ(raw.message, grammar.message) << text;
  EXPECT_EQ(raw.where.line, grammar.where.line) << text;
  EXPECT_EQ(raw.where.column, grammar.where.column) << text;
  EXPECT_EQ(raw.warnings, grammar.warnings) << text;
  EXPECT_EQ(raw.tokens, grammar.tokens) << text;
}

/// Random expressions of scalars and vectors, with most of what SDL can put into one.
class Expressions {
 public:
  explicit Expressions(unsigned seed) : m_random(seed) {}

  std::string scalar(int depth) {
    static const std::vector<std::string> kLeaves{
        "1",     "2.5",        "0",         "1e-11",   "A",   "B",           "V.x",
        "V.z",   "C.transmit", "N[1]",      "M[1][I]", "pi",  "I",           "rand(S)",
        "clock", "yes",        "<1,2,3>.y", "W.t",     "W.u", "Nested[1][0]"};
    if (depth == 0 || chance(0.2)) return pick(kLeaves);
    const auto s = [&] { return scalar(depth - 1); };
    static const std::vector<std::string> kOne{"sin", "cos",     "abs",  "floor", "ceil",
                                               "int", "sqr",     "atan", "asin",  "sqrt",
                                               "exp", "radians", "ln",   "tanh"};
    switch (number(18)) {
      case 0:
      case 1: return s() + "+" + s();
      case 2:
      case 3: return s() + "-" + s();
      case 4:
      case 5: return s() + "*" + s();
      case 6: return s() + "/" + s();
      case 7: return "(" + s() + ")";
      case 8: return "-" + s();
      case 9: return "!" + s();
      case 10: return pick(kOne) + "(" + s() + ")";
      case 11: return "mod(" + s() + ", " + s() + ")";
      case 12: return "min(" + s() + "," + s() + "," + s() + ")";
      case 13: return "(" + s() + " < " + s() + " ? " + s() + " : " + s() + ")";
      case 14: return "vdot(" + vector(depth - 1) + ", " + vector(depth - 1) + ")";
      case 15: return "vlength(" + vector(depth - 1) + ")";
      case 16: return "(" + s() + " >= " + s() + " & " + s() + " = " + s() + " | " + s() + ")";
      default: return chance(0.5) ? "Twice(" + s() + ")" : "N[" + s() + "]";
    }
  }

  std::string vector(int depth) {
    static const std::vector<std::string> kLeaves{"x",       "y",           "z",    "V",
                                                  "<1,2,3>", "<-1, .5, 2>", "Vs[0]"};
    if (depth == 0 || chance(0.2)) return pick(kLeaves);
    const auto s = [&] { return scalar(depth - 1); };
    const auto v = [&] { return vector(depth - 1); };
    switch (number(8)) {
      case 0: return "<" + s() + "," + s() + "," + s() + ">";
      case 1: return v() + "+" + v();
      case 2: return v() + "*" + s();
      case 3: return "vcross(" + v() + ", " + v() + ")";
      case 4: return "vnormalize(" + v() + ")";
      case 5: return "vaxis_rotate(" + v() + ", y, " + s() + ")";
      case 6: return "vrotate(" + v() + ", " + v() + ")";
      default: return "-" + v();
    }
  }

 private:
  int number(int below) { return static_cast<int>(m_random() % static_cast<unsigned>(below)); }
  bool chance(double p) { return number(1000) < p * 1000; }
  const std::string& pick(const std::vector<std::string>& from) {
    return from[static_cast<std::size_t>(number(static_cast<int>(from.size())))];
  }
  std::mt19937 m_random;
};

const char* const kHead =
    "#declare A = 3; #declare B = -0.75; #declare I = 1; #declare V = <1, -2, .5>;\n"
    "#declare W = <1, 2, 3, 4>; #declare C = color rgbft <.1, .2, .3, .4, .5>; #declare S = "
    "seed(7);\n"
    "#declare N = array[3] {5, 6, 7} #declare M = array[2][2] {{1, 2}, {3, 4}}\n"
    "#declare Vs = array[1] {<3, 2, 1>} #declare Nested = array[2] #declare Nested[1] = array[1] "
    "{9}\n"
    "#macro Twice(X) (2*X) #end\n";

TEST(UnitParserPlainExpressions, AgreesWithTheGrammarOnRandomExpressions) {
  Expressions make(20261121);
  int succeeded = 0;
  for (int i = 0; i < 400; ++i) {
    // A program ends with its first mistake, so each is short.
    std::string text = kHead;
    for (int j = 0; j < 3; ++j) {
      text += "#declare R = " + make.scalar(4) + ";\n#debug str(R, 0, -1)\n";
      text += "#if (" + make.scalar(3) + ") #debug \"yes\" #end\n";
      text += "#local Q = " + make.vector(3) + "; #debug vstr(3, Q*1, \",\", 0, -1)\n";
      text += "#debug str(rand(S), 0, -1)\n";
    }
    parser_plain_expressions_expect_same(text);
    if (parser_plain_expressions_read(text, true).error.empty()) ++succeeded;
    if (HasFailure()) break;
  }
  EXPECT_GT(succeeded, 100);
}

TEST(UnitParserPlainExpressions, GivesUpWithoutATrace) {
  const std::string head(kHead);
  for (const std::string rest :
       {"#debug str(rand(S) + #if (1) rand(S) #end, 0, -1) #debug str(rand(S), 0, -1)",
        "#debug str(rand(S)/0, 0, -1) #debug str(rand(S), 0, -1)",
        "#debug str(rand(S) + rand(9), 0, -1)",
        "#macro Sum() 1 + 2 #end #declare X = Sum()*3; #debug str(X, 0, -1)",
        "#macro Open() 1 + #end #declare X = Open() 4; #debug str(X, 0, -1)",
        "#declare X = 1 #if (1) + 2 #end; #debug str(X, 0, -1)",
        "#declare X = A #debug \"no semicolon\"",
        "#declare X = Y;",
        "#declare X = N[3];",
        "#declare X = N[-1];",
        "#declare X = A.y;",
        "#declare X = V.t;",
        "#declare X = <1, 2, 3, 4, 5, 6>;",
        "#declare X = <1>;",
        "#declare X = sqrt(-1);",
        "#declare X = acos(2);",
        "#declare X = vnormalize(<0,0,0>);",
        "#declare Twice = 3;",
        "#declare X = 1;; #debug str(X, 0, -1)",
        "#macro Set(P) #declare P = P + 1; #end Set(A) #debug str(A, 0, -1)",
        "#macro Set(P) #local P = P + 1; #debug str(P, 0, -1) #end Set(A) #debug str(A, 0, -1)",
        "#macro Set(P) #declare P = P + 1; #end Set(N[1]) #debug str(N[1], 0, -1)",
        "#macro Last() #local L = 5; #end Last(); #debug str(defined(L), 0, -1)",
        "#declare X = #ifdef (A) 5 #else 6 #end ; #debug str(X, 0, -1)",
        "#declare deprecated \"old\" D = 4; #declare X = D + 1; #debug str(X, 0, -1)",
        "#debug str((((((((((((1)))))))))))) + 1, 0, -1)",
        "#declare X = V.x*0 + Twice(2); #debug vstr(3, X, \" \", 0, -1)",
        "#declare X = (<1, 2, 3> + Twice(2)).y; #debug str(X, 0, -1)",
        "#declare X = V*Twice(V.x); #debug vstr(3, X, \" \", 0, -1)",
        "#debug vstr(3, 2 + Twice(1)*V, \" \", 0, -1)",
        "#debug str(2*Twice(1) = 4 ? Twice(3) : V.y, 0, -1)",
        "#declare X = (Text = \"x\");",
        "#if (concat(\"a\", \"b\") = \"ab\" & 1) #debug \"same\" #end",
        "#if (1 | \"a\" = \"b\" + 1) #end",
        "#debug str(strlen(\"abc\") + val(\"2\") + asc(\"A\") + strcmp(\"a\", \"b\"), 0, -1)",
        "#debug str(select(-1, 2, 3, 4) + select(0, 2, 3) + C.gray, 0, -1)",
        "#declare X = 1 + ",
        "#declare X = (1"}) {
    parser_plain_expressions_expect_same(head + rest);
  }
}

TEST(UnitParserPlainExpressions, StringsAgreeWithTheGrammar) {
  const std::string head =
      std::string(kHead) +
      "#declare Text = \"some Text\"; #declare Texts = array[2] {\"one\", \"two\"}\n";
  for (const std::string rest :
       {"#debug Text #debug Texts[1] #debug Texts[2]",
        "#debug Texts[0*1]",
        "#debug concat(\"a\", str(A, 5, 2), str(B, -8, 3), str(I, 0, -1), \"\\n\")",
        "#debug concat(Text, vstr(3, V, \", \", 0, 4), vstr(9, <1, 2>, Texts[0], 4, 1), vstr(0, A, "
        "\"\", 0, 0))",
        "#debug concat(chr(65 + mod(I, 26)), chr(955), chr(70000))",
        "#debug chr(-1)",
        "#debug substr(Text, 2, 3)",
        "#debug substr(Text, 0, 3)",
        "#debug substr(Text, 9, 1)",
        "#debug concat(strupr(concat(\"x\", Text)), strlwr(Text), Text)",
        "#debug str(rand(S), 0, -1) #declare L = concat(str(rand(S), 0, -1), Missing);",
        "#declare L = concat(str(rand(S), 0, -1), \"x\") #debug L #debug str(rand(S), 0, -1)",
        "#declare L = \"x\" #debug L",
        "#declare L = Text; #declare L = concat(L, L); #debug L",
        "#declare Twice = \"x\";",
        "#declare L = \"\\q\";",
        "#debug \"caf\303\251\"",
        "#declare L = concat(\"a\" \"b\", #if (1) \"c\" #end); #debug L",
        "#macro M(T) #debug concat(T, \"!\") #local T = 1; #end M(Text) M(\"x\")",
        "#declare L = ",
        "#declare L = concat(\"a\"",
        "#debug str(1)",
        "#debug str(V, 0, 0)"}) {
    parser_plain_expressions_expect_same(head + rest);
  }
}

// Read as floats and again as what may be vectors at each level, it would never end.
TEST(UnitParserPlainExpressions, NestedFunctionsDoNotMultiplyTheWork) {
  for (const std::string inner : {"Missing", "V", "<1, 2>", "(A > 1 ? A : B)"}) {
    std::string text = inner;
    for (int i = 0; i < 60; ++i) text = "(sin(" + text + ") + " + inner + ")";
    parser_plain_expressions_expect_same(std::string(kHead) + "#debug str(" + text + ", 0, -1)");
  }
}

TEST(UnitParserPlainExpressions, AComponentWhereAVectorIsWanted) {
  const std::string head(kHead);
  for (const std::string vector : {"V.x", "-V.y", "V.y*2", "2*V.y", "(V.y)", "V.y - 1",
                                   "V.y + <1,1,1>", "W.t", "<V.y, 1, 1>", "Vs[0].y", "+V.z"}) {
    parser_plain_expressions_expect_same(
        head + "#debug str(vlength(" + vector + "), 0, -1) #declare K = " + vector +
        "; #debug str(vlength(K), 0, -1) #debug vstr(3, vnormalize(" + vector + "), \" \", 0, -1)");
  }
}

}  // namespace
}  // namespace lentray::test
