// Pictures to files and back: quantisation, metadata, and that a good file survives.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>

#include "core/base/color.h"
#include "core/image/file_swap.h"
#include "core/image/quantiser.h"
#include "core/image/reader.h"
#include "core/image/writer.h"
#include "tests/unit/image/written_image.h"
#include "tools/common/process.h"

namespace lentray::core {
namespace {

namespace fs = std::filesystem;
using tool::TemporaryFolder;

Image ramp(std::uint32_t width, std::uint32_t height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] =
        i % 4 == 3 ? 0.5f : static_cast<float>(i) / static_cast<float>(image.rgba.size());
  }
  return image;
}

ImageFormat format_of(FileType type, int bits) {
  ImageFormat format;
  format.type = type;
  format.bits = bits;
  return format;
}

TEST(UnitImageQuantised, LinearRoundsHalfUpAndClips) {
  ImageFormat linear;
  linear.srgb = false;
  EXPECT_EQ(quantised(-0.1f, linear), 0u);
  EXPECT_EQ(quantised(0.0f, linear), 0u);
  EXPECT_EQ(quantised(0.49f / 255.0f, linear), 0u);
  EXPECT_EQ(quantised(0.51f / 255.0f, linear), 1u);
  EXPECT_EQ(quantised(0.5f, linear), 128u);
  EXPECT_EQ(quantised(1.0f, linear), 255u);
  EXPECT_EQ(quantised(7.0f, linear), 255u);
  EXPECT_EQ(quantised(std::nanf(""), linear), 0u);
  linear.bits = 16;
  EXPECT_EQ(quantised(0.5f, linear), 32768u);
  EXPECT_EQ(quantised(1.0f, linear), 65535u);
}

TEST(UnitImageQuantised, SrgbCurve) {
  // Reference values of IEC 61966-2-1, in double.
  for (const int bits : {8, 16}) {
    const ImageFormat format = format_of(FileType::png, bits);
    const double max = std::pow(2.0, bits) - 1.0;
    for (const double v : {0.001, 0.0031308, 0.01, 0.1, 0.2140, 0.5, 0.73, 0.999}) {
      const double e = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
      EXPECT_NEAR(quantised(static_cast<float>(v), format), e * max, 0.51) << v << " " << bits;
    }
  }
}

TEST(UnitImageQuantised, PowerLaw) {
  ImageFormat format;
  format.srgb = false;
  format.file_gamma = 2.2;
  EXPECT_EQ(quantised(0.5f, format), static_cast<unsigned>(255 * std::pow(0.5, 1 / 2.2) + 0.5));
  format.working_gamma = 2.2;  // undone and put on again
  EXPECT_EQ(quantised(0.5f, format), 128u);
}

TEST(UnitImageQuantised, TheTableIsTheFormula) {
  ImageFormat linear, power, working, coded;
  linear.srgb = power.srgb = working.srgb = false;
  power.file_gamma = 2.2;
  working.working_gamma = 2.2;
  working.file_gamma = 1.8;
  coded.working_srgb = true;
  for (ImageFormat format : {ImageFormat{}, linear, power, working, coded}) {
    for (const int bits : {8, 16}) {
      format.bits = bits;
      const Quantiser quantiser(format);
      const auto expect = [&](float v) { ASSERT_EQ(quantiser(v), quantised(v, format)) << v; };
      for (int i = -10; i < 100000; ++i) expect(static_cast<float>(i) / 90000.0f);
      for (float v = 1e-30f; v < 1e30f; v *= 1.01f) expect(v);
      for (const float v : {std::nanf(""), -0.0f, 0.0f, INFINITY, -INFINITY, -3.0f, 1.0f}) {
        expect(v);
      }
    }
  }
}

TEST(UnitImageFiles, IntegersComeBack) {
  const TemporaryFolder folder;
  const Image image = ramp(7, 5);
  for (const char* name : {"a.png", "a.tif"}) {
    for (const int bits : {8, 16}) {
      for (const bool alpha : {false, true}) {
        ImageFormat format = format_of(file_type_of(name), bits);
        format.alpha = alpha;
        write_image(image, folder / name, format);
        const StoredImage back = read_image(folder / name);
        ASSERT_EQ(back.width, 7u);
        ASSERT_EQ(back.height, 5u);
        ASSERT_EQ(back.channels, alpha ? 4 : 3);
        ASSERT_EQ(back.bits, bits);
        for (std::uint32_t y = 0; y < 5; ++y) {
          for (std::uint32_t x = 0; x < 7; ++x) {
            for (int c = 0; c < 3; ++c) {
              const float* p = image.pixel(x, y);
              // Files hold straight colours, and pixels brighter than opaque are made as opaque as bright.
              const float whole = alpha ? std::max(0.5f, grey({p[0], p[1], p[2]})) : 1.0f;
              ASSERT_EQ(back.at(x, y, c), quantised(p[c] / whole, format)) << name;
            }
            if (alpha && y < 2) {
              ASSERT_EQ(back.at(x, y, 3), bits == 8 ? 128 : 32768);
            }
          }
        }
      }
    }
  }
}

