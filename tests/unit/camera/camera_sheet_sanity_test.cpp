// What is said of sheets whose data cannot be meant.
#include <gtest/gtest.h>

#include "camera/sheet_sanity.h"

namespace lentray::camera {
namespace {

struct Case {
  double pitch, pixels, width, height;
  std::vector<std::string> said;  ///< a part of each line
};

LensParameters lens_of(const Case& c) {
  LensParameters lens;
  lens.pitch = c.pitch;
  lens.focal_length = c.pitch;
  lens.pixels = c.pixels;
  return lens;
}

TEST(UnitSheetSanity, SaysWhatIsOddAndWhatToDo) {
  const Case cases[] = {
      {0.635, 15.0, 100.0, 75.0, {}},
      {0.635, 6.0, 6.36, 2000.0, {}},
      {5.0, 15.0, 2000.0, 75.0, {}},
      {25.4,
       15.0,
       1000.0,
       75.0,
       {"the lenses are 25.4 mm wide, wider than sheets are made: Lens_LPI is"}},
      {1.0,
       15.0,
       2500.0,
       75.0,
       {"the sheet is 2.5 m wide: if it is not, say Sheet_Width with its unit, such as 250mm"}},
      {1.0, 15.0, 250.0, 3000.0, {"the sheet is 3 m high: if it is not, say Sheet_Height"}},
      {0.635,
       15.0,
       3.0,
       3.0,
       {"the sheet has 4.724 lenses: a Sheet_Width of 6.35 mm, or 84.7 lpi, is the least"}},
      {0.254,
       3.0,
       100.0,
       75.0,
       {"a lens has 3 pixels, which is as many views: at least 600 dpi, or at most 50 lpi give it "
        "six"}},
      {25.4, 2.0, 2540.0, 75.0, {"25.4 mm wide", "2.54 m wide", "has 2 pixels"}}};
  for (const Case& c : cases) {
    LensRequest asked;
    asked.size = SheetSize{c.width, c.height};
    const std::vector<std::string> lines = sheet_sanity(lens_of(c), asked, c.width, c.height);
    ASSERT_EQ(lines.size(), c.said.size()) << c.pitch << " " << c.width;
    for (std::size_t i = 0; i < lines.size(); ++i)
      EXPECT_NE(lines[i].find(c.said[i]), std::string::npos) << lines[i];
  }
}

/// What is rendered for the screen may have few pixels a lens.
TEST(UnitSheetSanity, OnlyWhereAPrintIsMeant) {
  const LensParameters lens = lens_of({25.4, 2.0, 5000.0, 5000.0, {}});
  LensRequest asked;
  asked.pixels = 2.0;
  asked.lpi = 1.0;
  EXPECT_TRUE(sheet_sanity(lens, asked, 5000.0, 5000.0).empty());
  asked.print_dpi = 2.0;
  EXPECT_FALSE(sheet_sanity(lens, asked, 5000.0, 5000.0).empty());
  asked.print_dpi.reset();
  asked.sheet_name = "10lpi";
  EXPECT_FALSE(sheet_sanity(lens, asked, 5000.0, 5000.0).empty());
}

/// The figures keep what they promise, for slanted lenses and an eye that is near too.
TEST(UnitSheetSanity, TheResolutionThatIsNamedSuffices) {
  for (const double slant : {0.0, 0.5}) {
    for (const double distance : {20.0, 400.0, LensParameters::kInfinity}) {
      LensParameters lens = lens_of({0.42, 3.7, 100.0, 75.0, {}});
      lens.slant = slant;
      lens.view_distance = distance;
      const std::string text = resolution_for(lens, 6.0);
      double dpi = 0.0, lpi = 0.0;
      ASSERT_EQ(std::sscanf(text.c_str(), "at least %lf dpi, or at most %lf lpi", &dpi, &lpi), 2);
      EXPECT_GE(pixels_for_dpi(lens, dpi), 6.0 - 1e-9);
      EXPECT_LT(pixels_for_dpi(lens, dpi), 6.1);
      const double now = lens.print_dpi();
      lens.focal_length *= 25.4 / lpi / lens.pitch;  // of the same shape
      lens.pitch = 25.4 / lpi;
      EXPECT_GE(pixels_for_dpi(lens, now), 6.0 - 0.02) << text;
    }
  }
}

}  // namespace
}  // namespace lentray::camera
