// Parametric surfaces against stock: containers, steps, gradients that are right and too low,
// precomputed and not, alone, in CSG and with shadows.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr const char* kParametricStage = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.2,2.6,-4> look_at <0,.2,0> angle 40 }
light_source { <-4,7,-6>, 1 }
light_source { <5,3,-2>, .3 }
plane { y, -1.6 pigment { checker rgb .9 rgb .5 } }
)";

struct ParametricCase {
  const char* name;
  const char* sdl;
  Grade grade = Grade::exact;
};

const ParametricCase kParametricCases[] = {
    {"sphere",
     "function { sin(u)*cos(v) } function { cos(u) } function { sin(u)*sin(v) }"
     " <0,0>, <pi,2*pi> max_gradient 1 accuracy .005"},
    {"in_sphere",
     "function { sin(u)*cos(v)*1.3 } function { cos(u) } function { sin(u)*sin(v) }"
     " <0,0>, <pi,2*pi> contained_by { sphere { <.2,0,0>, 1.1 } } max_gradient 1.5 accuracy .01"},
    {"precomputed",
     "function { u*v*sin(10*v) } function { v } function { u*v*cos(10*v) } <0,.05>, <1,1>"
     " contained_by { box { -1, 1 } } max_gradient 9 accuracy .005 precompute 12 x, y, z"},
    {"precomputed_partly",
     "function { cos(u)*(1 + .4*cos(v)) } function { .4*sin(v) }"
     " function { sin(u)*(1 + .4*cos(v)) } <0,0>, <2*pi,2*pi>"
     " contained_by { box { -1.5, 1.5 } } max_gradient 1.5 accuracy .01 precompute 9 x, z"},
    {"too_flat",
     "function { u*v*sin(15*v) } function { v } function { u*v*cos(15*v) } <0,0>, <1,1>"
     " contained_by { box { -1, 1 } } accuracy .01"},
    {"turned",
     "function { u } function { .3*sin(u*4)*cos(v*3) } function { v } <-1,-1>, <1,1>"
     " contained_by { box { -1, 1 } } max_gradient 2 accuracy .003 rotate <20,30,10> scale "
     "<1.2,1,.8>"},
    {"backwards",
     "function { u } function { v*v } function { v } <1,1>, <-1,-.8>"
     " contained_by { box { 1, -1 } } max_gradient 2 accuracy .01"},
};

/// Stock takes seconds for the smallest pictures.
class ImageParametric : public ::testing::TestWithParam<ParametricCase> {
 protected:
  static constexpr std::uint32_t kWidth = 28;
  static void expect_alone(std::uint32_t width);
  static void expect_uv_mapped(std::uint32_t width);
  static void expect_in_csg(std::uint32_t width);
};
/// The same in larger pictures.
class SlowParametric : public ImageParametric {
 protected:
  static constexpr std::uint32_t kWidth = 40;
};

::testing::AssertionResult same(const std::string& sdl, std::uint32_t width, Grade grade) {
  return same_as_stock({.sdl = kParametricStage + sdl,
                        .width = width,
                        .height = width * 3 / 4,
                        .arguments = {},
                        .files = {}},
                       grade);
}

void ImageParametric::expect_alone(std::uint32_t width) {
  EXPECT_TRUE(same(std::string("parametric { ") + GetParam().sdl +
                       " pigment { rgb <.9,.5,.3> } finish { specular .4 } }",
                   width, GetParam().grade));
}

TEST_P(ImageParametric, Alone) { expect_alone(kWidth); }
TEST_P(SlowParametric, Alone) { expect_alone(kWidth); }

void ImageParametric::expect_uv_mapped(std::uint32_t width) {
  EXPECT_TRUE(
      same(std::string("parametric { ") + GetParam().sdl +
               " pigment { uv_mapping checker rgb .2 rgb x scale .3 } finish { reflection .3 } }",
           width, GetParam().grade));
}

TEST_P(ImageParametric, UvMapped) { expect_uv_mapped(kWidth); }
TEST_P(SlowParametric, UvMapped) { expect_uv_mapped(kWidth); }

/// Cut, joined and clipped.
SceneText in_csg(const std::string& surface, std::uint32_t width = 40) {
  const std::string one = "parametric { " + surface + " }";
  return {.sdl = kParametricStage + ("difference { " + one +
                                     " sphere { <.4,.4,-.8>, .7 } pigment { rgb <.3,.7,.9> } }\n"
                                     "intersection { " +
                                     one +
                                     " box { <-2,-.1,-2>, <2,.3,2> }"
                                     " translate <-1.2,1.4,1.5> pigment { rgb <.8,.9,.3> } }\n"
                                     "object { " +
                                     one +
                                     " clipped_by { plane { x, 0 } } translate <1.3,.7,1>"
                                     " pigment { rgb <.9,.3,.8> } }"),
          .width = width,
          .height = width * 3 / 4,
          .arguments = {},
          .files = {}};
}

void ImageParametric::expect_in_csg(std::uint32_t width) {
  if (std::string(GetParam().name) == "turned") GTEST_SKIP() << "ImageParametricAccuracy";
  EXPECT_TRUE(same_as_stock(in_csg(GetParam().sdl, width), GetParam().grade));
}

TEST_P(ImageParametric, InCsg) { expect_in_csg(kWidth); }
TEST_P(SlowParametric, InCsg) { expect_in_csg(kWidth); }

/// With a coarse accuracy stock darkens a dozen pixels of the floor that it leaves light with a fine
/// one. With the fine one the pictures are equal, and each pixel with the coarse one is one of stock's.
TEST(ImageParametricAccuracy, DarkensNoMoreThanStock) {
  const auto scene = [](const std::string& accuracy) {
    return in_csg(
        "function { u } function { .3*sin(u*4)*cos(v*3) } function { v } <-1,-1>, <1,1>"
        " contained_by { box { -1, 1 } } max_gradient 2 accuracy " +
        accuracy + " rotate <20,30,10> scale <1.2,1,.8>");
  };
  const StoredImage fine = stock_render(scene(".00001"));
  EXPECT_TRUE(same_bits(lentray_render(scene(".00001")), fine));
  const StoredImage coarse = stock_render(scene(".003")), ours = lentray_render(scene(".003"));
  ASSERT_EQ(ours.samples.size(), coarse.samples.size());
  for (std::size_t at = 0; at < ours.samples.size(); at += 3) {
    const auto same_pixel = [&](const StoredImage& stock) {
      for (std::size_t i = at; i < at + 3; ++i) {
        if (ours.samples[i] != stock.samples[i]) return false;
      }
      return true;
    };
    EXPECT_TRUE(same_pixel(coarse) || same_pixel(fine)) << "pixel " << at / 3;
  }
}

std::string parametric_name(const ::testing::TestParamInfo<ParametricCase>& one) {
  return one.param.name;
}

INSTANTIATE_TEST_SUITE_P(Each, ImageParametric, ::testing::ValuesIn(kParametricCases),
                         parametric_name);
INSTANTIATE_TEST_SUITE_P(Each, SlowParametric, ::testing::ValuesIn(kParametricCases),
                         parametric_name);

}  // namespace
}  // namespace lentray::test
