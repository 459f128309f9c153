// function {}: compiled programs against stock's, and the internal functions that are arithmetic.
#include "tests/compat/language_help.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

TEST(CompatFunctions, Expressions) {
  const std::vector<std::string> bodies = {"x+y*z",
                                           "(x+y)*z",
                                           "-x*-y",
                                           "x/y-z/x",
                                           "x<y",
                                           "(x<=y)+(y>=z)*2",
                                           "(x=1)+(y!=2)",
                                           "(x>0)&(y<0)",
                                           "(x>0)|(y<0)",
                                           "sin(x)*cos(y)+tan(z)",
                                           "sinh(x)+cosh(y)+tanh(z)",
                                           "asin(x/10)+acos(y/10)+atan2(y,x)",
                                           "exp(x)+ln(y)+log(z)",
                                           "pow(x,y)+sqrt(z)+sqrt(x)",
                                           "abs(-y)+int(2.7*x)+floor(-x/3)+ceil(y/3)",
                                           "max(x,y,z)-min(x,y,z)",
                                           "mod(y*3.3,z)",
                                           "select(x-y,1,2)",
                                           "select(x-y,1,2,3)",
                                           "select(x-1,y,z,5)",
                                           "degrees(x)+radians(y)",
                                           "sum(i_,1,4,i_*x)",
                                           "prod(i_,1,3,i_+y)",
                                           "sum(i_,1,3,sum(j_,1,i_,j_*x))",
                                           "K*x+pi",
                                           "K*x*x-K",
                                           "G(x,y)+G(z,1)",
                                           "G(G(x,y),z)",
                                           "atan2(0.0000001+x*0,1)",
                                           "x-y-z",
                                           "x/y/z",
                                           "2*x+3*y-4*z+5",
                                           "asinh(x)+acosh(y)+atanh(x/10)"};
  std::string setup =
      "#version 3.7; #declare K = 2.5; #declare V = <1,2,3>; #declare C = rgb <.1,.2,.3>;\n"
      "#declare G = function(a,b) { a*a - b/3 }\n";
  std::vector<std::string> all;
  for (const std::string& body : bodies) {
    const std::string name = "f" + std::to_string(all.size()) + "_";
    setup += "#declare " + name + " = function { " + body + " }\n";
    all.push_back(number(name + "(1,2,3)") + ", \" \", " + number(name + "(1.7,-0.3+4,0.25)"));
  }
  expect_same_strings(setup, all);
}

TEST(CompatFunctions, ParametersOfAnyName) {
  expect_same_strings(
      "#version 3.7; #declare f = function(a, x, q2) { a*100 + x*10 + q2 }\n"
      "#declare g = function(u,v) { u-v }\n"
      "#declare h = function { u + 10*v }\n",
      {number("f(1,2,3)"), number("g(5,3)"), number("h(4,5,6)")});
}

/// Through the program: functions of pigments need the grammar of materials.
TEST(CompatFunctions, OfPatternsAndPigments) {
  // Colours are single precision: six digits.
  const auto six = [](const std::string& e) { return "str((" + e + "),0,6)"; };
  const std::vector<std::string> values{six("P(.3,.4,.5)"),
                                        six("Q(.3,.4,.5)"),
                                        six("R(.3,.4,.5).red"),
                                        six("R(1.3,2.4,.5).blue"),
                                        six("R(1.3,2.4,.5).transmit"),
                                        six("R(.3,.2,.1).gray"),
                                        six("S(.77)")};
  std::string sdl =
      "#version 3.7;\n"
      "#declare P = function { pattern { bozo scale .7 turbulence .2 } }\n"
      "#declare Q = function { pattern { gradient x sine_wave rotate 20*z } }\n"
      "#declare R = function { pigment { crackle color_map { [0 rgb <1,.5,.2>] [1 rgbt "
      "<0,.3,.9,.4>] } } }\n"
      "#declare S = function(a) { P(a, a*2, 1) + 2*Q(a, 0, 0) + R(a, a, a).green }\n";
  for (const std::string& value : values)
    sdl += "#debug concat(\"value \", " + value + ", \"\\n\")\n";
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "scene.pov", sdl);
  const tool::RunResult ours = run_lentray({"scene.pov", "+W4", "+H4", "-F"}, folder.path());
  const std::vector<std::string> wanted = lines_of(stock_debug(sdl));
  ASSERT_EQ(wanted.size(), values.size());
  for (const std::string& line : wanted) {
    EXPECT_NE(ours.output.find(line + "\n"), std::string::npos) << line << "\n" << ours.output;
  }
}

TEST(CompatFunctions, Internal) {
  std::vector<std::string> all;
  for (const char* e : {"f_sphere(1,2,3,0.5)",
                        "f_r(1,2,3)",
                        "f_th(1,2,3)",
                        "f_ph(1,2,3)",
                        "f_torus(1,.2,3,2,.5)",
                        "f_ellipsoid(1,2,3,.5,1,2)",
                        "f_superellipsoid(.3,.4,.5,.2,.8)",
                        "f_rounded_box(1,2,-3,.1,.5,.6,.7)",
                        "f_paraboloid(1,2,.3,1)",
                        "f_pillow(.3,.4,.5,1)",
                        "f_helix1(1,2,.3,2,3,.2,1,1,1,0)",
                        "f_helix1(1,2,.3,2,3,.2,1,.8,.5,30)",
                        "f_spiral(1,.2,3,.8,.1,3,.5,.1,1)",
                        "f_spiral(1,.2,3,.8,.1,3,.5,.1,.5)",
                        "f_hex_x(1,2,3,0)",
                        "f_hex_y(1.4,.2,3,0)",
                        "f_noise3d(.3,1.4,2.5)",
                        "f_noise_generator(.3,1.4,2.5,1)",
                        "f_noise_generator(.3,1.4,2.5,3)",
                        "f_ridge(.3,.4,.5,2,4.5,.6,.4,.3,2)",
                        "f_ridged_mf(.3,.4,.5,.8,2.1,5,.9,2,3)",
                        "f_hetero_mf(.3,.4,.5,.8,2.1,5.5,.7,2,2)",
                        "f_hex_x(.2,4.1,0,0)",
                        "f_hex_y(-.8,1,0,0)"}) {
    all.push_back(number(e));
  }
  expect_same_strings("#version 3.7;\n#include \"functions.inc\"", all);
}

}  // namespace
}  // namespace lentray::test
