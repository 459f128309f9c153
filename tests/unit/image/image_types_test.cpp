// Each type of file comes back as it was written: sizes that fill rows and runs oddly, bits, alpha, tags.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/image/display.h"
#include "core/image/png_chunks.h"
#include "core/image/quantiser.h"
#include "core/image/reader.h"
#include "core/image/writer.h"
#include "tests/unit/image/written_image.h"
#include "tools/common/process.h"

namespace lentray::core {
namespace {

using tool::TemporaryFolder;

/// Runs and single pixels, opaque.
Image stripes(std::uint32_t width, std::uint32_t height) {
  Image image(width, height);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      float* p = image.pixel(x, y);
      const bool is_flat = (x / 9 + y) % 2 == 0;
      p[0] = is_flat ? 0.4f : static_cast<float>(x % 17) / 17.0f;
      p[1] = static_cast<float>(y) / static_cast<float>(height);
      p[2] = is_flat ? 0.1f : 0.9f;
      p[3] = 1.0f;
    }
  }
  return image;
}

struct ImageTypesKind {
  const char* name;
  FileType type;
  int bits, levels;
};

class UnitImageTypes : public ::testing::TestWithParam<std::tuple<ImageTypesKind, std::uint32_t>> {
};

TEST_P(UnitImageTypes, ComeBack) {
  const auto& [kind, width] = GetParam();
  const TemporaryFolder folder;
  const Image image = stripes(width, 37);
  ImageFormat format;
  format.type = kind.type;
  format.bits = kind.levels;
  write_image(image, folder / kind.name, format);
  const StoredImage back = read_image(folder / kind.name);
  ASSERT_EQ(back.width, width);
  ASSERT_EQ(back.height, 37u);
  ASSERT_EQ(back.channels, 3);
  ASSERT_EQ(back.bits, kind.bits);
  const double all = std::pow(2.0, kind.bits) - 1, levels = std::pow(2.0, kind.levels) - 1;
  for (std::uint32_t y = 0; y < 37; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(back.at(x, y, c) / all, quantised(image.pixel(x, y)[c], format) / levels,
                    1.1 / all)  // the reader of PPM rounds once more
            << x << ' ' << y << ' ' << c;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, UnitImageTypes,
    ::testing::Combine(::testing::Values(ImageTypesKind{"a.tga", FileType::targa, 8, 8},
                                         ImageTypesKind{"a.tga", FileType::compressed_targa, 8, 8},
                                         ImageTypesKind{"a.ppm", FileType::ppm, 8, 8},
                                         ImageTypesKind{"a.ppm", FileType::ppm, 16, 16},
                                         ImageTypesKind{"a.bmp", FileType::bmp, 8, 8},
                                         ImageTypesKind{"a.png", FileType::png, 8, 8},
                                         ImageTypesKind{"a.png", FileType::png, 16, 16},
                                         ImageTypesKind{"a.tif", FileType::tiff, 16, 16}),
                       ::testing::Values(1u, 7u, 301u)));

TEST(UnitImageTypes, RadianceWithinItsSteps) {
  const TemporaryFolder folder;
  for (const std::uint32_t width : {3u, 200u}) {
    Image image = stripes(width, 5);
    image.pixel(2, 1)[0] = 1234.5f;
    image.pixel(1, 1)[0] = image.pixel(1, 1)[1] = image.pixel(1, 1)[2] = 0.0f;
    ImageFormat format;
    format.type = FileType::radiance;
    write_image(image, folder / "a.hdr", format);
    const StoredImage back = read_image(folder / "a.hdr");
    EXPECT_EQ(back.gamma, 1.0);
    EXPECT_EQ(back.at(1, 1, 1), 0.0f);
    for (std::uint32_t x = 0; x < width; ++x) {
      if (x == 1) continue;
      const float* p = image.pixel(x, 1);
      const double step = std::max({p[0], p[1], p[2]}) / 128.0;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(back.at(x, 1, c), p[c], 0.51 * step) << x << ' ' << c;
    }
  }
}

TEST(UnitImageTypes, JpegIsNear) {
  const TemporaryFolder folder;
  ImageFormat format;
  format.type = FileType::jpeg;
  format.quality = 100;
  const Image image = stripes(40, 30);
  write_image(image, folder / "fine.jpg", format);
  format.quality = 20;
  write_image(image, folder / "small.jpg", format);
  const StoredImage back = read_image(folder / "fine.jpg");
  EXPECT_NEAR(back.at(12, 10, 1), quantised(image.pixel(12, 10)[1], format), 4);
  EXPECT_LT(std::filesystem::file_size(folder / "small.jpg"),
            std::filesystem::file_size(folder / "fine.jpg") / 2);
}

TEST(UnitImageTypes, FewBitsArePaddedWithThemselves) {
  const TemporaryFolder folder;
  Image image(1, 1);
  image.rgba = {1.0f, 0.5f, 0.0f, 1.0f};
  ImageFormat format;
  format.srgb = false;
  format.bits = 5;
  write_image(image, folder / "a.png", format);
  const StoredImage five = read_image(folder / "a.png");
  EXPECT_EQ(five.at(0, 0, 0), 255);
  EXPECT_EQ(five.at(0, 0, 1), 16 << 3 | 16 >> 2);
  format.bits = 12;
  write_image(image, folder / "a.png", format);
  EXPECT_EQ(read_image(folder / "a.png").at(0, 0, 0), 65535);
}

TEST(UnitImageTypes, LightOnGlassMakesItOpaque) {
  const TemporaryFolder folder;
  Image image(2, 1);
  image.rgba = {0.5f, 0.5f, 0.5f, 0.0f, 0.1f, 0.2f, 0.0f, 0.5f};
  ImageFormat format;
  format.srgb = false;
  format.alpha = true;
  for (const char* name : {"a.png", "a.tga", "a.bmp"}) {
    format.type = file_type_of(name);
    write_image(image, folder / name, format);
    const StoredImage back = read_image(folder / name);
    ASSERT_EQ(back.channels, 4) << name;
    EXPECT_EQ(back.at(0, 0, 0), 255) << name;
    EXPECT_EQ(back.at(0, 0, 3), 128) << name;
    EXPECT_EQ(back.at(1, 0, 1), 102) << name;
    EXPECT_EQ(back.at(1, 0, 3), 128) << name;
  }
  format.type = FileType::ppm;
  write_image(image, folder / "a.ppm", format);
  EXPECT_EQ(read_image(folder / "a.ppm").at(1, 0, 1), 51) << "over black";
}

TEST(UnitImageDisplay, TagsDecide) {
  const TemporaryFolder folder;
  Image image(3, 1);
  image.rgba = {0.2f, 0.5f, 0.9f, 1.0f, 0.0f, 1.0f, 0.1f, 1.0f, 0.3f, 0.3f, 0.3f, 1.0f};
  ImageFormat srgb, linear;
  srgb.bits = linear.bits = 16;
  linear.srgb = false;
  write_image(image, folder / "srgb.png", srgb);
  write_image(image, folder / "linear.png", linear);
  EXPECT_LT(png_gamma(folder / "srgb.png"), 0.0);
  EXPECT_EQ(png_gamma(folder / "linear.png"), 1.0);
  const StoredImage a = displayed(read_image(folder / "srgb.png")),
                    b = displayed(read_image(folder / "linear.png"));
  for (std::size_t i = 0; i < a.samples.size(); ++i) EXPECT_NEAR(a.samples[i], b.samples[i], 0.1);
  StoredImage bytes = read_image(folder / "srgb.png");
  EXPECT_TRUE(is_shown_as_stored(bytes));
  bytes.gamma = 1.0;
  EXPECT_GT(std::fabs(displayed(bytes).samples[0] - a.samples[0]), 20.0);
}

TEST(UnitImageDisplay, StraightAndPremultipliedLookAlike) {
  const TemporaryFolder folder;
  Image image(16, 1);
  for (std::uint32_t x = 0; x < 16; ++x) {
    float* p = image.pixel(x, 0);
    p[0] = 0.1f;
    p[1] = 0.3f;
    p[3] = 0.4f;
  }
  ImageFormat format;
  format.alpha = true;
  format.bits = 16;
  write_image(image, folder / "a.png", format);
  format.type = FileType::exr;
  format.bits = 32;
  write_image(image, folder / "a.exr", format);
  const StoredImage a = displayed(read_image(folder / "a.png")),
                    b = displayed(read_image(folder / "a.exr"));
  for (std::size_t i = 0; i < a.samples.size(); ++i) EXPECT_NEAR(a.samples[i], b.samples[i], 0.1);
  EXPECT_NEAR(a.samples[3 * 8] - a.samples[0], 0.6 * 255.0, 0.1) << "the white square";
}

}  // namespace
}  // namespace lentray::core
