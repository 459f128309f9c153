// Sampling for the eye (+AM3): which pictures it is of, what a mean is, and who refuses it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// A black and a white half, in a scene whose colours are not linear.
constexpr const char* kHalves = R"(#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
plane { z, 0 pigment { gradient x colour_map { [0.5 rgb 1] [0.5 rgb 0] } scale 200 translate -100*x }
  finish { ambient 1 diffuse 0 } rotate 11*z }
)";

class ImageEyeSamples : public ::testing::Test {
 protected:
  void SetUp() override { tool::write_text(m_folder / "a.pov", kHalves); }
  StoredImage render(std::vector<std::string> words) const {
    words.insert(words.end(), {"+Ia.pov", "-V", "+Oa.png", "+FN16", "File_Gamma=1"});
    const auto done = run_lentray(words, m_folder.path());
    EXPECT_EQ(done.status, 0) << done.output;
    return core::read_image(m_folder / "a.png");
  }
  static double mean(const StoredImage& picture) {
    double sum = 0.0;
    for (std::uint32_t y = 0; y < picture.height; ++y)
      for (std::uint32_t x = 0; x < picture.width; ++x) sum += picture.at(x, y, 0);
    return sum / (65535.0 * picture.width * picture.height);
  }
  const tool::TemporaryFolder m_folder;
};

TEST_F(ImageEyeSamples, OtherPicturesAreThoseOfMethodTwo) {
  EXPECT_TRUE(same_bits(render({"+W60", "+H40", "+A0.1", "+AM3"}),
                        render({"+W60", "+H40", "+A0.1", "+AM2"})));
  EXPECT_TRUE(same_bits(render({"Quilt=2x2", "Quilt_Tile=30x20", "+A0.1", "+AM3"}),
                        render({"Quilt=2x2", "Quilt_Tile=30x20", "+A0.1", "+AM2"})));
  const std::vector<std::string> sheet{"Lenticular=On", "Lens_Pixels=5", "+W100", "+H40", "+A0.1"};
  auto eye = sheet, corners = sheet;
  eye.emplace_back("+AM3");
  corners.emplace_back("+AM2");
  EXPECT_FALSE(same_bits(render(eye), render(corners)));
}

TEST_F(ImageEyeSamples, MeansAreOfLinearLight) {
  // A half of the picture is white, and so is a half of the light, whatever the scene's gamma.
  const std::vector<std::string> sheet{"Lenticular=On", "Lens_Pixels=5", "+W200", "+H150"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), sheet.begin(), sheet.end());
    return mean(render(more));
  };
  EXPECT_NEAR(with({"+A0.1", "+AM3"}), 0.5, 0.003);
  EXPECT_NEAR(with({"Antialias_Grid=8", "+AM3"}), 0.5, 0.003);
  // The grid of the scene's own gamma is darker: half of white is 0.22 of the light.
  EXPECT_LT(with({"Antialias_Grid=8"}), 0.499);
}

TEST_F(ImageEyeSamples, WhatDoesNothingIsSaid) {
  const auto done = run_lentray(
      {"+Ia.pov", "-V", "Lenticular=On", "+A0.1", "+AM3", "Antialias_Gamma=2", "+Oa.png"},
      m_folder.path());
  EXPECT_EQ(done.status, 0);
  EXPECT_NE(done.output.find("Antialias_Gamma does nothing with Sampling_Method=3"),
            std::string::npos)
      << done.output;
}

TEST_F(ImageEyeSamples, ComparisonsWithStockRefuseIt) {
  const auto done = run_diff({"a.pov", "Lenticular=On", "+A0.1", "+AM3"}, m_folder.path());
  EXPECT_NE(done.status, 0);
  EXPECT_NE(done.output.find("methods 1 and 2"), std::string::npos) << done.output;
}

}  // namespace
}  // namespace lentray::test
