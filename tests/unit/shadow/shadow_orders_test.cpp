#include "shadow/pixel_orders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace lentray;

namespace {

std::vector<core::Pixel> shadow_orders_all(const core::PixelOrder& order) {
  std::vector<core::Pixel> pixels, job;
  for (std::size_t j = 0; j < order.jobs(); ++j) {
    order.pixels(j, job);
    pixels.insert(pixels.end(), job.begin(), job.end());
  }
  return pixels;
}

camera::LensSheet shadow_orders_sheet(std::uint32_t width, double pixels) {
  camera::LensParameters lens;
  lens.pixels = pixels;
  return {lens, width};
}

struct Size {
  std::uint32_t width, height;
};
constexpr Size kSizes[] = {{1, 1},    {1, 500}, {733, 1},  {160, 120}, {399, 400},
                           {3, 2},    {32, 32}, {33, 65},  {31, 97},   {1000, 31},
                           {128, 64}, {45, 33}, {64, 1000}};

/// Every pixel of the rows [top, bottom) is there, once.
void expect_all(const core::PixelOrder& order, std::uint32_t width, std::uint32_t top,
                std::uint32_t bottom) {
  std::vector<bool> seen(std::size_t{width} * (bottom - top));
  std::size_t count = 0;
  for (const core::Pixel p : shadow_orders_all(order)) {
    ASSERT_LT(p.column, width);
    ASSERT_GE(p.row, top);
    ASSERT_LT(p.row, bottom);
    const std::size_t place = std::size_t{p.row - top} * width + p.column;
    ASSERT_FALSE(seen[place]) << p.column << ", " << p.row << " twice";
    seen[place] = true;
    ++count;
  }
  ASSERT_EQ(count, seen.size());
}

TEST(UnitShadowOrders, EveryPixelOnce) {
  std::vector<std::string_view> names = shadow::order_names();
  names.insert(names.end(),
               {"combined(1)", "combined(7)", "strips(3,5)", "strips(1,9)", "strips(999,4)"});
  for (const auto name : names) {
    for (const Size& size : kSizes) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(size.width) + " x " +
                   std::to_string(size.height));
      expect_all(*shadow::make_order(name, size.width, size.height), size.width, 0, size.height);
      for (const double pixels : {1.0, 2.0, 12.5, 15.0, 1000.0}) {
        const auto lenses = shadow_orders_sheet(size.width, pixels);
        expect_all(*shadow::make_order(name, {0, 0, size.width, size.height}, &lenses), size.width,
                   0, size.height);
        const auto bands = shadow::make_band_orders(name, {0, size.width}, &lenses);
        for (const std::uint32_t height : {1u, 7u, 32u, 500u}) {
          for (std::uint32_t top = 0; top < size.height; top += height) {
            const std::uint32_t bottom = std::min(top + height, size.height);
            expect_all(*bands->band(top, bottom), size.width, top, bottom);
          }
        }
      }
    }
  }
}

TEST(UnitShadowOrders, JobsTogetherAreTheOrder) {
  // Wherever a run is cut, it goes on where the one before ended: against a plain loop.
  const auto lenses = shadow_orders_sheet(399, 12.5);
  const auto expect = [&](const char* name, const std::vector<core::Pixel>& wanted) {
    const auto pixels = shadow_orders_all(*shadow::make_order(name, {0, 0, 399, 70}, &lenses));
    ASSERT_EQ(pixels.size(), wanted.size()) << name;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      ASSERT_TRUE(pixels[i].column == wanted[i].column && pixels[i].row == wanted[i].row)
          << name << ": number " << i << " is " << pixels[i].column << ", " << pixels[i].row;
    }
  };
  std::vector<core::Pixel> rows, columns, views, tiles;
  for (std::uint32_t r = 0; r < 70; ++r) {
    for (std::uint32_t c = 0; c < 399; ++c) rows.push_back({c, r});
  }
  for (std::uint32_t c = 0; c < 399; ++c) {
    for (std::uint32_t r = 0; r < 70; ++r) columns.push_back({c, r});
  }
  for (std::uint32_t j = 0; j < 13; ++j) {
    for (std::uint32_t r = 0; r < 70; ++r) {
      for (std::uint32_t i = 0; i < 32; ++i) {
        // Lens i has the columns k with floor((k + 1/2) / 12.5) = i.
        const std::uint32_t first = 25 * i / 2, end = 25 * (i + 1) / 2;
        if (first + j < end && first + j < 399) views.push_back({first + j, r});
      }
    }
  }
  for (std::uint32_t y = 0; y < 70; y += 32) {
    for (std::uint32_t x = 0; x < 399; x += 32) {
      for (std::uint32_t r = y; r < std::min(y + 32, 70u); ++r) {
        for (std::uint32_t c = x; c < std::min(x + 32, 399u); ++c) tiles.push_back({c, r});
      }
    }
  }
  expect("rows", rows);
  expect("columns", columns);
  expect("views", views);
  expect("tiles", tiles);
}

