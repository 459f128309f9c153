// The parts of lentray-views: columns and eyes, sizes, quilts and anaglyphs, interlacing, and the
// bytes of moving pictures, which a reader of this test takes apart.
#include <gif_lib.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "camera/lenticular.h"
#include "core/image/reader.h"
#include "core/image/srgb.h"
#include "core/image/writer.h"
#include "tools/common/process.h"
#include "tools/lentray-views/interlace.h"
#include "tools/lentray-views/join.h"
#include "tools/lentray-views/moving.h"
#include "tools/lentray-views/picture.h"
#include "tools/lentray-views/resize.h"
#include "tools/lentray-views/sheet.h"
#include "tools/lentray-views/strips.h"

namespace lentray::views {
namespace {

using core::StoredImage;

/// RGB of 8 bits that tells its place: red the column, green the row, blue `blue`.
StoredImage views_picture(std::uint32_t width, std::uint32_t height, int blue = 0) {
  StoredImage like;
  like.channels = 3;
  like.gamma = -1.0;
  StoredImage out = blank_like(like, width, height);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      out.samples.set(out.place(x, y, 0), static_cast<float>(x % 256));
      out.samples.set(out.place(x, y, 1), static_cast<float>(y % 256));
      out.samples.set(out.place(x, y, 2), static_cast<float>(blue));
    }
  }
  return out;
}

Sheet views_sheet_of(double pixels, std::uint32_t width, double distance, camera::LensModel model) {
  SheetOptions options;
  options.pixels = pixels;
  options.pitch = 1.0;
  options.focal_length = 2.5;
  options.ior = 1.5;
  options.view_distance = distance;
  options.model = model;
  return sheet_of(views_picture(width, 2), options, "a.png");
}

TEST(UnitViewsTool, AViewIsColumnsOfTheSheet) {
  const StoredImage image = views_picture(60, 3);
  const Sheet sheet = views_sheet_of(5, 60, 0, camera::LensModel::kPinhole);
  for (std::uint32_t view = 0; view < 5; ++view) {
    const StoredImage strip = view_of(image, sheet.lenses, view, 5);
    ASSERT_EQ(strip.width, 12u);
    for (std::uint32_t i = 0; i < 12; ++i) EXPECT_EQ(strip.at(i, 1, 0), i * 5.0f + view);
  }
  const StoredImage lens = lens_of(image, sheet.lenses, 3);
  ASSERT_EQ(lens.width, 5u);
  EXPECT_EQ(lens.at(4, 2, 0), 19.0f);
  EXPECT_EQ(lens.at(4, 2, 1), 2.0f);
}

/// An eye where view j has its own sees just that view, for each model and distance.
TEST(UnitViewsTool, TheEyeOfAViewSeesIt) {
  const StoredImage image = views_picture(120, 2);
  for (const double distance : {0.0, 300.0}) {
    const Sheet sheet = views_sheet_of(8, 120, distance, camera::LensModel::kParaxial);
    for (std::uint32_t j = 0; j < 8; ++j) {
      const double e = ((j + 0.5) / 8 - 0.5) * sheet.lenses.lens().print_pitch();
      // Looking along slope n e/f the eye stands at the other side.
      const Eye eye{-std::atan(1.5 * e / 2.5) * 180.0 / std::numbers::pi, distance};
      const StoredImage wanted = view_of(image, sheet.lenses, j, 8);
      for (const bool between : {false, true}) {
        const StoredImage got = seen_by(image, sheet.lenses, eye, between);
        ASSERT_EQ(got.width, wanted.width);
        for (std::uint32_t i = 0; i < got.width; ++i)
          EXPECT_EQ(got.at(i, 1, 0), wanted.at(i, 1, 0)) << distance << " " << j << " " << i;
      }
    }
  }
  const Sheet pinhole = views_sheet_of(8, 120, 0, camera::LensModel::kPinhole);
  const camera::LensColumn column = pinhole.lenses.column(5);
  const Eye eye{-std::atan(column.slope) * 180.0 / std::numbers::pi, 0.0};
  const StoredImage got = seen_by(image, pinhole.lenses, eye, false);
  for (std::uint32_t i = 0; i < got.width; ++i) EXPECT_EQ(got.at(i, 0, 0), i * 8.0f + 5);
}

