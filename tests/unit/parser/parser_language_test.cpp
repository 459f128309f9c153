// The interpreter by itself: texts, directives, macros, scopes, contextual words.
#include <gtest/gtest.h>

#include "core/function/internal.h"
#include "parser/tokens/keywords.h"
#include "parser/tokens/lexer.h"
#include "tests/unit/parser/parser_text.h"

namespace lentray::test {
namespace {

using parser::Keyword;
using parser::TokenKind;

std::string debug_of(const std::string& text) {
  const Parsed p = parse_text("#version 3.7;\n" + text);
  return p.error.empty() ? p.debug : p.error;
}

TEST(UnitParserLexer, NumbersNamesAndStrings) {
  parser::NameTable names;
  const auto list =
      parser::tokenise(1, "A .5 1. 2e3 1e-3 5.x \"a\\n\\u00e9\\\"\" colour color >=", names);
  const auto& t = list->tokens;
  ASSERT_EQ(list->size(), 11u);
  EXPECT_EQ(t[0].kind, TokenKind::kIdentifier);
  EXPECT_EQ(t[1].number, 0.5);
  EXPECT_EQ(t[2].number, 1.0);
  EXPECT_EQ(t[3].number, 2000.0);
  EXPECT_EQ(t[4].number, 1e-3);
  EXPECT_EQ(t[5].number, 5.0);
  EXPECT_TRUE(t[6].is(Keyword::kX));
  EXPECT_EQ(names.string(t[7].name), "a\n\xC3\xA9\"");
  EXPECT_EQ(names.raw_string(t[7].name), "a\\n\\u00e9\\\"");
  EXPECT_TRUE(t[8].is(Keyword::kColor));
  EXPECT_TRUE(t[9].is(Keyword::kColor));
  EXPECT_TRUE(t[10].is(parser::Punct::kGreaterEqual));
}

TEST(UnitParserLexer, CommentsNestAndPlacesAreRight) {
  parser::NameTable names;
  parser::SourceManager sources;
  const auto file = sources.add("x", "/* a /* b */ c */ x // y\n  z");
  const auto list = parser::tokenise(file, sources.text(file), names);
  ASSERT_EQ(list->size(), 2u);
  EXPECT_EQ(sources.place(list->tokens[0].where), "x:1:19");
  EXPECT_EQ(sources.place(list->tokens[1].where), "x:2:3");
}

TEST(UnitParserSource, LineEndsAndByteOrderMark) {
  parser::SourceManager sources;
  const auto file = sources.add("x",
                                "\xEF\xBB\xBF"
                                "a\r\nb\rc\n");
  EXPECT_EQ(sources.text(file), "a\nb\nc\n");
  EXPECT_EQ(sources.line({file, 2}), "b");
  EXPECT_EQ(sources.place({file, 2}), "x:2:1");
  EXPECT_EQ(sources.place({file, 5}), "x:3:2");
  EXPECT_EQ(sources.line({file, 900}), "");
  EXPECT_EQ(sources.place({}), "");
}

TEST(UnitParserKeywords, TableRoundTrip) {
  for (std::size_t i = 1; i < static_cast<std::size_t>(Keyword::kEndOfKeywords); ++i) {
    const auto keyword = static_cast<Keyword>(i);
    EXPECT_EQ(parser::find_keyword(parser::spelling(keyword)), keyword);
  }
  EXPECT_EQ(parser::find_keyword("light_source"), Keyword::kLightSource);
  EXPECT_EQ(parser::find_keyword("colour_map"), Keyword::kColorMap);
  for (const char* word :
       {"lenticular", "lens_pitch", "view_distance", "paraxial", "pinhole", "thick"}) {
    EXPECT_EQ(parser::find_keyword(word), Keyword::kNone) << word;
  }
}

TEST(UnitParserFlow, SkippedTextMayBeAnything) {
  EXPECT_EQ(debug_of("#if (0) it's \x80 #foo { #if (1) #else #end ) #else #debug \"b\" #end"), "b");
}

TEST(UnitParserFlow, ElseifAndNesting) {
  EXPECT_EQ(debug_of("#for (I,1,4) #if (I=1) #debug \"a\" #elseif (I=2) #if (1) #debug \"b\" #end"
                     " #elseif (I=3) #debug \"c\" #else #debug \"d\" #end #end"),
            "abcd");
}

TEST(UnitParserFlow, SwitchFallsThroughUntilBreak) {
  EXPECT_EQ(debug_of("#for (I,1,5) #switch (I) #case (1) #debug \"1\" #case (2) #debug \"2\" #break"
                     " #range (3,4) #debug \"r\" #break #else #debug \"e\" #end #debug \".\" #end"),
            "12.2.r.r.e.");
}

TEST(UnitParserFlow, LoopsAndBreak) {
  EXPECT_EQ(debug_of("#declare I=0; #while (I<10) #declare I=I+1; #if (I=3) #break #end "
                     "#local J=0; #while (J<2) #debug str(I*10+J,0,0) #debug \" \" #local J=J+1; "
                     "#end #end"),
            "10 11 20 21 ");
  EXPECT_EQ(debug_of("#for (I,3,1,-1) #debug str(I,0,0) #end #for (I,2,1) #debug \"no\" #end"),
            "321");
}

TEST(UnitParserMacro, InTheMiddleOfAStatement) {
  EXPECT_EQ(debug_of("#macro Three() 1,2,3 #end #macro Half() > * #end\n"
                     "#debug vstr(3, <Three()> * 2, \",\", 0, 0)"),
            "2,4,6");
  EXPECT_EQ(debug_of("#macro Tail() *2 #end #declare A = (3 Tail()); #debug str(A,0,0)"), "6");
}

TEST(UnitParserMacro, ArgumentsByReferenceAndByValue) {
  EXPECT_EQ(debug_of("#macro Up(p) #declare p = p+1; #end\n"
                     "#declare A = 1; Up(A) #declare B = array[2] {5,6} Up(B[1])\n"
                     "#debug str(A,0,0) #debug str(B[1],0,0)"),
            "27");
  EXPECT_EQ(debug_of("#macro Outer(p) Inner(p) #end #macro Inner(q) #declare q = 9; #end\n"
                     "#declare A = 1; Outer(A) #debug str(A,0,0)"),
            "9");
  EXPECT_EQ(debug_of("#macro M(p) #declare p = 7; #end #declare A = 1; M(A*1) #debug str(A,0,0)"),
            "1");
}

TEST(UnitParserMacro, Recursion) {
  EXPECT_EQ(
      debug_of("#macro Fact(n) #if (n<=1) 1 #else n*Fact(n-1) #end #end #debug str(Fact(10),0,0)"),
      "3628800");
  EXPECT_EQ(debug_of("#macro Down(n) #if (n>0) Down(n-1) #end #end Down(5000) #debug \"ok\""),
            "ok");
}

TEST(UnitParserMacro, OptionalParameters) {
  EXPECT_EQ(
      debug_of("#macro M(a, optional b) #ifdef (b) #debug str(a+b,0,0) #else #debug \"-\" #end #end"
               " M(1,) M(1,2) #declare b = 5; M(1,)"),
      "-3-");
}

TEST(UnitParserScope, LocalsEndWithTheirMacroOrFile) {
  const Parsed p = parse_text(
      "#version 3.7;\n#declare A = 1;\n#include \"i.inc\"\n#debug str(A,0,0)\n"
      "#ifdef (L) #debug \"L\" #end #ifdef (G) #debug \"G\" #end",
      {{"i.inc", "#local A = 2; #local L = 3; #declare G = 4; #debug str(A,0,0)\n"}});
  EXPECT_EQ(p.error, "");
  EXPECT_EQ(p.debug, "21G");
}

TEST(UnitParserScope, UndefShowsTheOuterSymbol) {
  EXPECT_EQ(
      debug_of("#declare A = 1; #macro M() #local A = 2; #undef A #debug str(A,0,0) #local A = 3;"
               " #debug str(A,0,0) #end M() #debug str(A,0,0)"),
      "131");
}

TEST(UnitParserScope, TheSymbolIsSettledBeforeTheValueIsRead) {
  // The value is complete while its macro still runs: the semicolon stands in the macro.
  EXPECT_EQ(debug_of("#macro F() #local R = 1; #local Q = 5; #if (1) Q; #else 0; #end #end\n"
                     "#macro G() #local N = F() #local R = F() #debug str(N+R,0,0) #end G()"
                     "#ifdef (N) #debug \"leak\" #end #declare T = F() #debug str(T,0,0)"),
            "105");
}

TEST(UnitParserLexer, LoneHashIsIgnored) {
  const Parsed p = parse_text("#version 3.7; sphere { 0, 1 #\n } #debug \"on\"");
  EXPECT_EQ(p.debug, "on");
  ASSERT_EQ(p.warnings.size(), 1u);
}

TEST(UnitParserArray, CopiesAndReferences) {
  EXPECT_EQ(debug_of("#declare A = array[2] {1,2} #declare B = A; #declare B[0] = 9;"
                     "#macro Set(a) #declare a[1] = 8; #end Set(A)"
                     "#debug str(A[0],0,0) #debug str(A[1],0,0) #debug str(B[0],0,0)"),
            "189");
  EXPECT_EQ(debug_of("#declare A = array[2][3] {{1,2,3},{4,5,6}} #debug str(A[1][0],0,0)"
                     "#debug str(dimension_size(A,2),0,0) #debug str(dimensions(A),0,0)"),
            "432");
  EXPECT_EQ(debug_of("#declare A = array[2] #declare A[0] = array[2] {\"a\",\"b\"} #debug A[0][1]"
                     "#ifdef (A[1]) #debug \"1\" #else #debug \"0\" #end"),
            "b0");
}

TEST(UnitParserIncludes, TheHeaderComesBeforeTheScene) {
  parser::ParserOptions options;
  options.include_header = "header.inc";
  const Parsed p = parse_text("#debug str(A,0,0)", {{"header.inc", "#declare A = 7;\n"}}, options);
  EXPECT_EQ(p.debug, "7") << p.error;
}

TEST(UnitParserIncludes, NamesWithoutAnExtensionGetTheUsualOne) {
  const Parsed p =
      parse_text("#include \"part\" #debug str(A,0,0)", {{"part.inc", "#declare A = 8;\n"}});
  EXPECT_EQ(p.debug, "8") << p.error;
}

TEST(UnitParserFiles, WriteReadInclude) {
  EXPECT_EQ(
      debug_of("#declare N = \"" + std::string("/tmp/lentray_front_test.inc") +
               "\";\n"
               "#fopen F N write #write (F, 1.5, \",\", <1,2,3>, \",\\\"s\\\"\\n\") #fclose F\n"
               "#fopen F N read #read (F, A, B, C) #ifndef (F) #debug \"eof \" #end\n"
               "#debug concat(str(A,0,1), vstr(3,B,\",\",0,0), C)\n"
               "#fopen F N write #write (F, \"#debug \\\" one\\\"\") #fclose F #include N\n"
               "#fopen F N write #write (F, \"#debug \\\" two\\\"\") #fclose F #include N"),
      "eof 1.51,2,3s one two");
  std::filesystem::remove("/tmp/lentray_front_test.inc");
}

TEST(UnitParserFunction, EveryInternalFunctionIsEvaluated) {
  for (int number = 0; number < 79; ++number) {
    const auto function = core::internal_function(number);
    ASSERT_TRUE(function) << number;
    EXPECT_EQ(function->not_yet(), "") << number;
  }
  EXPECT_FALSE(core::internal_function(79));
  EXPECT_FALSE(core::internal_function(-1));
}

TEST(UnitParserFunction, CallEachOtherAsDeepAsIsAllowed) {
  EXPECT_EQ(debug_of("#declare F = function(x) { x + 1 };"
                     "#for (I, 2, 199) #declare F = function(x) { F(x) + 1 }; #end"
                     "#debug str(F(1), 0, 0)"),
            "200");
}

TEST(UnitParserFunction, OfManyConstants) {
  std::string sum = "x";
  for (int i = 1; i <= 1500; ++i) sum += " + " + std::to_string(i) + ".5*x";
  EXPECT_EQ(debug_of("#declare F = function(x) { " + sum + " }; #debug str(F(2), 0, 0)"),
            "2253002");
}

// As deep as it has terms: compiling it must not need as much stack.
TEST(UnitParserFunction, OfManyTerms) {
  constexpr int kTerms = 4900;
  std::string folded = "1", sum = "x";
  for (int i = 1; i < kTerms; ++i) folded += "+1", sum += "+x";
  EXPECT_EQ(
      debug_of("#declare F = function(x) { " + folded + "+" + sum + " }; #debug str(F(2), 0, 0)"),
      std::to_string(3 * kTerms));
}

TEST(UnitParserWords, ContextualWordsStayIdentifiers) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "s.pov",
                   "#declare lens_pitch = 3; lenticular lens_pitch 1.5 view_distance -2");
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  NoProductions productions;
  parser::Parser parser(sources, diagnostics, {}, productions);
  parser.open(folder / "s.pov");
  EXPECT_TRUE(parser.accept_word("lenticular"));
  EXPECT_FALSE(parser.accept_word("view_distance"));
  EXPECT_TRUE(parser.accept_word("lens_pitch"));
  EXPECT_EQ(parser.parse_float(), 1.5);
  EXPECT_TRUE(parser.accept_word("view_distance"));
  EXPECT_EQ(parser.parse_float(), -2.0);
  EXPECT_TRUE(parser.at_end());
}