TEST(UnitShadowOrders, StripsOfLenses) {
  // Lenses of 12 and 13 columns, cut into strips of 5, 5 and 2 or 3; groups of 8 rows, the last of 6.
  const auto lenses = shadow_orders_sheet(399, 12.5);
  std::vector<core::Pixel> combined, strips;
  const auto strip = [&](std::uint32_t top, std::uint32_t rows, std::vector<core::Pixel>& out) {
    for (std::uint32_t s = 0; s < 3; ++s) {
      for (std::uint32_t i = 0; i < 32; ++i) {
        const std::uint32_t first = 25 * i / 2, end = std::min(25 * (i + 1) / 2, 399u);
        for (std::uint32_t r = top; r < top + rows; ++r) {
          for (std::uint32_t c = first + 5 * s; c < std::min(end, first + 5 * s + 5); ++c) {
            out.push_back({c, r});
          }
        }
      }
    }
  };
  for (std::uint32_t r = 0; r < 70; ++r) strip(r, 1, combined);
  for (std::uint32_t r = 0; r < 70; r += 8) strip(r, std::min(8u, 70 - r), strips);
  const auto expect = [&](const char* name, const std::vector<core::Pixel>& wanted) {
    const auto pixels = shadow_orders_all(*shadow::make_order(name, {0, 0, 399, 70}, &lenses));
    ASSERT_EQ(pixels.size(), wanted.size()) << name;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      ASSERT_TRUE(pixels[i].column == wanted[i].column && pixels[i].row == wanted[i].row)
          << name << ": number " << i << " is " << pixels[i].column << ", " << pixels[i].row;
    }
  };
  expect("combined(5)", combined);
  expect("strips(5,8)", strips);
  expect("strips(5,1)", combined);
}

TEST(UnitShadowOrders, StripsWithoutASheetAreTiles) {
  const auto strips = shadow_orders_all(*shadow::make_order("strips(32,32)", 100, 70));
  const auto tiles = shadow_orders_all(*shadow::make_order("tiles", 100, 70));
  ASSERT_EQ(strips.size(), tiles.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    ASSERT_EQ(strips[i].column, tiles[i].column);
    ASSERT_EQ(strips[i].row, tiles[i].row);
  }
}

TEST(UnitShadowOrders, HilbertGoesFromNeighbourToNeighbour) {
  // From square to square too, within a row of squares.
  const auto pixels =
      shadow_orders_all(*shadow::make_order("hilbert", 3 * shadow::kHilbert, shadow::kHilbert));
  ASSERT_EQ(pixels.size(), 3u * shadow::kHilbert * shadow::kHilbert);
  for (std::size_t i = 1; i < pixels.size(); ++i) {
    const int dx =
        std::abs(static_cast<int>(pixels[i].column) - static_cast<int>(pixels[i - 1].column));
    const int dy = std::abs(static_cast<int>(pixels[i].row) - static_cast<int>(pixels[i - 1].row));
    ASSERT_EQ(dx + dy, 1) << "at " << i;
  }
}

TEST(UnitShadowOrders, SerpentineGoesDownAndUpColumnsOfSquares) {
  // Two squares and a bit across, one and a bit down.
  constexpr std::uint32_t kSide = shadow::kSerpentine, kWide = 2 * kSide + 5, kHigh = kSide + 3;
  std::vector<core::Pixel> wanted;
  for (std::uint32_t top = 0; top < kHigh; top += kSide) {
    const std::uint32_t end = std::min(top + kSide, kHigh);
    for (std::uint32_t c = 0; c < kWide; ++c) {
      if (c % kSide % 2 == 0) {
        for (std::uint32_t r = top; r < end; ++r) wanted.push_back({c, r});
      } else {
        for (std::uint32_t r = end; r-- > top;) wanted.push_back({c, r});
      }
    }
  }
  const auto pixels = shadow_orders_all(*shadow::make_order("serpentine", kWide, kHigh));
  ASSERT_EQ(pixels.size(), wanted.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ASSERT_EQ(pixels[i].column, wanted[i].column) << i;
    ASSERT_EQ(pixels[i].row, wanted[i].row) << i;
  }
}

TEST(UnitShadowOrders, AutoIsSerpentineOnASheetAndHilbertWithout) {
  const auto lenses = shadow_orders_sheet(150, 15.0);
  const auto same = [](const std::vector<core::Pixel>& a, const std::vector<core::Pixel>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
      return p.column == q.column && p.row == q.row;
    });
  };
  const shadow::PixelRegion region{0, 0, 150, 70};
  EXPECT_TRUE(same(shadow_orders_all(*shadow::make_order("auto", region, &lenses)),
                   shadow_orders_all(*shadow::make_order("serpentine", region, &lenses))));
  EXPECT_TRUE(same(shadow_orders_all(*shadow::make_order("auto", region)),
                   shadow_orders_all(*shadow::make_order("hilbert", region))));
}

TEST(UnitShadowOrders, WithoutASheetThereIsOneView) {
  const auto views = shadow_orders_all(*shadow::make_order("views", 40, 30));
  const auto rows = shadow_orders_all(*shadow::make_order("rows", 40, 30));
  ASSERT_EQ(views.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(views[i].column, rows[i].column);
    ASSERT_EQ(views[i].row, rows[i].row);
  }
}