TEST(UnitViewsTool, AnEyeFarAsideSeesTheNextStripAndThenNothing) {
  const StoredImage image = views_picture(40, 1);
  const Sheet sheet = views_sheet_of(8, 40, 0, camera::LensModel::kParaxial);
  // One whole lens width aside in the print: n e/f = 1.5/2.5.
  const Eye eye{-std::atan(1.5 / 2.5) * 180.0 / std::numbers::pi, 0.0};
  const StoredImage got = seen_by(image, sheet.lenses, eye, false);
  const StoredImage ahead = seen_by(image, sheet.lenses, {}, false);
  for (std::uint32_t i = 0; i + 1 < got.width; ++i)
    EXPECT_EQ(got.at(i, 0, 0), ahead.at(i + 1, 0, 0));
  EXPECT_EQ(got.at(4, 0, 0), 0.0f);
}

TEST(UnitViewsTool, ColoursBetweenPixelsAreMeansOfLight) {
  StoredImage image = views_picture(8, 1);
  for (std::uint32_t x = 0; x < 8; ++x) image.samples.set(image.place(x, 0, 0), x < 4 ? 0 : 255);
  const Sheet sheet = views_sheet_of(8, 8, 0, camera::LensModel::kParaxial);
  const StoredImage got = seen_by(image, sheet.lenses, {}, true);
  EXPECT_EQ(got.at(0, 0, 0), std::floor(core::srgb_of_linear(0.5f) * 255.0f + 0.5f));
}

TEST(UnitViewsTool, InterlacedViewsComeApartAgain) {
  for (const double n : {6.0, 6.4}) {
    const Sheet sheet = views_sheet_of(n, 96, 0, camera::LensModel::kPinhole);
    const StoredImage image = views_picture(96, 2);
    Interlacer back({n, 96, 2, 6, Filter::kBox});
    for (std::uint32_t j = 0; j < 6; ++j)
      back.put(j, view_of(image, sheet.lenses, j, 6), "v" + std::to_string(j));
    for (std::uint32_t k = 0; k < 96; ++k) {
      const float most_off = n == 6.0 ? 0.0f : 1.0f;
      EXPECT_NEAR(back.result().at(k, 1, 0), image.at(k, 1, 0), most_off);
    }
  }
}

/// Two pictures share the pixels of each lens, and are spread over the whole sheet.
TEST(UnitViewsTool, FlipPrints) {
  Interlacer flip({5.0, 50, 4, 2, Filter::kTriangle});
  flip.put(0, views_picture(20, 8, 10), "a");
  flip.put(1, views_picture(20, 8, 200), "b");
  for (std::uint32_t k = 0; k < 50; ++k) {
    EXPECT_EQ(flip.result().at(k, 2, 2), k % 5 < 2 ? 10.0f : 200.0f) << k;
    EXPECT_NEAR(flip.result().at(k, 2, 0), (k / 5 + 0.5) * 2.0 - 0.5, 1.5) << k;
  }
}

