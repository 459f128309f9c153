// Directives and dialects: whole little programs whose #debug output must be stock's.
#include "tests/compat/language_help.h"

namespace lentray::test {
namespace {

TEST(CompatLanguage, NestedLoopsAndConditions) {
  expect_same_debug(
      "#version 3.7;\n#declare I = 0;\n#while (I < 5)\n  #declare J = 0;\n  #while (J <= I)\n"
      "    #if (mod(J,2) = 0) #debug \"e\" #else #debug \"o\" #end\n    #declare J = J+1;\n  #end\n"
      "  #switch (I) #case (1) #debug \" one\" #case (2) #debug \" two\" #break #range (3,4) "
      "#debug \" more\" #break\n"
      "  #else #debug \" none\" #end\n  #debug \"\\n\"\n  #declare I = I+1;\n#end\n"
      "#for (K, 10, 0, -2.5) #debug concat(str(K,0,2),\" \") #if (K < 4) #break #end #end\n#debug "
      "\"\\n\"");
}

TEST(CompatLanguage, MacrosScopesAndReferences) {
  expect_same_debug(
      "#version 3.7;\n#declare A = 1; #declare Arr = array[2] {3,4}\n"
      "#macro Add(p, q) #declare p = p + q; #local z_ = p*2; z_ #end\n"
      "#debug concat(str(Add(A,5),0,0), \" \", str(A,0,0), \" \", str(Add(Arr[1],1),0,0), \" \", "
      "str(Arr[1],0,0), \"\\n\")\n"
      "#macro Fib(n) #if (n < 2) n #else (Fib(n-1) + Fib(n-2)) #end #end\n"
      "#debug concat(str(Fib(12),0,0), \"\\n\")\n"
      "#macro Inner() #declare Seen = Hidden; #local Hidden = 9; #declare Hidden = 8; #end\n"
      "#macro Outer() #local Hidden = 5; Inner() #debug concat(str(Seen,0,0), str(Hidden,0,0), "
      "\"\\n\") #end\nOuter()\n"
      "#ifdef (Hidden) #debug \"leaked\\n\" #else #debug \"gone\\n\" #end\n"
      "#macro Vec(n) <n, n+1, n*2> #end\n#debug concat(vstr(3, Vec(2)*2 - x, \",\", 0, 1), "
      "\"\\n\")\n"
      "#declare N = 3; #macro Set() #declare N = N+1; #end Set() Set() #debug concat(str(N,0,0), "
      "\"\\n\")\n"
      "#local N = 10; Set() #debug concat(str(N,0,0), \"\\n\") #undef N #ifndef (N) #debug "
      "\"undefined\\n\" #end");
}

TEST(CompatLanguage, FormerDialect) {
  expect_same_debug(
      "#version 3.1\n#declare A = 1\n#declare B = A+1\n#declare V = <1,2,3>\n#declare C = V.y\n"
      "#declare D = color red 1 green 0.5\n"
      "#debug concat(str(A,0,1), str(B,0,1), str(C,0,1), str(D.green,0,1), str(version,0,2), "
      "\"\\n\")\n"
      "#if (B = 2) #debug \"two\\n\" #end\ndeclare E = 5\n#debug concat(str(E,0,0), \"\\n\")");
}

TEST(CompatLanguage, StandardMacros) {
  expect_same_debug(
      "#version 3.7;\n#include \"math.inc\"\n#include \"strings.inc\"\n#include "
      "\"arrays.inc\"\n#include \"rand.inc\"\n"
      "#include \"transforms.inc\"\n#include \"colors.inc\"\n"
      "#declare L = array[5] {3,1,4,1,5}\n"
      "#debug concat(str(Mean(L),0,6), \" \", str(Std_Dev(L, Mean(L)),0,6), \" \", "
      "str(clip(5,0,3),0,2), \"\\n\")\n"
      "#debug concat(vstr(3, VPerp_To_Plane(<1,2,3>, y), \",\", 0, 6), \" \", str(VAngleD(x, "
      "<1,1,0>),0,6), \"\\n\")\n"
      "#debug concat(vstr(3, VProject_Axis(<1,2,3>, <1,1,1>), \",\", 0, 6), \" \", "
      "str(sind(30),0,6), str(even(4),0,0), \"\\n\")\n"
      "#debug concat(Vstr(<1,2,3>, 4, 2), VStr(x), Str(2.5), \"\\n\")\n"
      "Sort_Array(L)\n#for (I,0,4) #debug str(L[I],0,0) #end #debug \"\\n\"\n"
      "#declare R = seed(7); #debug concat(str(RRand(2,5,R),0,9), vstr(3, VRand(R), \",\", 0, 6), "
      "\"\\n\")\n"
      "#debug concat(vstr(3, vtransform(<1,2,3>, transform { Reorient_Trans(x, <1,1,1>) }), \",\", "
      "0, 6), \"\\n\")\n"
      "#debug concat(vstr(5, Orange, \",\", 0, 4), vstr(3, CHSL2RGB(<200,.5,.5>), \",\", 0, 5), "
      "\"\\n\")\n"
      "#debug concat(vstr(3, vinv_transform(<1,2,3>, transform { Axis_Rotate_Trans(<1,2,0>, 33) "
      "}), \",\", 0, 6), \"\\n\")\n"
      "#debug concat(str(Interpolate(.3,0,1,10,20,2),0,6), \"\\n\")\n");
}

TEST(CompatLanguage, FilesWrittenAndRead) {
  const tool::TemporaryFolder folder;
  const std::string file = "\"" + (folder / "data.txt").string() + "\"";
  expect_same_debug("#version 3.7;\n#fopen F " + file +
                    " write\n#for (I,1,3) #write (F, I, \",\", <I,I*I,1/I>, "
                    "\",\\\"s\", str(I,0,0), \"\\\",\\n\") #end\n"
                    "#fclose F\n#fopen F " +
                    file +
                    " read\n#while (defined(F)) #read (F, A, B, C)\n"
                    "#debug concat(str(A,0,2), \" \", vstr(3,B,\",\",0,6), C, \"\\n\") #end\n");
}

}  // namespace
}  // namespace lentray::test