TEST(UnitParserDeclare, TheLookAheadDoesNotRunTheNextDirective) {
  // Layered textures look for a further `texture`; the directive after them needs the name.
  EXPECT_EQ(
      debug_of("#declare T = texture { a } #ifdef (T) #debug \"set\" #else #debug \"not\" #end"),
      "set");
  EXPECT_EQ(debug_of("#macro M(o) #debug \"ok\" #end #declare S = union { sphere } M(S)"), "ok");
}

TEST(UnitParserDeclare, OptionsOfTheCommandLine) {
  parser::ParserOptions options;
  options.declares = {{"N", "2.5"}, {"S", "\"text\""}};
  options.image_width = 320;
  const Parsed p =
      parse_text("#debug str(N,0,1) #debug S #debug str(image_width,0,0)", {}, options);
  EXPECT_EQ(p.debug, "2.5text320") << p.error;
}

TEST(UnitParserIncludes, NamesThatOnlyWindowsFinds) {
  const std::map<std::string, std::string> files = {{"mine.inc", "#debug \"mine \""},
                                                    {"other.inc", "#debug \"other \""}};
  const Parsed p = parse_text(
      "#include \"MINE.Inc\"\n#include \".\\other.inc\"\n#include \" mine.inc \"\n"
      "#include \"C:\\scenes\\Colors.INC\"\n#include \"mine.inc\"",
      files);
  EXPECT_EQ(p.error, "");
  EXPECT_EQ(p.debug, "mine other mine mine ");
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_NE(p.warnings[0].find("there is no file 'MINE.Inc'"), std::string::npos) << p.warnings[0];
  EXPECT_EQ(parse_text("#debug str(file_exists(\"MINE.INC\"),0,0)", files).debug, "0");
  EXPECT_NE(parse_text("#include \"nowhere.inc\"", files).error, "");
}