TEST(UnitShadowOrders, BandsFitTheMemory) {
  const auto height = [](const char* name, std::uint32_t w, std::uint32_t h, double memory) {
    return shadow::band_height(name, w, h, 40.0 * w, memory);
  };
  constexpr double kPlenty = 8e9;
  for (const auto name : shadow::order_names()) {
    EXPECT_EQ(height(name.data(), 160, 120, kPlenty), 120u) << "small pictures are one band";
    EXPECT_EQ(height(name.data(), 24000, 24000, 0.0), 1u) << name;
    EXPECT_EQ(height(name.data(), 24000, 24000, -1e9), 1u) << name;
    for (const double memory : {1e6, 1e7, 1e8, 1e9, kPlenty}) {
      const std::uint32_t rows = height(name.data(), 24000, 24000, memory);
      EXPECT_GE(rows, 1u);
      EXPECT_LE(rows * 40.0 * 24000, std::max(memory, 40.0 * 24000)) << name;
      EXPECT_LE(rows * 40.0 * 24000, 4e8) << name << ": never more than some";
    }
  }
  EXPECT_EQ(height("columns", 1995, 2000, kPlenty), 2000u);
  EXPECT_EQ(height("views", 24000, 24000, kPlenty), 348u);  // 69 bands, all but equal
  EXPECT_EQ(height("rows", 1995, 2000, kPlenty), 250u) << "others write while the next is traced";
  EXPECT_EQ(height("tiles", 1995, 2000, kPlenty) % shadow::kTile, 0u);
  EXPECT_EQ(height("tiles", 24000, 24000, kPlenty), shadow::kTile);
  EXPECT_LE(height("tiles", 24000, 24000, 1e7), 10u) << "memory comes before whole tiles";
}

TEST(UnitShadowOrders, RowsRunAlongRowsAndColumnsDownColumns) {
  const auto rows = shadow_orders_all(*shadow::make_order("rows", 50, 40));
  const auto columns = shadow_orders_all(*shadow::make_order("Columns", 50, 40));
  EXPECT_EQ(rows[1].column, 1u);
  EXPECT_EQ(rows[1].row, 0u);
  EXPECT_EQ(rows[50].row, 1u);
  EXPECT_EQ(columns[1].row, 1u);
  EXPECT_EQ(columns[1].column, 0u);
  EXPECT_EQ(columns[40].column, 1u);
}

TEST(UnitShadowOrders, JobsAreManyAndHoldRuns) {
  for (const auto name : shadow::order_names()) {
    const auto order = shadow::make_order(name, 1995, 2000);
    EXPECT_GE(order->jobs(), 64u);
    std::vector<core::Pixel> job;
    order->pixels(0, job);
    EXPECT_GE(job.size(), 1995u) << "at least a whole line";
  }
}

TEST(UnitShadowOrders, RegionsStayWithinTheirBorders) {
  const auto order = shadow::make_order("rows", {10, 20, 13, 22});
  const auto pixels = shadow_orders_all(*order);
  ASSERT_EQ(pixels.size(), 6u);
  EXPECT_EQ(pixels.front().column, 10u);
  EXPECT_EQ(pixels.front().row, 20u);
  EXPECT_EQ(pixels.back().column, 12u);
  EXPECT_EQ(pixels.back().row, 21u);
  EXPECT_EQ(shadow::make_order("columns", {5, 5, 5, 9})->jobs(), 0u);
}

TEST(ErrorShadowOrders, UnknownNameListsWhatThereIs) {
  try {
    shadow::make_order("diagonal", 4, 4);
    FAIL() << "no exception";
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(),
                 "unknown pixel order 'diagonal': there are auto, rows, views, columns, combined, "
                 "strips, tiles, serpentine, hilbert, adaptive");
  }
}

TEST(ErrorShadowOrders, Numbers) {
  const auto message = [](const char* name) -> std::string {
    try {
      shadow::make_order(name, 4, 4);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message("rows(3)"), "pixel order 'rows(3)': rows takes no numbers");
  EXPECT_EQ(message("rows()"), "pixel order 'rows()': rows takes no numbers");
  const std::string combined = " takes a width of 1 or more pixels, such as combined(4)";
  for (const char* name :
       {"combined()", "combined(0)", "combined(-1)", "combined(x)", "combined(2,3)", "combined(2",
        "combined(2)3", "combined(99999999999)"}) {
    EXPECT_EQ(message(name), "pixel order '" + std::string(name) + "': combined" + combined);
  }
  for (const char* name :
       {"strips(4)", "strips(4,)", "strips(,4)", "strips(4,0)", "strips(1,2,3)"}) {
    EXPECT_EQ(message(name), "pixel order '" + std::string(name) +
                                 "': strips takes a width and a height of 1 or more pixels, such "
                                 "as strips(4,32)");
  }
  for (const char* name : {"Combined( 3 )", "strips( 2 , 5 )", "strips (2,5)", "HILBERT"}) {
    EXPECT_EQ(message(name), "");
  }
}

}  // namespace
