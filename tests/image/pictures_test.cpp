// Images as pigments, patterns and materials against stock: the same small file is mapped by both,
// and the colours are compared as numbers.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/image/reader.h"
#include "tests/image/stock_values.h"
#include "tests/unit/material/material_reading.h"

namespace lentray::parser::test {
namespace {

/// A picture without any order in it.
std::string write_picture(const std::string& name, int channels, int bits) {
  core::StoredImage image;
  image.width = 5;
  image.height = 4;
  image.channels = channels;
  image.bits = bits;
  std::mt19937 random(3);
  const double most = bits == 8 ? 255.0 : 65535.0;
  image.samples.assign(static_cast<std::size_t>(5 * 4 * channels), 0.0f);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] =
        static_cast<float>(std::floor(static_cast<double>(random()) / 4294967296.0 * most));
  }
  const std::string path = ::testing::TempDir() + name;
  core::write_stored(image, path);
  return path;
}

struct PictureCase {
  const char* name;
  int channels, bits;
  const char* pigment;  ///< FILE stands for the picture
};

class ImagePictures : public ::testing::TestWithParam<PictureCase> {};

TEST_P(ImagePictures, HaveTheColoursOfStock) {
  const PictureCase& c = GetParam();
  const std::string path =
      write_picture("lentray_" + std::string(c.name) + ".png", c.channels, c.bits);
  std::string text = c.pigment;
  text.replace(text.find("FILE"), 4, "png \"" + path + "\"");
  const auto stock = stock_values("pigment { " + text + " }", "",
                                  {"V.red", "V.green", "V.blue", "V.filter", "V.transmit"});
  const LooksText read("pigment { " + text + " }");
  const auto ours = compiled(read.pigment());
  std::filesystem::remove(path);
  const auto points = sample_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const core::Colour colour = ours->colour(points[i]);
    const double all[] = {colour.rgb.r, colour.rgb.g, colour.rgb.b, colour.filter, colour.transmit};
    for (std::size_t k = 0; k < 5; ++k) expect_same(all[k], stock[5 * i + k], 1e-5, points[i]);
  }
}

constexpr PictureCase kPictures[] = {
    {"plain", 3, 8, "image_map { FILE }"},
    {"grey", 1, 8, "image_map { FILE }"},
    {"grey_alpha", 2, 8, "image_map { FILE }"},
    {"deep_grey", 1, 16, "image_map { FILE }"},
    {"alpha", 4, 8, "image_map { FILE }"},
    {"deep", 3, 16, "image_map { FILE }"},
    {"once", 3, 8, "image_map { FILE once } scale 3"},
    {"spherical", 3, 8, "image_map { FILE map_type 1 interpolate 2 }"},
    {"cylindrical", 3, 8, "image_map { FILE map_type 2 } scale 2"},
    {"torus", 3, 8, "image_map { FILE map_type 5 interpolate 2 }"},
    {"bilinear", 3, 8, "image_map { FILE interpolate 2 }"},
    {"bicubic", 3, 8, "image_map { FILE interpolate 3 } scale 2"},
    {"distance", 3, 8, "image_map { FILE interpolate 4 } rotate 20"},
    {"linear", 3, 8, "image_map { FILE gamma 1.0 }"},
    {"power", 3, 8, "image_map { FILE gamma 1.8 }"},
    {"clear", 3, 8, "image_map { FILE filter all .3 transmit all .2 }"},
    {"pattern", 3, 8, "image_pattern { FILE interpolate 2 } color_map { [0 rgb 0] [1 rgb 1] }"},
    {"grey_pattern", 1, 8, "image_pattern { FILE } color_map { [0 rgb 0] [1 rgb 1] }"},
    {"grey_pattern_mixed", 1, 8,
     "image_pattern { FILE interpolate 2 } color_map { [0 rgb 0] [1 rgb 1] }"},
    {"grey_linear", 1, 8, "image_map { FILE gamma 1.0 }"},
    {"grey_linear_alpha", 1, 8,
     "image_pattern { FILE gamma 1.0 use_alpha } color_map { [0 rgb 0] [1 rgb 1] }"},
    {"transparency", 4, 8, "image_pattern { FILE use_alpha } color_map { [0 rgb 0] [1 rgb 1] }"},
};

INSTANTIATE_TEST_SUITE_P(Each, ImagePictures, ::testing::ValuesIn(kPictures),
                         [](const auto& named) { return std::string(named.param.name); });

}  // namespace
}  // namespace lentray::parser::test
