// interior_texture and double_illuminate against stock, on shapes with two sides, in CSG and copied.
#include "tests/image/shading_scenes.h"

namespace lentray::test {
namespace {

struct ObjectLooksCase {
  const char* name;
  const char* sdl;
};

constexpr const char* kObjectLooksLooks = R"(
#declare Out = texture { pigment { checker rgb <.9,.5,.2> rgb <.9,.9,.2> scale .3 } finish { phong .5 } }
#declare In = texture { pigment { gradient y color_map { [0 rgb <.2,.4,.9>] [1 rgb <.3,1,.5>] } scale .5 } }
#declare Clear = texture { pigment { rgbf <.8,.9,1,.8> } finish { specular .5 } }
light_source { <3, 5, 8>, .5 }
)";

const ObjectLooksCase kObjectLooksCases[] = {
    {"interior_texture_mesh",
     "mesh { triangle { <-1,0,.5>, <1,0,.5>, <0,2,0> } triangle { <1,0,.5>, <-1,0,.5>, <0,1,-1.5> }"
     " texture { Out } interior_texture { In } }"},
    {"interior_texture_disc",
     "disc { <-.7,1,0>, <1,0,-1>, .8 texture { Out } interior_texture { In } }"
     "disc { <.9,1,0>, <1,0,1>, .8 texture { Out } interior_texture { In } }"},
    {"interior_texture_plane",
     "plane { <1,0,-2>, -2 texture { Out } interior_texture { In } }"
     "plane { <1,0,2>, 3 texture { Out } interior_texture { In } }"},
    {"interior_texture_height_field",
     "height_field { function 12, 12 { .5 + .4*sin(x*9)*cos(y*8) } rotate 120*x"
     " scale 2 translate <-1,2,.5> texture { Out } interior_texture { In } }"},
    {"interior_texture_of_the_union",
     "union { cylinder { <-.6,0,0>, <-.6,1.5,0>, .5 open }"
     " cone { <.6,0,0>, .3, <.6,1.5,0>, .7 open texture { In } }"
     " texture { Out } interior_texture { In } }"},
    {"interior_texture_of_a_part",
     "difference { sphere { y, 1 texture { Out } interior_texture { In } }"
     " box { <-2,.8,-2>, <2,3,.1> texture { In } interior_texture { Out } } }"},
    {"interior_texture_inverse",
     "intersection { sphere { y, 1 inverse texture { Out } interior_texture { In } }"
     " box { <-1.1,0,-.9>, <1.1,1.6,1> texture { Out } } }"},
    {"interior_texture_seen_through", "sphere { y, 1 texture { Clear } interior_texture { Out } }"},
    {"interior_texture_clear_within",
     "sphere { y, 1 texture { Out } interior_texture { Clear }"
     " clipped_by { plane { z, .3 } plane { -z, .3 } } }"},
    {"interior_texture_casts_colour",
     "cylinder { 0, 1.6*y, .8 open texture { Clear }"
     " interior_texture { pigment { rgbf <1,.3,.3,.7> } } }"},
    {"interior_texture_copied",
     "#declare O = cylinder { -y, y, .5 open texture { Out } interior_texture { In } }"
     "object { O rotate 40*x translate <-.8,1,0> }"
     "object { O rotate 70*x translate <.8,1,0> texture { In } }"},
    {"interior_texture_layers",
     "cylinder { 0, 1.6*y, .8 open texture { Out } interior_texture { In }"
     " interior_texture { pigment { checker rgbt 1 rgbt <1,0,0,.3> scale .2 } } }"},
    {"double_illuminate_sheets",
     "disc { <-.7,1,0>, <.3,0,-1>, .7 texture { Out } double_illuminate }"
     "disc { <.8,1,0>, <.3,0,-1>, .7 texture { Out } }"},
    {"double_illuminate_solid", "sphere { y, 1 texture { Out } double_illuminate }"},
    {"double_illuminate_clear",
     "sphere { y, 1 texture { Clear } double_illuminate }"
     "cylinder { <1.5,0,-.5>, <1.5,1,-.5>, .4 open texture { Clear } double_illuminate }"},
    {"double_illuminate_union",
     "union { disc { <-.7,1,0>, <.3,0,-1>, .7 } polygon { 4, <.2,.3>, <1.6,.5>, <.9,1.7>, <.2,.3> }"
     " texture { Out } double_illuminate }"},
    {"double_illuminate_of_a_part",
     "difference { sphere { y, 1 texture { Out } double_illuminate }"
     " box { <-2,.8,-2>, <2,3,.1> texture { In } } }"},
    {"double_illuminate_two_sided",
     "cylinder { 0, 1.6*y, .8 open texture { Out } interior_texture { In }"
     " double_illuminate rotate 20*x }"},
    {"double_illuminate_normal",
     "box { <-1,.2,0>, <1,1.8,.02> texture { Out normal { bumps .7 scale .2 } }"
     " double_illuminate }"},
};

class ImageObjectLooks : public ::testing::TestWithParam<ObjectLooksCase> {};

TEST_P(ImageObjectLooks, AsStock) {
  EXPECT_TRUE(same_as_stock(staged(kObjectLooksLooks + std::string(GetParam().sdl) + "\n")));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageObjectLooks, ::testing::ValuesIn(kObjectLooksCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
