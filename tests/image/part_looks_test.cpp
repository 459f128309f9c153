// Looks that objects of several parts hand down or keep apart, against stock: textures of a mesh's corners,
// texture coordinates of a patch's corners, who is hollow in a CSG.
#include "tests/image/shading_scenes.h"

namespace lentray::test {
namespace {

struct PartLooksCase {
  const char* name;
  const char* sdl;
};

constexpr const char* kPartLooksLooks = R"(
#declare A = texture { pigment { rgb <.9,.2,.1> } }
#declare B = texture { pigment { checker rgb <.2,.8,.2> rgb 1 scale .2 } finish { reflection .3 } }
#declare C = texture { pigment { rgb <.2,.3,.9> } finish { phong 1 } }
#declare Over = texture { pigment { gradient y color_map { [0 rgbt 1] [1 rgb <1,1,0>] } } }
#declare Clear = texture { pigment { rgbt <.8,1,.8,.8> } finish { specular .4 } }
)";

#define PATCH(uvs)                                                                             \
  "bicubic_patch { type 1 u_steps 3 v_steps 3 " uvs                                            \
  " <-1,1,-1>,<-.5,1.5,-1.2>,<.5,1,-1>,<1.2,.8,-1>,"                                           \
  "<-1,1,-.5>,<-.5,2,-.5>,<.5,2,-.5>,<1,1,-.5>,<-1,1,.5>,<-.5,2,.5>,<.5,.7,.5>,<1,1,.5>,"      \
  "<-1,1,1>,<-.5,1,1>,<.5,1,1.4>,<1,1.3,1> uv_mapping pigment { checker rgb <.9,.4,.1> rgb 1 " \
  "scale .1 } }"
#define FOG "fog { distance 4 color rgb <.3,.5,.8> }"

const PartLooksCase kPartLooksCases[] = {
    {"corner_textures",
     "mesh { triangle { <-1,0,.5>, <1,0,.5>, <0,2,0> texture_list { A B C } }"
     " smooth_triangle { <1,0,.5>, -z, <-1,0,.5>, y, <0,1,-1.5>, x texture_list { C, A, B } } }"},
    {"corner_textures_win",
     "mesh { triangle { <-1,0,.5>, <1,0,.5>, <0,2,0> texture { B } texture_list { A A C } }"
     " triangle { <1,0,.5>, <-1,0,.5>, <0,1,-1.5> } texture { A } rotate 20*y }"},
    {"last_texture_of_a_triangle",
     "mesh { triangle { <-1,0,.5>, <1,0,.5>, <0,2,0> texture { B } texture { Over } }"
     " triangle { <1,0,.5>, <-1,0,.5>, <0,1,-1.5> texture { A } texture { C } texture { Over } } "
     "}"},
    {"uv_vectors_of_a_patch", PATCH("uv_vectors <.2,.1>, <.9,0>, <.8,1>, <0,.8>")},
    {"uv_vectors_of_a_turned_patch",
     "object {" PATCH("uv_vectors <0,0>, <0,2>, <1,2>, <1,0>") "rotate 30*y scale <1,1,.8> }"},
    {"uv_vectors_none", "object {" PATCH("") "rotate 30*y }"},
    {"hollow_last_of_union",
     FOG "union { sphere { <-1,1,0>, .8 } sphere { <1,1,0>, .8 hollow } texture { Clear } }"},
    {"hollow_first_of_union",
     FOG "union { sphere { <-1,1,0>, .8 hollow } sphere { <1,1,0>, .8 } texture { Clear } }"},
    {"hollow_with_interiors",
     FOG "union { sphere { <-1,1,0>, .8 hollow interior {} } sphere { <1,1,0>, .8 }"
         " sphere { <0,1,-1>, .5 interior {} } texture { Clear } }"},
    {"hollow_whole_but_last", FOG "union { sphere { <-1,1,0>, .8 } sphere { <1,1,0>, .8 hollow off "
                                  "} texture { Clear } hollow }"},
    {"hollow_of_nested", FOG "union { sphere { <-1,1,0>, .8 } union { sphere { <1,1,0>, .6 } "
                             "sphere { <1,1,.5>, .6 } hollow }"
                             " texture { Clear } }"},
    {"hollow_in_intersection", FOG
     "intersection { sphere { <-.2,1,0>, .9 } sphere { <.2,1,0>, .9 hollow } texture { Clear } }"},
    {"hollow_in_difference", FOG "difference { box { <-1,0,-1>, <1,2,1> hollow } sphere { "
                                 "<.5,1,-.5>, .9 } texture { Clear } }"},
    {"hollow_in_merge",
     FOG "merge { sphere { <-.3,1,0>, .9 } sphere { <.3,1,0>, .9 hollow } texture { Clear } }"},
    {"hollow_with_ior", FOG "union { sphere { <-1,1,0>, .8 hollow } sphere { <1,1,0>, .8 } texture "
                            "{ Clear } interior { ior 1.2 } }"},
    {"overlap_in_union", FOG "union { sphere { <-.4,1,0>, .8 texture { Clear } } sphere { "
                             "<.4,1,-.2>, .8 texture { Clear } } }"},
    {"overlap_in_nested_unions", FOG
     "union { union { sphere { <-.4,1,0>, .8 } sphere { <.4,1,-.2>, .8 } } sphere { <0,1.5,0>, .5 }"
     " texture { Clear } }"},
    {"overlap_around_the_camera",
     FOG "union { sphere { <0,2,-6>, 3 } sphere { <.5,2,-1.5>, 2 } texture { Clear } }"},
    {"camera_in_two_parts",
     FOG "union { sphere { <0,2,-6>, 3 } sphere { <.5,2,-5.5>, 2 } texture { Clear } }"},
    {"camera_in_parts_of_nested_unions",
     FOG "union { union { sphere { <0,2,-6>, 3 } sphere { <.5,2,-5.5>, 2 } }"
         " sphere { <0,2.2,-6.2>, 1 } texture { Clear } }"},
    {"camera_in_two_parts_that_refract",
     "union { sphere { <0,2,-6>, 3 } sphere { <.5,2,-5.5>, 2 } texture { Clear }"
     " interior { ior 1.2 fade_power 2 fade_distance 2 } }"},
    {"camera_in_two_parts_kept_whole",
     FOG "union { sphere { <0,2,-6>, 3 } sphere { <.5,2,-5.5>, 2 } texture { Clear }"
         " split_union off }"},
    {"camera_in_two_parts_of_a_merge",
     FOG "merge { sphere { <0,2,-6>, 3 } sphere { <.5,2,-5.5>, 2 } texture { Clear } }"},
    {"overlap_in_union_that_refracts",
     FOG "union { sphere { <-.4,1,0>, .8 interior { ior 1.2 } } sphere { <.4,1,-.2>, .8 }"
         " sphere { <0,1.5,0>, .5 } texture { Clear } }"},
    {"blob_of_negative_radius",
     "blob { threshold .3 sphere { y, -1.1, 1 } cylinder { <-1,.6,0>, <1,.6,-.3>, -.6, 1 } texture "
     "{ C } }"},
};

class ImagePartLooks : public ::testing::TestWithParam<PartLooksCase> {};

TEST_P(ImagePartLooks, AsStock) {
  EXPECT_TRUE(same_as_stock(staged(kPartLooksLooks + std::string(GetParam().sdl) + "\n")));
}

INSTANTIATE_TEST_SUITE_P(Each, ImagePartLooks, ::testing::ValuesIn(kPartLooksCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
