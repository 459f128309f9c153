// The page of lentray-views --preview without a browser: which pixels go into it, what it becomes where it must be
// smaller, and what is refused. What a browser makes of it: tests/views/preview_in_browser.py.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/image/writer.h"
#include "tools/common/page_text.h"
#include "tools/common/process.h"
#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/moving.h"
#include "tools/lentray-views/page_strips.h"
#include "tools/lentray-views/picture.h"
#include "tools/lentray-views/preview.h"

namespace lentray::views {
namespace {

using core::StoredImage;

/// Colours that no code makes small: a hash of the place.
StoredImage preview_noise(std::uint32_t width, std::uint32_t height, int channels = 3) {
  StoredImage like;
  like.channels = channels;
  like.gamma = -1.0;
  StoredImage out = blank_like(like, width, height);
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < out.samples.size(); ++i) {
    state = state * 1664525u + 1013904223u;
    out.samples.set(i, static_cast<float>(state >> 24));
  }
  return out;
}

SheetOptions preview_sheet(double pixels) {
  SheetOptions options;
  options.pixels = pixels;
  options.pitch = 1.0;
  options.focal_length = 2.5;
  options.ior = 1.5;
  options.view_distance = 300.0;
  options.aspect = 2.0;
  return options;
}

Integral preview_integral(StoredImage image, const SheetOptions& options) {
  Sheet sheet = sheet_of(image, options, "folder/a.png");
  return {std::move(image), std::move(sheet), {}, "folder/a.png"};
}

std::string preview_message(const Integral& integral, const Arguments& arguments = {}) {
  try {
    (void)preview_of(integral, arguments);
  } catch (const core::ImageError& error) {
    return error.what();
  }
  return {};
}

nlohmann::json data_of(const std::string& page) {
  const std::string mark = "id=\"data\">";
  const std::size_t from = page.find(mark) + mark.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

/// Strip j has the j-th column behind each lens; lenses of 2.5 pixels have two columns or three.
TEST(UnitViewsPreview, StripsAreColumnsBehindTheLenses) {
  const StoredImage image = preview_noise(10, 4);
  const Sheet sheet = sheet_of(image, preview_sheet(2.5), "a.png");
  const PageStrips strips = page_strips(image, sheet.lenses, 1'000'000);
  EXPECT_EQ(strips.quality, 0);
  EXPECT_EQ(strips.rows, 4u);
  // (k + 1/2)/2.5 rounded down: 0 0 1 1 1 2 2 3 3 3, with the boundary at k = 2 to the right.
  const int columns[3][4] = {{0, 2, 5, 7}, {1, 3, 6, 8}, {-1, 4, -1, 9}};
  ASSERT_EQ(strips.links.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    StoredImage wanted = blank_like(image, 4, 4);
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (columns[j][i] >= 0)
        copy_pixels(image, {static_cast<std::uint32_t>(columns[j][i]), 0, 1, 4}, wanted, i, 0);
    }
    EXPECT_EQ(strips.links[j], "data:image/png;base64," + tool::base64(png_of(wanted))) << j;
  }
}

TEST(UnitViewsPreview, APngIsReadBackAsItWas) {
  const tool::TemporaryFolder folder;
  const StoredImage image = preview_noise(7, 5);
  tool::write_text(folder / "a.png", png_of(image));
  const StoredImage back = core::read_image(folder / "a.png");
  ASSERT_EQ(back.width, 7u);
  ASSERT_EQ(back.samples.size(), image.samples.size());
  for (std::size_t i = 0; i < image.samples.size(); ++i)
    EXPECT_EQ(back.samples[i], image.samples[i]);
}

/// Transparent parts stand before black, grey becomes colour, and 16 bits and linear values what screens show.
TEST(UnitViewsPreview, OtherPicturesBecomeRgbOfEightBits) {
  StoredImage like;
  like.channels = 4;
  like.gamma = -1.0;
  StoredImage clear = blank_like(like, 4, 1), grey = clear, linear = clear;
  grey.channels = 1;
  linear.channels = 3;
  linear.bits = 16;
  linear.gamma = 1.0;
  grey = blank_like(grey, 4, 1);
  linear = blank_like(linear, 4, 1);
  for (std::uint32_t k = 0; k < 4; ++k) {
    clear.samples.set(clear.place(k, 0, 0), 200);
    clear.samples.set(clear.place(k, 0, 3), k % 2 == 0 ? 255 : 0);
    grey.samples.set(grey.place(k, 0, 0), 90);
    linear.samples.set(linear.place(k, 0, 0), 65535);
    linear.samples.set(linear.place(k, 0, 1), 14146);  // the light of 128 of 255
  }
  const auto first_and_second = [&](const StoredImage& image, std::array<int, 3> first,
                                    std::array<int, 3> second) {
    const Sheet sheet = sheet_of(image, preview_sheet(2), "a.png");
    const PageStrips strips = page_strips(image, sheet.lenses, 1'000'000);
    StoredImage rgb;
    rgb.channels = 3;
    rgb.gamma = -1.0;
    for (const std::size_t j : {0u, 1u}) {
      StoredImage wanted = blank_like(rgb, 2, 1);
      for (std::size_t i = 0; i < 6; ++i)
        wanted.samples.set(i, static_cast<float>((j == 0 ? first : second)[i % 3]));
      EXPECT_EQ(strips.links.at(j), "data:image/png;base64," + tool::base64(png_of(wanted))) << j;
    }
  };
  first_and_second(clear, {200, 0, 0}, {0, 0, 0});
  first_and_second(grey, {90, 90, 90}, {90, 90, 90});
  first_and_second(linear, {255, 128, 0}, {255, 128, 0});
}

TEST(UnitViewsPreview, ThePageSaysWhatTheSheetIs) {
  Arguments arguments;
  arguments.eyes = 61.0;
  const Integral integral = preview_integral(preview_noise(60, 20), preview_sheet(5));
  const Preview preview = preview_of(integral, arguments);
  EXPECT_NE(preview.told.find("the picture's own pixels"), std::string::npos) << preview.told;
  EXPECT_NE(preview.page.find("<title>a.png through its lenses</title>"), std::string::npos);
  const nlohmann::json data = data_of(preview.page);
  EXPECT_EQ(data["count"], 12);
  EXPECT_EQ(data["columns"], 60);
  EXPECT_EQ(data["rows"], 20);
  EXPECT_EQ(data["eyes"], 61.0);
  EXPECT_EQ(data["distance"], 300.0);
  EXPECT_EQ(data["view_distance"], 300.0);
  EXPECT_EQ(data["is_paraxial"], true);
  EXPECT_EQ(data["height_mm"], 6.0);  // 12 lenses of 1 mm, twice as wide as high
  EXPECT_EQ(data["strips"].size(), 5u);
  EXPECT_EQ(data["first"], integral.sheet.lenses.column(0).centre);  // the same double
  EXPECT_EQ(data["pixel_size"], integral.sheet.lenses.lens().pixel_size());
}

/// Noise of 3 MB: as it is, as JPEG, with fewer rows, not at all.
TEST(UnitViewsPreview, WhatIsTooLargeBecomesJpegAndLosesRows) {
  const Integral integral = preview_integral(preview_noise(1000, 1000), preview_sheet(5));
  Arguments arguments;
  EXPECT_NE(preview_of(integral, arguments).told.find("own pixels"), std::string::npos);
  arguments.page_limit = 3.0;
  const Preview jpeg = preview_of(integral, arguments);
  EXPECT_NE(jpeg.told.find("JPEG of quality"), std::string::npos) << jpeg.told;
  EXPECT_EQ(jpeg.told.find("rows"), std::string::npos) << jpeg.told;
  EXPECT_LE(jpeg.page.size(), 3'000'000u);
  EXPECT_EQ(data_of(jpeg.page)["strips"][0].get<std::string>().substr(0, 23),
            "data:image/jpeg;base64,");
  arguments.page_limit = 0.5;
  const Preview small = preview_of(integral, arguments);
  EXPECT_NE(small.told.find("JPEG of quality 84, 1000 rows scaled to "), std::string::npos)
      << small.told;
  EXPECT_NE(small.page.find("For the size of this page: JPEG of quality 84, 1000 rows scaled to"),
            std::string::npos);
  EXPECT_LE(small.page.size(), 500'000u);
  const nlohmann::json data = data_of(small.page);
  EXPECT_LT(data["rows"], 1000);
  EXPECT_EQ(data["count"], 200);  // columns never change
  arguments.page_limit = 0.04;
  const std::string frame = preview_message(integral, arguments);
  const std::size_t at = frame.find(" kB before it has a picture: raise --page-limit");
  if (at != std::string::npos) {
    arguments.page_limit =
        (std::atoi(frame.c_str() + std::string("a page takes ").size()) + 1) / 1e3;
  }
  EXPECT_EQ(preview_message(integral, arguments),
            "the picture does not go into a page of that size: raise --page-limit");
}

TEST(UnitViewsPreview, WhatIsMissingIsAskedFor) {
  SheetOptions options = preview_sheet(5);
  options.ior.reset();
  options.pitch.reset();
  EXPECT_EQ(preview_message(preview_integral(preview_noise(60, 20), options)),
            "'folder/a.png' does not say all of its lenses: give --lens-pitch, --lens-ior");
  options = preview_sheet(5);
  options.aspect.reset();
  EXPECT_NE(preview_message(preview_integral(preview_noise(60, 20), options)).find("give --aspect"),
            std::string::npos);
}

}  // namespace
}  // namespace lentray::views