TEST(UnitParserIncludes, TextsFromWindows) {
  EXPECT_EQ(
      parse_text("\xEF\xBB\xBF#debug \"a\"\r\n// \xE4\xF6\xFC\r\n#debug \"b\"\r#debug \"c\"\n\x1A")
          .debug,
      "abc");
  EXPECT_EQ(parse_text("#debug \"\xE4\"").debug, " ");  // ASCII unless the scene says utf8
}

TEST(UnitParserIncludes, StandardFilesAreRead) {
  for (const char* name :
       {"math",    "functions", "transforms", "colors",    "shapes",   "rand",
        "strings", "arrays",    "consts",     "logo",      "textures", "stones",
        "metals",  "woods",     "golds",      "glass",     "finish",   "skies",
        "stars",   "stdinc",    "shapes2",    "shapesq",   "chars",    "screen",
        "rad_def", "debug",     "meshmaker",  "makegrass", "ior",      "sunpos"}) {
    const Parsed p =
        parse_text("#version 3.7;\n#include \"" + std::string(name) + ".inc\"\n#debug \"end\"");
    EXPECT_EQ(p.error, "") << name;
    EXPECT_EQ(p.debug, "end") << name;
  }
}

TEST(UnitParserMacros, LocalsEndWithTheMacroThoughASemicolonFollows) {
  EXPECT_EQ(debug_of("#macro M() #local L = 5; #end M(); #debug str(defined(L), 0, 0)"), "0");
  EXPECT_EQ(debug_of("#macro M() #local L = \"text\"; #end M(); #debug str(defined(L), 0, 0)"),
            "0");
  EXPECT_EQ(debug_of("#macro M() #declare L = \"text\"; #end M(); #debug L"), "text");
}

