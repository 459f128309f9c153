// Expressions: the same text as stock, to the ninth digit.
#include "tests/compat/language_help.h"

namespace lentray::test {
namespace {

const char* const kSetup =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "#declare A = 2; #declare V = <1,2,3>; #declare P = <5,6>; #declare C = rgbft "
    "<.1,.2,.3,.4,.5>;\n"
    "#declare S = \"Hello\"; #declare Arr = array[3] {1.5, 2.5, 3.5}\n"
    "#declare M = array[2][3] {{1,2,3},{4,5,6}}\n";

TEST(CompatLanguage, Arithmetic) {
  std::vector<std::string> all;
  for (const char* e : {"1+2*3",
                        "(1+2)*3",
                        "2-3-4",
                        "12/4/3",
                        "-2*3",
                        "- -2",
                        "+3",
                        "2*-3",
                        "-A*A",
                        "!0",
                        "!3",
                        "!-A",
                        "1<2",
                        "2<=2",
                        "2=2",
                        "2!=2",
                        "3>=4",
                        "3>4",
                        "2=2.00000000001",
                        "2<=1.99999999999",
                        "1&0",
                        "1|0",
                        "1&2|0",
                        "0|1&0",
                        "1?2:3",
                        "0?2:(1?4:5)",
                        "(A>1)*10",
                        "1/3",
                        "1e-3+.5",
                        "1.e2",
                        "7/0.0000001",
                        "V.x",
                        "V.y*V.z",
                        "P.u+P.v",
                        "C.red",
                        "C.filter",
                        "C.transmit",
                        "C.t",
                        "C.gray",
                        "V.z-Arr[1]",
                        "M[1][2]",
                        "Arr[A-1]",
                        "Arr[0.999999999999]",
                        "-V.x",
                        "\"a\"<\"b\"",
                        "S=\"Hello\"",
                        "S!=\"x\"",
                        "pi",
                        "true",
                        "off",
                        "yes+on",
                        "clock",
                        "clock_delta",
                        "frame_number",
                        "image_width",
                        "image_height",
                        "version",
                        "final_clock"}) {
    all.push_back(number(e));
  }
  expect_same_strings(kSetup, all);
}

TEST(CompatLanguage, FloatFunctions) {
  std::vector<std::string> all;
  for (const char* e : {"abs(-3.5)",
                        "acos(.3)",
                        "asin(.3)",
                        "atan2(1,-2)",
                        "sin(1)",
                        "cos(1)",
                        "tan(1)",
                        "sinh(1)",
                        "cosh(1)",
                        "tanh(1)",
                        "asinh(1)",
                        "acosh(2)",
                        "atanh(.5)",
                        "ceil(-2.2)",
                        "floor(-2.2)",
                        "int(-2.7)",
                        "int(2.7)",
                        "degrees(1)",
                        "radians(90)",
                        "div(7,2)",
                        "div(-7,2)",
                        "mod(7.5,2)",
                        "mod(-7.5,2)",
                        "exp(1.5)",
                        "ln(3)",
                        "log(3)",
                        "max(1,5,3)",
                        "min(4,2,3)",
                        "pow(2,.5)",
                        "pow(-2,3)",
                        "sqrt(2)",
                        "select(-1,1,2)",
                        "select(0,1,2,3)",
                        "select(1,1,2,3)",
                        "select(0,1,2)",
                        "bitwise_and(12,10)",
                        "bitwise_or(12,10,1)",
                        "bitwise_xor(12,10)",
                        "strlen(S)",
                        "strcmp(S,\"Help\")",
                        "strcmp(S,S)",
                        "asc(S)",
                        "val(\"1.5e1x\")",
                        "vdot(V,<3,2,1>)",
                        "vlength(V)",
                        "vlength(P)",
                        "defined(A)",
                        "defined(Nothing)",
                        "defined(Arr[1])",
                        "dimension_size(M,1)",
                        "dimension_size(M,2)",
                        "dimensions(M)",
                        "file_exists(\"colors.inc\")",
                        "file_exists(\"nosuch.inc\")"}) {
    all.push_back(number(e));
  }
  expect_same_strings(kSetup, all);
}

TEST(CompatLanguage, Vectors) {
  std::vector<std::string> all;
  for (const char* e : {"1+<1,2,3>",
                        "<1,2>+<1,2,3>",
                        "2*<1,2,3>/4",
                        "V*V",
                        "-V",
                        "!<0,1,2>",
                        "x+2*y",
                        "V-1",
                        "u+x",
                        "t+<1,1,1,1>",
                        "<1 2 3>",
                        "<V.x,V.y*2,3,>",
                        "vcross(x,y)",
                        "vnormalize(<3,4,0>)",
                        "vrotate(<1,2,3>,<10,20,30>)",
                        "vaxis_rotate(<1,2,3>,<1,1,0>,40)",
                        "vaxis_rotate(x,z,90)",
                        "vrotate(x,90*y)",
                        "3*P",
                        "1/V",
                        "C*2",
                        "x*5"}) {
    all.push_back(vector(3, e));
  }
  all.push_back(vector(5, "C"));
  all.push_back(vector(5, "C*.5+V"));
  all.push_back(vector(4, "t*3"));
  all.push_back(vector(5, "<1,2,3,4,5>+1"));
  all.push_back(vector(2, "u*3+v"));
  expect_same_strings(kSetup, all);
}

TEST(CompatLanguage, Colours) {
  const std::vector<std::string> colours = {"rgb 1",
                                            "rgb <.1,.2,.3>",
                                            "rgbf .5",
                                            "rgbf <.1,.2,.3,.4>",
                                            "rgbt .5",
                                            "rgbt <.1,.2,.3,.4>",
                                            "rgbft <.1,.2,.3,.4,.5>",
                                            "rgbft .3",
                                            "color red 1 green .5",
                                            "colour rgb <1,0,0>*.5",
                                            "C*2",
                                            "color C",
                                            "color red .3 blue .2 filter .7",
                                            "rgb <1,2,3> filter .5",
                                            "rgb <1,.5,.25> transmit .25",
                                            "srgb .5",
                                            "srgb <.1,.02,.9>",
                                            "srgbf <.5,.2,.1,.3>",
                                            "srgbt <.5,.2,.1,.3>",
                                            "srgbft <.5,.2,.1,.3,.4>",
                                            "rgb C.red*x",
                                            "red 1 blue 1",
                                            "<.1,.2,.3,.4,.5>",
                                            "rgb 1/3"};
  std::string setup = kSetup;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const std::string name = "Col" + std::to_string(i);
    setup += "#declare " + name + " = " + colours[i] + ";\n";
    all.push_back(vector(5, name));
  }
  expect_same_strings(setup, all);
}

TEST(CompatLanguage, Strings) {
  expect_same_strings(kSetup, {"str(3.14159,0,2)",
                               "str(-1.5,10,3)",
                               "str(1.5,-8,2)",
                               "str(2,5,0)",
                               "str(1/3,0,-1)",
                               "str(1e300,0,0)",
                               "vstr(3,V,\",\",0,1)",
                               "vstr(2,V,\"|\",6,1)",
                               "vstr(5,P,\" \",0,1)",
                               "concat(S,\" \",\"x\")",
                               "chr(65)",
                               "substr(S,2,3)",
                               "strupr(S)",
                               "strlwr(S)",
                               "concat(S)",
                               "\"tab\\tquote\\\"back\\\\\"",
                               "substr(S,1,0)",
                               "str(0.5,0,0)",
                               "str(1.5,0,0)",
                               "str(2.5,0,0)",
                               "str(-0.0001,0,2)"});
}

TEST(CompatLanguage, RandomStreams) {
  std::string setup = kSetup;
  std::vector<std::string> all;
  for (const char* seed : {"42", "0", "-5", "123456789", "3.7"}) {
    const std::string name = "R" + std::to_string(all.size());
    setup += "#declare " + name + " = seed(" + seed + ");\n";
    for (int i = 0; i < 4; ++i) all.push_back("str(rand(" + name + "),0,17)");
  }
  expect_same_strings(setup, all);
}

TEST(CompatLanguage, Splines) {
  const std::string points = " 0,<1,2,3> 1,<2,4,1> 2.5,<0,0,0> 3,<1,1,1> 4.2,<-1,3,2> }\n";
  std::string setup = kSetup;
  std::vector<std::string> all;
  for (const char* kind :
       {"", "linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"}) {
    const std::string name = "Sp" + std::to_string(all.size());
    setup += "#declare " + name + " = spline { " + kind + points;
    for (const char* t : {"-1", "0", ".3", "1", "1.7", "2.6", "2.9", "3.5", "4.2", "9"}) {
      all.push_back(vector(3, name + "(" + t + ")"));
    }
  }
  all.push_back(vector(3, "Sp0(1.7,cubic_spline)"));
  expect_same_strings(setup, all);
}

TEST(CompatLanguage, Transforms) {
  std::string setup = kSetup;
  std::vector<std::string> all;
  for (const char* body :
       {"rotate 30*x", "rotate <10,20,30>", "translate <1,2,3> scale 2",
        "scale <1,2,3> rotate 45*y translate -x", "matrix <1,.2,.3,.4,1,.6,.7,.8,1,2,3,4>",
        "rotate <10,20,30> translate x inverse", "transform { rotate 20*z } translate 1",
        "scale 2 transform { translate x inverse }"}) {
    const std::string name = "T" + std::to_string(all.size());
    setup += "#declare " + name + " = transform { " + std::string(body) + " }\n" + "#declare F" +
             name + " = function { transform { " + name + " } }\n";
    all.push_back(vector(3, "F" + name + "(1,2,3)"));
  }
  expect_same_strings(setup, all);
}

}  // namespace
}  // namespace lentray::test
