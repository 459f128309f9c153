// Integral images on the page of one lens sheet: bleed, trim, paper.
// Units: mm unless said. Errors: PageError, worded for the user. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/image/reader.h"
#include "core/numeric/lens_columns.h"
#include "parser/options/length.h"
#include "tools/lentray-print/layout.h"
#include "tools/lentray-print/lens_data.h"
#include "tools/lentray-print/marks.h"
#include "tools/lentray-print/page.h"

namespace lentray::print {

struct SheetStyle {
  std::optional<parser::Extent> paper;  ///< either way round; none: a page as large as it takes
  double margin = 5.0;                  ///< blank border of the page
  double bleed = 0.0;  ///< printed beyond the trim; a whole number of lenses at the sides
  bool bleed_of_picture = false;  ///< the picture's own outer part; else its edges go on
  std::optional<double> gap;      ///< between pictures; none: kUsualGap, or what bleed needs
  bool is_across = false;         ///< the page is turned when it is done (mark_room())
  bool is_seen_together = false;  ///< strips of one pitch over the whole sheet
  Marks marks = Marks::all;
  Colour background = kWhite;
  std::string name;  ///< for the label
};

inline constexpr double kUsualGap = 5.0;

/// The picture with its bleed, and where the lenses are in it. Columns and rows count from the picture's first.
struct SheetArt {
  core::StoredImage image;
  core::LensColumns lenses;
  std::int64_t first_column = 0, first_row = 0;  ///< of the image: negative where the bleed goes on
  std::int64_t first_lens = 0, end_lens = 0;     ///< of the trimmed sheet
  std::int64_t trim_left = 0, trim_right = 0, trim_top = 0, trim_bottom = 0;
};

/// What is cut out of a picture of so many whole lenses and rows.
LayoutItem layout_item(std::int64_t lenses, std::int64_t rows, const LensData& data,
                       const SheetStyle& style);

/// `image`: as it is to be printed (as_printed()), whole lenses. `origin`: where its lens 0 begins, beside column 0.
SheetArt sheet_art(core::StoredImage image, const LensData& data, const SheetStyle& style,
                   double origin = 0.0);

/// Gaps between pictures. `lens`: columns from lens to lens of the sheet.
LayoutStyle layout_style(const LensData& data, const SheetStyle& style, double lens, double origin);

struct SheetPage {
  Page page;
  Box art{};                ///< where the pictures and their bleed are
  std::int64_t column = 0;  ///< of the page's grid, where the first picture's lens 0 begins
  std::vector<std::int64_t> boundaries{};  ///< columns between lenses, of the trimmed sheet
  std::vector<Box> cuts{};                 ///< what is cut out of each picture
};

/// The size of page that the pictures need.
parser::Extent needed_extent(const Layout& layout, const LensData& data, const SheetStyle& style);
/// Whether a paper has that size, upright or across.
bool has_room(const parser::Extent& paper, const parser::Extent& needed, const LensData& data);

/// On style.paper, upright or across, whichever holds it; PageError if neither does.
SheetPage sheet_page(std::vector<SheetArt> arts, const Layout& layout, const LensData& data,
                     const SheetStyle& style);
/// Of one picture.
SheetPage sheet_page(SheetArt art, const LensData& data, const SheetStyle& style);

}  // namespace lentray::print
