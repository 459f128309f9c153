#include "tools/common/natural_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace lentray::tool {
namespace {

using Files = std::vector<std::filesystem::path>;

/// Files in the order of a shell of the language C, taken in natural order.
Files taken(Files files) {
  std::ranges::sort(files, {}, [](const auto& file) { return file.string(); });
  return natural_order_instead(files).value_or(files);
}

TEST(UnitNaturalOrder, SignsWhereANumberWithoutStandsBesideAMinus) {
  for (const Files& meant :
       {Files{"v-2.png", "v-1.png", "v0.png", "v1.png", "v2.png"},
        Files{"a-10.png", "a-5.png", "a+0.png", "a+5.png", "a+10.png"},
        Files{"eye -12 deg.png", "eye -3 deg.png", "eye 0 deg.png", "eye 12 deg.png"},
        Files{"x_-1.75.png", "x_-1.5.png", "x_-0.5.png", "x_0.25.png", "x_0.5.png", "x_1.125.png"},
        Files{"L-3.tif", "L-1.tif", "L1.tif", "L3.tif"},
        Files{"row1/v-2.png", "row1/v-1.png", "row1/v0.png", "row2/v-11.png", "row2/v-2.png",
              "row2/v+1.png"},
        Files{"p-020.png", "p-003.png", "p000.png", "p004.png", "p010.png"}}) {
    EXPECT_EQ(taken(meant), meant);
  }
}

TEST(UnitNaturalOrder, DashesThatAreNoSigns) {
  for (const Files& meant : {Files{"frame-1.png", "frame-2.png", "frame-10.png", "frame-11.png"},
                             Files{"frame-0.png", "frame-1.png", "frame-2.png", "frame-10.png"},
                             Files{"2021-9-30.png", "2021-10-1.png", "2021-10-12.png"},
                             Files{"s1-1.png", "s1-2.png", "s1-10.png", "s2-1.png"},
                             Files{"a-1b.png", "a-2b.png", "a-10b.png", "b1.png", "b10.png"}}) {
    EXPECT_EQ(taken(meant), meant);
  }
}

TEST(UnitNaturalOrder, WhatSomebodyChoseStays) {
  EXPECT_FALSE(natural_order_instead({"v2.png", "v1.png", "v0.png", "v-1.png", "v-2.png"}));
  EXPECT_FALSE(natural_order_instead({"v-2.png", "v-1.png", "v0.png", "v1.png"}));
  EXPECT_TRUE(natural_order_instead({"v-1.png", "v-2.png", "v0.png", "v1.png"}));
}

}  // namespace
}  // namespace lentray::tool