TEST(ErrorViewsTool, Interlacing) {
  const auto message = [](auto work) {
    try {
      work();
    } catch (const core::ImageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message([] {
              Interlacer({60.0, 50, 4, 2});
            }),
            "an integral image of 50 columns has no lens of 60 pixels");
  EXPECT_EQ(message([] {
              Interlacer({5.0, 50, 4, 6});
            }),
            "a lens of 5 pixels has no room for 6 views");
  EXPECT_EQ(message([] {
              Interlacer all({5.0, 50, 4, 2});
              all.put(0, views_picture(20, 8), "a.png");
              all.put(1, views_picture(21, 8), "b.png");
            }),
            "'a.png' and 'b.png' are not views of one sheet: they have 20 x 8 and 21 x 8 pixels");
}

TEST(UnitViewsTool, FiltersKeepWhatIsEven) {
  StoredImage image = views_picture(31, 17);
  for (std::uint32_t i = 0; i < image.samples.size(); ++i) image.samples.set(i, 97.0f);
  for (const char* name : {"box", "triangle", "mitchell", "lanczos3"}) {
    const Filter filter = filter_named(name).value();
    for (const auto& [width, height] :
         {std::pair(62u, 40u), std::pair(7u, 5u), std::pair(1u, 1u)}) {
      const StoredImage out = resized(image, width, height, filter);
      ASSERT_EQ(out.width, width);
      ASSERT_EQ(out.height, height);
      for (std::uint32_t i = 0; i < out.samples.size(); ++i) ASSERT_EQ(out.samples[i], 97.0f);
    }
  }
  EXPECT_FALSE(filter_named("cubic").has_value());
}

/// Halving by the box is the mean of two in linear light; by the triangle, 1 3 3 1 of eight.
TEST(UnitViewsTool, FiltersAreWhatTheyAreCalled) {
  StoredImage like;
  like.channels = 1;
  like.bits = 32;
  like.gamma = 1.0;
  StoredImage image = blank_like(like, 8, 1);
  image.samples.set(4, 1.0f);
  const StoredImage box = resized(image, 4, 1, Filter::kBox);
  EXPECT_FLOAT_EQ(box.samples[2], 0.5f);
  EXPECT_FLOAT_EQ(box.samples[1], 0.0f);
  const StoredImage triangle = resized(image, 4, 1, Filter::kTriangle);
  EXPECT_FLOAT_EQ(triangle.samples[2], 0.375f);
  EXPECT_FLOAT_EQ(triangle.samples[1], 0.125f);
  // Mitchell and Netravali's at whole distances: 8/9 and 1/18.
  const StoredImage mitchell = resized(image, 8, 1, Filter::kMitchell, 8.0 + 1e-12);
  EXPECT_NEAR(mitchell.samples[4], 8.0 / 9.0, 1e-6);
  EXPECT_NEAR(mitchell.samples[3], 1.0 / 18.0, 1e-6);
  const StoredImage lanczos = resized(image, 8, 1, Filter::kLanczos3, 8.0 + 1e-12);
  EXPECT_NEAR(lanczos.samples[4], 1.0, 1e-6);
  EXPECT_NEAR(lanczos.samples[3], 0.0, 1e-6);
}

TEST(UnitViewsTool, QuiltsBeginLowerLeft) {
  std::vector<StoredImage> views;
  for (int i = 0; i < 6; ++i) views.push_back(views_picture(4, 3, i));
  const StoredImage quilt = quilt_of(views, 3);
  ASSERT_EQ(quilt.width, 12u);
  ASSERT_EQ(quilt.height, 6u);
  EXPECT_EQ(quilt.at(0, 5, 2), 0.0f);
  EXPECT_EQ(quilt.at(11, 5, 2), 2.0f);
  EXPECT_EQ(quilt.at(0, 0, 2), 3.0f);
  EXPECT_EQ(quilt.at(11, 0, 2), 5.0f);
  EXPECT_EQ(quilt.at(5, 1, 0), 1.0f);
  EXPECT_EQ(quilt_suffix(8, 6, 0.75), "_qs8x6a0.75");
}

TEST(UnitViewsTool, PairsAndAnaglyphs) {
  StoredImage red = views_picture(1, 1), white = views_picture(1, 1, 255);
  red.samples.set(0, 255);
  white.samples.set(0, 255);
  white.samples.set(1, 255);
  const StoredImage pair = side_by_side(red, white);
  ASSERT_EQ(pair.width, 2u);
  EXPECT_EQ(pair.at(0, 0, 2), 0.0f);
  EXPECT_EQ(pair.at(1, 0, 2), 255.0f);
  const StoredImage plain = anaglyph(red, white, Anaglyph::kPlain);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(plain.at(0, 0, c), 255.0f);
  // Red alone: 0.437 of light in red; of white the right eye gets 0.377 + 0.761 + 0.009 - 0.062 in
  // green, which is above 1 and cut, and blue is cut too.
  const StoredImage dubois = anaglyph(red, views_picture(1, 1), Anaglyph::kDubois);
  EXPECT_EQ(dubois.at(0, 0, 0), std::floor(core::srgb_of_linear(0.437f) * 255.0f + 0.5f));
  EXPECT_EQ(dubois.at(0, 0, 1), 0.0f);
  const StoredImage grey = anaglyph(white, white, Anaglyph::kDubois);
  EXPECT_EQ(grey.at(0, 0, 0), 255.0f);
  EXPECT_EQ(grey.at(0, 0, 1), 255.0f);
}

std::uint32_t views_big(const std::string& bytes, std::size_t at, int size = 4) {
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

/// Chunks one after another, with their checksums held.
TEST(UnitViewsTool, AnimatedPng) {
  const std::vector<StoredImage> frames{views_picture(9, 5, 1), views_picture(9, 5, 2),
                                        views_picture(9, 5, 3)};
  const std::string bytes = apng_of(frames, 120);
  ASSERT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::string kinds;
  std::vector<std::string> packed;
  std::uint32_t sequence = 0;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::uint32_t length = views_big(bytes, at);
    const std::string kind = bytes.substr(at + 4, 4), data = bytes.substr(at + 8, length);
    kinds += kind + " ";
    const std::string body = kind + data;
    EXPECT_EQ(views_big(bytes, at + 8 + length),
              crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())))
        << kind;
    if (kind == "acTL") {
      EXPECT_EQ(views_big(data, 0), 3u);
      EXPECT_EQ(views_big(data, 4), 0u);
    } else if (kind == "fcTL") {
      EXPECT_EQ(length, 26u);
      EXPECT_EQ(views_big(data, 0), sequence++);
      EXPECT_EQ(views_big(data, 4), 9u);
      EXPECT_EQ(views_big(data, 8), 5u);
      EXPECT_EQ(views_big(data, 20, 2) * 1000.0 / views_big(data, 22, 2), 120.0);
    } else if (kind == "IDAT") {
      packed.push_back(data);
    } else if (kind == "fdAT") {
      EXPECT_EQ(views_big(data, 0), sequence++);
      packed.push_back(data.substr(4));
    }
    at += 12 + length;
  }
  EXPECT_EQ(kinds, "IHDR sRGB gAMA acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
  ASSERT_EQ(packed.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Bytef> rows(5 * 28);
    uLongf size = rows.size();
    ASSERT_EQ(uncompress(rows.data(), &size, reinterpret_cast<const Bytef*>(packed[i].data()),
                         packed[i].size()),
              Z_OK);
    ASSERT_EQ(size, rows.size());
    for (std::uint32_t y = 0; y < 5; ++y) {
      ASSERT_EQ(rows[y * 28], 2);
      for (std::uint32_t x = 0; x < 27; ++x) {
        if (y > 0) rows[y * 28 + 1 + x] += rows[(y - 1) * 28 + 1 + x];
        ASSERT_EQ(rows[y * 28 + 1 + x], frames[i].at(x / 3, y, static_cast<int>(x % 3)));
      }
    }
  }
  // Viewers that know nothing of it show the first frame.
  const tool::TemporaryFolder folder;
  tool::write_whole(folder / "a.png", bytes);
  const StoredImage read = core::read_image(folder / "a.png");
  ASSERT_EQ(read.samples.size(), frames[0].samples.size());
  for (std::size_t i = 0; i < read.samples.size(); ++i)
    ASSERT_EQ(read.samples[i], frames[0].samples[i]);
}