TEST(UnitImageFiles, OpenExrKeepsFloats) {
  const TemporaryFolder folder;
  const Image image = ramp(6, 3);
  write_image(image, folder / "a.exr", format_of(FileType::exr, 32));
  const StoredImage back = read_image(folder / "a.exr");
  EXPECT_EQ(back.bits, 32);
  EXPECT_EQ(back.gamma, 1.0);
  EXPECT_EQ(back.at(4, 2, 1), image.pixel(4, 2)[1]);
  write_image(image, folder / "a.exr", format_of(FileType::exr, 8));
  EXPECT_NEAR(read_image(folder / "a.exr").at(4, 2, 1), image.pixel(4, 2)[1], 1.0 / 2048);
}

TEST(UnitImageFiles, MetadataComesBack) {
  const TemporaryFolder folder;
  ImageMetadata metadata;
  metadata.dpi_x = 339.0;
  metadata.dpi_y = 170.5;
  metadata.software = "lentray";
  metadata.description = "a sheet";
  metadata.fields = {{"lentray:lens_pitch", "1.124"}};
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    write_image(ramp(4, 4), folder / name, format_of(file_type_of(name), 8), metadata);
    const auto attributes = read_image(folder / name).attributes;
    ASSERT_TRUE(attributes.count("XResolution")) << name;
    EXPECT_NEAR(std::stod(attributes.at("XResolution")), 339.0, 0.02) << name;
    EXPECT_NEAR(std::stod(attributes.at("YResolution")), 170.5, 0.02) << name;
    EXPECT_EQ(attributes.at("Software"), "lentray") << name;
    if (std::string(name) == "a.tif") {
      EXPECT_EQ(attributes.at("ImageDescription"), "a sheet\nlentray:lens_pitch=1.124");
    } else {
      EXPECT_EQ(attributes.at("lentray:lens_pitch"), "1.124") << name;
      EXPECT_EQ(attributes.at("ImageDescription"), "a sheet") << name;
    }
  }
}

TEST(UnitImageFiles, SamePictureSameBytes) {
  const TemporaryFolder folder;
  write_image(ramp(9, 9), folder / "a.png", {});
  write_image(ramp(9, 9), folder / "b.png", {});
  EXPECT_EQ(tool::read_text(folder / "a.png"), tool::read_text(folder / "b.png"));
}

/// A file's bytes but for the time of writing, which TIFF and OpenEXR hold.
std::string without_time(const std::string& bytes) {
  static const std::regex kTime(R"(\d{4}:\d\d:\d\d \d\d:\d\d:\d\d)");
  return std::regex_replace(bytes, kTime, "");
}

TEST(UnitImageFiles, BandsMakeTheSameFile) {
  const TemporaryFolder folder;
  const Image image = ramp(50, 77);
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    const ImageFormat format = format_of(file_type_of(name), 16);
    write_image(image, folder / name, format);
    const std::string whole = without_time(tool::read_text(folder / name));
    for (const std::uint32_t height : {1u, 10u, 33u, 76u}) {
      PictureWriter writer(folder / name, 50, 77, format);
      for (std::uint32_t top = 0; top < 77; top += height) {
        Image band(50, std::min(height, 77 - top));
        std::copy_n(image.pixel(0, top), band.rgba.size(), band.rgba.data());
        writer.put(band);
      }
      writer.finish();
      EXPECT_TRUE(read_image(folder / name).samples.size() == 50 * 77 * 3);
      EXPECT_TRUE(without_time(tool::read_text(folder / name)) == whole) << name;
    }
  }
}

TEST(UnitImageFiles, GivenUpHalfWayNothingIsLeft) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    for (const std::uint32_t rows : {0u, 1u, 40u}) {
      PictureWriter writer(folder / name, 50, 77, format_of(file_type_of(name), 8));
      if (rows > 0) writer.put(ramp(50, rows));
      EXPECT_FALSE(fs::is_empty(folder.path()));
    }
    EXPECT_TRUE(fs::is_empty(folder.path())) << name;
    PictureWriter writer(folder / name, 50, 77, format_of(file_type_of(name), 8));
    EXPECT_THROW(writer.finish(), ImageError) << "rows are missing";
  }
}

/// A file of that name, as a killed process leaves it.
fs::path left_over(const TemporaryFolder& folder, const std::string& name) {
  tool::write_text(folder / name, "half a picture");
  return folder / name;
}

