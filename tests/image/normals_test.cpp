// Perturbed normals against stock: a plane under three coloured parallel lights shows three cosines
// of its normal in red, green and blue; ours are computed at the same points.
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/render.h"
#include "tests/unit/material/material_reading.h"

namespace lentray::parser::test {
namespace {

using core::Vec3;

constexpr std::uint32_t kSide = 48;
constexpr double kNormalsWidth = 4.0;

/// Directions towards the red, green and blue light.
Vec3 light_direction(int i) {
  const double angle = 2.0 * 3.14159265358979323846 * i / 3.0;
  return core::normalized({0.5 * std::cos(angle), 0.5 * std::sin(angle), -1.0});
}

std::string scene_text(const std::string& normal, const std::string& before) {
  std::ostringstream text;
  text.precision(17);
  text << "#version 3.7; global_settings { assumed_gamma 1 }\n"
       << before << "\ncamera { orthographic location <0,0,-10> direction z right " << kNormalsWidth
       << "*x up " << kNormalsWidth << "*y }\n";
  for (int i = 0; i < 3; ++i) {
    const Vec3 d = light_direction(i) * 100.0;
    text << "light_source { <" << d.x << ',' << d.y << ',' << d.z << "> rgb <" << (i == 0) << ','
         << (i == 1) << ',' << (i == 2) << "> parallel point_at 0 }\n";
  }
  text << "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } normal { " << normal
       << " } }\n";
  return text.str();
}

struct NormalCase {
  const char* normal;
  const char* before = "";
};

class ImageNormals : public ::testing::TestWithParam<NormalCase> {};

TEST_P(ImageNormals, ShadeAsInStock) {
  const auto [normal, before] = GetParam();
  const lentray::test::SceneText scene{.sdl = scene_text(normal, before),
                                       .width = kSide,
                                       .height = kSide,
                                       .arguments = {"File_Gamma=1.0"},
                                       .bits = 16,
                                       .files = {}};
  const core::StoredImage stock = lentray::test::stock_render(scene);
  const LooksText read("pigment { rgb 1 } normal { " + std::string(normal) + " }", before);
  TextureCompiler compiler(TextureSettings{});
  const auto texture = compiler.texture(read.object().texture, nullptr);
  EXPECT_TRUE(compiler.not_yet().empty());
  core::WeightedTextures layers;
  texture->resolve({}, core::kNoSurface, 1.0, layers);
  const auto& ours = layers.front().texture->layers().front().normal;
  ASSERT_NE(ours, nullptr);
  int far = 0;
  double largest = 0.0;
  for (std::uint32_t k = 0; k < kSide; ++k) {
    for (std::uint32_t i = 0; i < kSide; ++i) {
      const Vec3 at{((i + .5) / kSide - .5) * kNormalsWidth,
                    (.5 - (k + .5) / kSide) * kNormalsWidth, 0.0};
      const Vec3 n = ours->perturb(at, {0, 0, -1}, core::kNoSurface);
      for (int c = 0; c < 3; ++c) {
        const double cosine = std::max(0.0, core::dot(n, light_direction(c)));
        const double d = std::fabs(cosine - stock.at(i, k, c) / 65535.0);
        largest = std::max(largest, d);
        far += !(d < 3e-5);
      }
    }
  }
  // A point on an edge of a pattern may fall on either side.
  EXPECT_LE(far, 3) << "largest difference " << largest;
}

constexpr NormalCase kNormalsNormals[] = {
    {"bumps .4"},
    {"bumps .4 scale .3"},
    {"bumps .4 scale <.2,1,.5> rotate 30"},
    {"bumps .4 scale .3 no_bump_scale"},
    {"dents .7 scale .4"},
    {"wrinkles .5 scale .5"},
    {"ripples .3 frequency 2"},
    {"waves .4 frequency 3 phase .2 scale .5"},
    {"quilted .5 control0 .2 control1 .9"},
    {"granite .2"},
    {"granite .2 accuracy .005"},
    {"leopard .3 scale .2"},
    {"marble .3 turbulence .4"},
    {"gradient x .3 slope_map { [0 <0,1>] [.5 <1,1>] [.5 <1,-1>] [1 <0,-1>] }"},
    {"wood .4 slope_map { [0 <0,0>] [.5 <.5,1>] [1 <1,0>] } scale .5"},
    {"bozo .6 turbulence .3 sine_wave frequency 2"},
    {"crackle .3"},
    {"checker .3 scale .5"},
    {"checker normal { bumps .3 scale .2 } normal { ripples .2 } scale .7"},
    {"gradient x normal_map { [.3 bumps .4 scale .2] [.7 dents .6] } scale 2 rotate z*30"},
    {"average normal_map { [1 bumps .4] [2 wrinkles .3 scale .3] }"},
    {"facets coords .3 size .4"},
    {"N scale .5", "#declare N = normal { bumps .3 rotate 40 }"},
    {"function { x*x + y } .2"},
};

INSTANTIATE_TEST_SUITE_P(Each, ImageNormals, ::testing::ValuesIn(kNormalsNormals),
                         [](const auto& named) { return "n" + std::to_string(named.index); });

}  // namespace
}  // namespace lentray::parser::test