TEST(UnitViewsTool, Gif) {
  const std::vector<StoredImage> frames{views_picture(9, 5, 1), views_picture(9, 5, 255)};
  const tool::TemporaryFolder folder;
  tool::write_whole(folder / "a.gif", gif_of(frames, 128));
  const StoredImage first = core::read_image(folder / "a.gif");
  ASSERT_EQ(first.width, 9u);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(first.at(8, 4, c), frames[0].at(8, 4, c), 8.0f);
  int error = 0;
  GifFileType* const gif = DGifOpenFileName((folder / "a.gif").c_str(), &error);
  ASSERT_NE(gif, nullptr);
  ASSERT_EQ(DGifSlurp(gif), GIF_OK);
  EXPECT_EQ(gif->ImageCount, 2);
  GraphicsControlBlock control;
  ASSERT_EQ(DGifSavedExtensionToGCB(gif, 1, &control), GIF_OK);
  EXPECT_EQ(control.DelayTime, 13);
  const GifByteType entry = gif->SavedImages[1].RasterBits[44];
  EXPECT_NEAR(gif->SColorMap->Colors[entry].Blue, 255, 8);
  bool loops = false;
  for (int i = 0; i < gif->SavedImages[0].ExtensionBlockCount; ++i) {
    const ExtensionBlock& block = gif->SavedImages[0].ExtensionBlocks[i];
    loops |= block.ByteCount == 11 && std::memcmp(block.Bytes, "NETSCAPE2.0", 11) == 0;
  }
  EXPECT_TRUE(loops);
  DGifCloseFile(gif, &error);
}

