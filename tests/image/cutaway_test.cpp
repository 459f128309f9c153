// cutaway_textures against stock: which surfaces of a CSG are without a texture, and what they
// show instead.
#include "tests/image/shading_scenes.h"

namespace lentray::test {
namespace {

constexpr const char* kLooks = R"(
#default { pigment { rgb <.2,.9,.3> } }
#declare A = texture { pigment { checker rgb <.9,.5,.2> rgb <.9,.9,.2> scale .3 } finish { phong .5 } }
#declare B = texture { pigment { gradient y color_map { [0 rgb <.2,.4,.9>] [1 rgb <1,.4,.9>] } scale .5 } }
#declare Ball = sphere { y, 1 texture { A } }
#declare Notch = box { <-.2,.8,-2>, <2,3,.1> }
#declare Cube = box { <-.7,.3,-.7>, <.7,1.7,.7> }
#declare Bore = cylinder { <-.3,1,-3>, <-.3,1,3>, .2 }
#declare Ball2 = sphere { <.5,1.2,-.6>, .4 }
)";

struct CutawayCase {
  const char* name;
  const char* sdl;
};

// Where a nested part's own surface is asked whether the point is in that part, its inside()
// decides by the last bit for spheres; boxes, planes and cylinders always say the same.
const CutawayCase kCutawayCases[] = {
    {"difference", "difference { object { Ball } object { Notch } cutaway_textures }"},
    {"intersection", "intersection { object { Ball } object { Cube } cutaway_textures }"},
    {"mean_of_two",
     "intersection { object { Cube texture { A } } cylinder { 0, 3*y, .8 }"
     " sphere { y, 1 texture { B } } cutaway_textures }"},
    {"plane",
     "intersection { object { Ball } plane { -z, .3 } plane { y, 1.3 texture { B } }"
     " cutaway_textures }"},
    {"no_texture_at_all", "difference { sphere { y, 1 } object { Notch } cutaway_textures }"},
    {"texture_of_the_whole",
     "difference { object { Ball } object { Notch } cutaway_textures texture { B } }"},
    {"first_part_without",
     "difference { sphere { y, 1 } object { Notch texture { B } } cutaway_textures }"},
    {"some_cuts_textured",
     "difference { object { Ball } object { Notch texture { B } }"
     " cylinder { -3*z + y, 3*z + y, .3 } cutaway_textures }"},
    {"union_cut",
     "difference { union { sphere { <-.4,1,0>, .8 texture { A } }"
     " sphere { <.4,1,0>, .8 texture { B } } } object { Notch } cutaway_textures }"},
    {"union_cut_half_textured",
     "difference { union { sphere { <-.4,1,0>, .8 texture { A } }"
     " sphere { <.4,1,0>, .8 } } object { Notch } cutaway_textures }"},
    {"merge_cut",
     "difference { merge { sphere { <-.4,1,0>, .8 texture { A } }"
     " sphere { <.4,1,0>, .8 texture { B } } } object { Notch } cutaway_textures }"},
    {"cut_by_half_textured_union",
     "difference { object { Ball } union { object { Notch }"
     " object { Bore texture { B } } } cutaway_textures }"},
    {"cut_by_union",
     "difference { object { Ball } union { object { Notch } sphere { <-.6,1.2,-.8>, .4 } } "
     "cutaway_textures }"},
    {"cut_by_difference",
     "difference { object { Ball } difference { object { Notch } object { Ball2 } } "
     "cutaway_textures }"},
    {"inner_of_intersection",
     "intersection { difference { object { Ball } object { Notch }"
     " cutaway_textures } object { Cube texture { B } } }"},
    {"both_of_nested_differences",
     "difference { difference { object { Ball } object { Notch } cutaway_textures }"
     " object { Bore } cutaway_textures }"},
    {"outer_of_nested_differences",
     "difference { difference { object { Ball } object { Notch } } object { Bore } "
     "cutaway_textures }"},
    {"in_union",
     "union { difference { object { Ball } object { Notch } cutaway_textures } object { Ball2 } }"},
    {"in_clipped_union",
     "union { difference { object { Ball } object { Notch } cutaway_textures } object { Ball2 }"
     " clipped_by { box { -1.5, 1.5 } } }"},
    {"in_textured_union",
     "union { difference { object { Ball } object { Notch } cutaway_textures } object { Ball2 }"
     " texture { B } }"},
    {"in_merge",
     "merge { difference { object { Ball } object { Notch } cutaway_textures }"
     " object { Ball2 texture { B } } }"},
    {"bounded",
     "difference { object { Ball } object { Notch }"
     " bounded_by { box { <-1.1,0,-1.1>, <.6,2.1,1.1> } } cutaway_textures }"},
    {"clipped",
     "difference { object { Ball } object { Notch } cutaway_textures"
     " clipped_by { box { <-1.1,0,-1.1>, <.6,2.1,1.1> } } }"},
    {"inverse",
     "intersection { difference { object { Ball } object { Notch } cutaway_textures inverse }"
     " sphere { y, 1.2 } }"},
    {"interior_texture",
     "difference { cylinder { 0, 2*y, 1 open texture { A } interior_texture { B } }"
     " object { Notch } cutaway_textures }"},
    {"glass",
     "difference { sphere { y, 1 pigment { rgbf <1,.8,.8,.9> } interior { ior 1.3 } }"
     " object { Notch } cutaway_textures }"},
    {"filter_in_places",
     "difference { sphere { y, 1 pigment { checker rgbt <1,.8,.8,.9> rgb .7 scale .5 } }"
     " object { Notch } cutaway_textures }"},
    {"moved",
     "#declare D = difference { sphere { 0, 1 texture { A } } box { <-.2,-.2,-2>, <2,3,.1> }"
     " cutaway_textures }"
     "object { D rotate 20*z translate y }"
     "object { D scale .5 translate <1.5,.5,-1> texture { B } }"},
    {"layers_and_maps",
     "difference { sphere { y, 1 texture { A } texture { pigment { rgbt <1,0,0,.7> } } }"
     " object { Notch } cutaway_textures translate -.8*x }"
     "intersection { sphere { y, 1 texture { gradient x texture_map { [0 A] [1 B] } } }"
     " object { Cube } cutaway_textures translate <.9,0,1> }"},
    {"text_cuts",
     "difference { object { Cube texture { A } }"
     " text { internal 1 \"A\" 1, 0 scale 1.2 translate <-.4,.5,-1> } cutaway_textures }"},
    {"blob_is_cut",
     "difference { blob { threshold .4 sphere { <-.4,1,0>, 1, 1 }"
     " sphere { <.5,1,0>, .9, 1 } texture { A } } object { Notch } cutaway_textures }"},
    {"mesh_is_cut",
     "difference { mesh { triangle { <-1,0,-1>, <1,0,-1>, <0,2,0> }"
     " triangle { <1,0,-1>, <0,0,1>, <0,2,0> } triangle { <0,0,1>, <-1,0,-1>, <0,2,0> }"
     " triangle { <-1,0,-1>, <1,0,-1>, <0,0,1> } inside_vector y texture { B } }"
     " object { Notch } cutaway_textures }"},
    {"looks_like",
     "light_source { <.5,2,-3> rgb .3 looks_like { difference { sphere { <-.6,-.9,2.8>, .7"
     " texture { A } } box { <-.7,-.9,0>, <2,3,2.8> } cutaway_textures } } }"},
};

class ImageCutaway : public ::testing::TestWithParam<CutawayCase> {};

TEST_P(ImageCutaway, AsStock) {
  EXPECT_TRUE(same_as_stock(staged(kLooks + std::string(GetParam().sdl) + "\n")));
}

INSTANTIATE_TEST_SUITE_P(Each, ImageCutaway, ::testing::ValuesIn(kCutawayCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::test