TEST(UnitImageFiles, WhatAKilledProcessLeftIsClearedAway) {
  const TemporaryFolder folder;
  const fs::path mine = left_over(folder, ".a.png.lentray-99999-0.part");
  const fs::path other = left_over(folder, ".b.png.lentray-99999-0.part");
  const fs::path strange = left_over(folder, ".a.png.lentray-notes");
  {
    const FileSwap first(folder / "a.png");
    EXPECT_FALSE(fs::exists(mine));
    const FileSwap second(folder / "a.png");
    EXPECT_TRUE(fs::exists(first.temporary())) << "its maker lives";
    EXPECT_NE(first.temporary(), second.temporary());
  }
  EXPECT_TRUE(fs::exists(other));
  EXPECT_TRUE(fs::exists(strange));
}

TEST(UnitImageFiles, WhatAKilledProcessHoldsForAWhileIsClearedAwayInTheEnd) {
  const TemporaryFolder folder;
  const fs::path part = left_over(folder, ".a.png.lentray-99999-0.part");
  const int held = ::open(part.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  FileSwap swap(folder / "a.png");
  EXPECT_TRUE(fs::exists(part)) << "its maker may live";
  ::close(held);
  swap.commit();
  EXPECT_FALSE(fs::exists(part));
  EXPECT_TRUE(fs::exists(folder / "a.png"));
}

TEST(UnitImageFiles, LongNamesHaveRoomForTheTemporaryOne) {
  const TemporaryFolder folder;
  const std::string name = std::string(250, 'x') + ".png";
  write_image(ramp(3, 3), folder / name, {});
  EXPECT_EQ(read_image(folder / name).width, 3u);
}

TEST(UnitImageFiles, AFileThatIsWrittenAgainKeepsItsMode) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.png", "before");
  std::filesystem::permissions(
      folder / "a.png", std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  FileSwap swap(folder / "a.png");
  tool::write_text(swap.temporary(), "after");
  swap.commit();
  EXPECT_EQ(tool::read_text(folder / "a.png"), "after");
  EXPECT_EQ(std::filesystem::status(folder / "a.png").permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST(UnitImageFiles, NoPartIsLeftBehind) {
  const TemporaryFolder folder;
  write_image(ramp(9, 9), folder / "a.png", {});
  {
    FileSwap swap(folder / "b.png");
    std::ofstream(swap.temporary()) << "half";
    EXPECT_TRUE(fs::exists(swap.temporary()));
  }
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    ++files;
    EXPECT_EQ(entry.path().filename(), "a.png");
  }
  EXPECT_EQ(files, 1u);
}

TEST(UnitImageFiles, LinksAreFollowed) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "real");
  tool::write_text(folder / "real/a.png", "old");
  fs::create_symlink("real/a.png", folder / "link.png");
  write_image(ramp(3, 3), folder / "link.png", {});
  EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
  EXPECT_EQ(read_image(folder / "real/a.png").width, 3u);
}

std::string message_of(const fs::path& path, const Image& image, const ImageFormat& format) {
  try {
    write_image(image, path, format);
  } catch (const ImageError& e) {
    return e.what();
  }
  return "no error";
}

TEST(ErrorImage, EachSaysWhatIsWrong) {
  const TemporaryFolder folder;
  const Image image = ramp(3, 3);
  EXPECT_NE(message_of(folder / "none/a.png", image, {}).find("does not exist"), std::string::npos);
  fs::create_directory(folder / "taken.png");
  EXPECT_NE(message_of(folder / "taken.png", image, {}).find("a folder has that name"),
            std::string::npos);
  tool::write_text(folder / "file", "x");
  EXPECT_NE(message_of(folder / "file/a.png", image, {}).find("is not a folder"),
            std::string::npos);
  EXPECT_NE(message_of(folder / "a.png", Image(), {}).find("empty"), std::string::npos);
  EXPECT_NE(
      message_of(folder / "a.tga", Image(65536, 1), format_of(FileType::targa, 8)).find("65535"),
      std::string::npos);
  EXPECT_THROW(file_type_of("a.gif"), ImageError);
  EXPECT_EQ(file_type_of("A.TIFF"), FileType::tiff);
  EXPECT_THROW(read_image(folder / "nothing.png"), ImageError);
  EXPECT_THROW(read_image(folder / "file"), ImageError);
}

TEST(ErrorImage, GoodFileSurvivesFailure) {
  const TemporaryFolder folder;
  write_image(ramp(3, 3), folder / "a.png", {});
  const std::string before = tool::read_text(folder / "a.png");
  EXPECT_NE(message_of(folder / "a.png", Image(), {}), "no error");
  Image cut = ramp(4, 4);
  cut.rgba.pop_back();
  EXPECT_NE(message_of(folder / "a.png", cut, {}), "no error");
  EXPECT_EQ(tool::read_text(folder / "a.png"), before);
}

}  // namespace
}  // namespace lentray::core