// A long text is made tokens in pieces, which end behind values.
TEST(UnitParserLexer, PiecesHoldTheSameTokens) {
  using parser::Punct;
  std::string text;
  for (int n = 0; n < 900; ++n) {
    text += "\"name\", " + std::to_string(n) + ", <1, " + std::to_string(n) +
            ", -2>, <1,\n2 + 3, 4>,\n";
  }
  parser::NameTable names;
  const auto whole = parser::tokenise(1, text, names);
  parser::TokenPieces pieces(1, text, names);
  std::size_t at = 0, count = 0;
  while (pieces.next(500)) {
    ++count;
    const parser::TokenList& list = *pieces.list();
    const bool last =
        list.tokens[list.size() - 1].where.offset == whole->tokens[whole->size() - 1].where.offset;
    EXPECT_TRUE(last || list.tokens[list.size() - 1].is(Punct::kComma));
    EXPECT_TRUE(list.tokens[0].kind == TokenKind::kString ||
                list.tokens[0].kind == TokenKind::kNumber || list.tokens[0].is(Punct::kLess));
    for (std::size_t i = 0; i < list.size(); ++i, ++at) {
      const parser::Token& t = list.tokens[i];
      // At the start of a piece a vector is not yet one token: its numbers stand by themselves.
      if (t.is(Punct::kLess) && whole->tokens[at].name > 0 && t.name == 0) {
        while (!list.tokens[i].is(Punct::kGreater)) ++i;
        continue;
      }
      EXPECT_EQ(t.kind, whole->tokens[at].kind);
      EXPECT_EQ(t.where.offset, whole->tokens[at].where.offset);
    }
  }
  EXPECT_EQ(at, whole->size());
  EXPECT_GT(count, 5u);
}

