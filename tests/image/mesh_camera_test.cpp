// mesh_camera in all its distributions, and cameras whose rays a normal bends.
#include <gtest/gtest.h>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kMeshCameraStage = R"(#version 3.7; global_settings { assumed_gamma 1 }
light_source { <1,6,-3>, 1 }
plane { y, -1 pigment { checker rgb <.9,.8,.3> rgb <.2,.3,.7> scale .7 } }
sphere { <0,0,3>, .8 pigment { rgb <.9,.2,.2> } finish { phong .8 } }
cylinder { <1.4,-1,2>, <1.4,2,2>, .3 pigment { rgb <.2,.9,.2> } }
#macro Face(X, Y, Wide) triangle { <X-.02,Y,-2>, <X+.02,Y+.0005*Wide,-2>, <X,Y+.04,-2+.002*X> } #end
#macro Faces(Columns, Rows, Shift) mesh {
  #for (K, 0, Rows-1) #for (I, 0, Columns-1)
    Face(((I+.5)/Columns - .5)*4 + Shift, (.5 - (K+.5)/Rows)*2.4, I)
  #end #end
} #end
)";

class ImageMeshCamera : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageMeshCamera, AsInStock) {
  EXPECT_TRUE(same_as_stock({.sdl = std::string(kMeshCameraStage) + GetParam(),
                             .width = 48,
                             .height = 30,
                             .arguments = {},
                             .files = {}}));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageMeshCamera,
    ::testing::Values(
        "camera { mesh_camera { 1 0 Faces(48, 30, 0) } }",
        "camera { mesh_camera { 1 0 Faces(48, 20, 0) } location <0,0,-.5> }",
        "camera { mesh_camera { 3 0 Faces(48, 30, 0) Faces(48, 30, .04) Faces(48, 22, -.05) } }",
        "#declare Strip = Faces(48, 6, 0); camera { mesh_camera { 2 1"
        " #for (K, 0, 4) mesh { Strip translate .8*(1-K)*y } #end } }",
        "#declare Strip = Faces(48, 6, 0); camera { mesh_camera { 1 1"
        " #for (K, 0, 4) mesh { Strip translate .8*(1-K)*y } #end } }",
        "#declare Right = Faces(24, 30, .2);"
        " camera { mesh_camera { 1 2 Faces(24, 30, -.2) mesh { Right rotate 5*y } } }",
        "camera { mesh_camera { 1 0 Faces(48, 30, 0) } direction -z rotate 180*y }",
        R"(camera { mesh_camera { 1 3 mesh { triangle { <-2,-1,-2>, <-2,1.4,-2>, <2,1.4,-2.2>
            uv_vectors <0,0>, <0,1>, <1,1> } triangle { <-2,-1,-2>, <2,1.4,-2.2>, <2,-1,-2>
            uv_vectors <0,0>, <1,1>, <1,0> } } } location <0,0,.3> })",
        R"(camera { mesh_camera { 1 3 mesh { smooth_triangle { <-2,-1,-2>, <-.3,-.1,1>, <-2,1.4,-2>,
            <-.3,.2,1>, <2,1.4,-2>, <.3,.2,1> uv_vectors <0,0>, <0,1>, <1,1> } } smooth } })"));

class ImageBentCamera : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageBentCamera, AsInStock) {
  EXPECT_TRUE(same_as_stock({.sdl = std::string(kMeshCameraStage) + GetParam(),
                             .width = 96,
                             .height = 72,
                             .arguments = {},
                             .files = {}}));
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageBentCamera,
    ::testing::Values("camera { location <0,.5,-3> look_at z*2 normal { bumps .3 scale .2 } }",
                      "camera { orthographic location <0,.5,-3> look_at z*2 right 4*x up 3*y"
                      " normal { gradient x .2 scale .1 } }",
                      "camera { location <0,.5,-3> look_at z*2 normal { ripples .3 scale .1 } }"));

}  // namespace
}  // namespace lentray::test
