// no_image and no_reflection of parts of CSG, against stock: parts of a merge are left out for the rays that
// do not see them, inside and all; parts of a union as well, but for rays straight from the camera; parts of
// differences and intersections go by the flags of the whole.
#include "tests/image/shading_scenes.h"

namespace lentray::test {
namespace {

struct PartVisibilityCase {
  const char* name;
  const char* sdl;  ///< FLAG stands for either flag
};

#define RED "sphere { <-.5,1,0>, .8 pigment { rgb <1,.3,.2> } "
#define BLUE "sphere { <.5,1,-.2>, .7 pigment { rgb <.2,.3,1> } "
#define ROD "cylinder { <-1.5,1,0>, <1.5,1,0>, .3 pigment { rgb y } }"
#define BLOCK "box { <-1,0,-.3>, <1,2,1> pigment { rgb y } }"
#define CUT " clipped_by { plane { y, 1.4 } }"
#define PANE \
  "box { <-2,0,-1.6>, <2,2.5,-1.5> pigment { rgbt <.9,1,.9,.9> } finish { reflection .1 } }"

const PartVisibilityCase kPartVisibilityCases[] = {
    {"merge", "merge {" RED "FLAG }" BLUE "} }"},
    {"merge_behind_a_pane", PANE "merge {" RED "FLAG }" BLUE "} }"},
    {"merge_clipped", "merge {" RED "}" BLUE "FLAG }" CUT "}"},
    {"merge_of_many", "merge {" RED "FLAG } #for (I, 0, 9) sphere { <(I - 4)*.4, .4 + .1*I, -.8>, "
                      ".25 pigment { rgb <mod(I, 2),1,0> }"
                      " #if (mod(I, 3) = 0) FLAG #end } #end }"},
    {"merge_in_merge", "merge { merge {" RED "FLAG }" BLUE "} }" ROD "}"},
    {"merge_in_union", "union { merge {" RED "FLAG }" BLUE "} }" ROD CUT "}"},
    {"merge_in_intersection", "intersection { merge {" RED "FLAG }" BLUE "} }" BLOCK "}"},
    {"merge_is_cut", "difference { merge {" RED "FLAG }" BLUE "} }" ROD "}"},
    {"merge_cuts", "difference {" BLOCK "merge {" RED "FLAG }" BLUE "} } }"},
    {"merge_clear",
     "merge { sphere { <-.5,1,0>, .8 FLAG } sphere { <.5,1,0>, .8 } pigment { rgbt <1,.6,.5,.7> } "
     "}"},
    {"intersection", "intersection {" RED "FLAG }" BLUE "} }"},
    {"intersection_cuts", "difference {" BLOCK "intersection {" RED "FLAG }" BLUE "} } }"},
    {"difference_cuts", "difference {" BLOCK "difference {" RED "}" BLUE "FLAG } } }"},
    {"union_clipped", "union {" RED "FLAG }" BLUE "}" CUT "}"},
    {"union_behind_a_pane", PANE "union {" RED "FLAG }" BLUE "}" CUT "}"},
    {"union_in_union", PANE "union { union {" RED "FLAG }" BLUE "} }" ROD CUT "}"},
    {"union_in_merge", "merge { union {" RED "}" BLUE "} FLAG }" ROD "}"},
    {"union_of_flags_in_intersection",
     PANE "intersection { union {" RED "}" BLUE "} FLAG }" BLOCK "}"},
    {"text_in_merge",
     "merge { text { ttf \"cyrvetic.ttf\" \"AB\" .5 0 scale 1.5 translate <-1,.3,0> pigment { rgb "
     "x } FLAG }" ROD "}"},
};

constexpr const char* kMirror =
    "box { <-2.5,0,1.6>, <2.5,3,1.7> pigment { rgb .1 } finish { reflection .7 ambient 0 } }\n";

class ImagePartVisibility : public ::testing::TestWithParam<PartVisibilityCase> {
 protected:
  static std::string with(std::string sdl, const std::string& flag) {
    for (std::size_t at; (at = sdl.find("FLAG")) != std::string::npos;) sdl.replace(at, 4, flag);
    return kMirror + sdl + "\n";
  }
};

TEST_P(ImagePartVisibility, NoImageAsStock) {
  EXPECT_TRUE(same_as_stock(staged(with(GetParam().sdl, "no_image"))));
}

TEST_P(ImagePartVisibility, NoReflectionAsStock) {
  EXPECT_TRUE(same_as_stock(staged(with(GetParam().sdl, "no_reflection"))));
}

INSTANTIATE_TEST_SUITE_P(Each, ImagePartVisibility, ::testing::ValuesIn(kPartVisibilityCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