TEST(UnitParserLexer, VectorsOfNumbersAreOneTokenWhereTheyCanBeNothingElse) {
  parser::NameTable names;
  const auto list = [&](const char* text) { return parser::tokenise(1, text, names); };
  const auto whole = list("A = < 1,- 2.5\n, .5 > B");
  ASSERT_EQ(whole->size(), 4u);
  EXPECT_TRUE(whole->tokens[2].is(parser::Punct::kLess));
  EXPECT_EQ(whole->tokens[2].where.offset, 4u);
  EXPECT_EQ(whole->tokens[2].name, 3u);
  EXPECT_EQ(whole->components, (std::vector<double>{1.0, -2.5, 0.5}));
  EXPECT_EQ(whole->tokens[3].where.offset, 21u);
  EXPECT_EQ(list("A = <1, 2, 3, 4, 5>")->size(), 3u);
  struct Apart {
    const char* text;
    std::size_t tokens;
  };
  for (const Apart& a : {Apart{"A <1, 2>", 6}, Apart{"A = <1>", 5}, Apart{"A = <1, 2,>", 8},
                         Apart{"A = <1, 2>= 3", 8}, Apart{"A = <1, x>", 7},
                         Apart{"A = <1, 2 3>", 8}, Apart{"A = <1, 2", 6}, Apart{"A = <", 3},
                         Apart{"A = <1, /* */ 2>", 7}, Apart{"A = <1, 2, 3, 4, 5, 6>", 15}}) {
    const auto apart = list(a.text);
    EXPECT_EQ(apart->size(), a.tokens) << a.text;
    EXPECT_TRUE(apart->components.empty()) << a.text;
    EXPECT_EQ(apart->tokens[2].name, 0u) << a.text;
  }
}

TEST(UnitParserLexer, NumbersAreRoundedCorrectly) {
  std::uint32_t random = 1;
  const auto next = [&](std::uint32_t below) {
    return (random = random * 1664525u + 1013904223u) / 65536u % below;
  };
  std::vector<std::string> texts{"0.1",
                                 ".3",
                                 "1.",
                                 "0.000000000000001",
                                 "999999999999999.",
                                 "9007199254740993",
                                 "9007199254740992.",
                                 "123456789012345.6",
                                 "4.35",
                                 "1e23",
                                 "5e-324",
                                 "1e400",
                                 "0.30000000000000004",
                                 "2.2250738585072011e-308"};
  for (int i = 0; i < 5000; ++i) {
    std::string text;
    for (std::uint32_t d = 1 + next(14); d > 0; --d) text += static_cast<char>('0' + next(10));
    text.insert(next(static_cast<std::uint32_t>(text.size()) + 1), ".");
    if (text == ".") text = "0.";
    texts.push_back(text);
  }
  for (const std::string& text : texts) {
    parser::NameTable names;
    const auto list = parser::tokenise(1, text, names);
    ASSERT_EQ(list->size(), 1u) << text;
    EXPECT_EQ(list->tokens[0].number, std::strtod(text.c_str(), nullptr)) << text;
  }
}

}  // namespace
}  // namespace lentray::test