/// Many colours become 256 that are near them.
TEST(UnitViewsTool, GifsOfManyColours) {
  const StoredImage picture = views_picture(200, 200, 90);
  const tool::TemporaryFolder folder;
  tool::write_whole(folder / "a.gif", gif_of({picture, picture}, 100));
  const StoredImage read = core::read_image(folder / "a.gif");
  double sum = 0.0;
  for (std::uint32_t y = 0; y < 200; ++y) {
    for (std::uint32_t x = 0; x < 200; ++x) {
      for (int c = 0; c < 3; ++c) sum += std::pow(read.at(x, y, c) - picture.at(x, y, c), 2.0);
    }
  }
  EXPECT_LT(std::sqrt(sum / (3 * 200 * 200)), 6.0);
}

TEST(UnitViewsTool, PicturesKeepTheirSamplesInFiles) {
  const tool::TemporaryFolder folder;
  About about;
  about.facts = {{"lens.pixels", "15"}, {"lens.view", "3"}};
  for (const char* name : {"a.png", "a.tif"}) {
    const StoredImage picture = views_picture(9, 5, 7);
    write_picture(picture, folder / name, about);
    const StoredImage read = core::read_image(folder / name);
    for (std::size_t i = 0; i < picture.samples.size(); ++i)
      ASSERT_EQ(read.samples[i], picture.samples[i]) << name;
    EXPECT_EQ(facts_of(read).at("lens.view"), "3") << name;
    EXPECT_FALSE(read.attributes.contains("XResolution")) << name;
  }
  // Floats hold light, and light becomes what viewers show.
  write_picture(views_picture(9, 5, 188), folder / "a.exr", about);
  const StoredImage light = core::read_image(folder / "a.exr");
  EXPECT_NEAR(light.at(0, 0, 2), core::linear_of_srgb(188.0f / 255.0f), 1e-3);
  EXPECT_EQ(facts_of(light).at("lens.pixels"), "15");
  write_picture(light, folder / "b.png", about);
  EXPECT_NEAR(core::read_image(folder / "b.png").at(0, 0, 2), 188.0f, 1.0f);
  write_picture(views_picture(9, 5, 188), folder / "a.jpg", about);
  EXPECT_NEAR(core::read_image(folder / "a.jpg").at(4, 2, 2), 188.0f, 6.0f);
  EXPECT_THROW(write_picture(light, folder / "a.bmp", about), core::ImageError);
}

}  // namespace
}  // namespace lentray::views
