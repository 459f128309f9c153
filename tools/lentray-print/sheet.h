// An integral image on its page: bleed, trim, marks for cutting and for laying the lens sheet on, label.
//
// Marks: crop marks at the corners; gratings of the strips' own pitch round the picture, in step with its lenses, which
// turn dark or light as a whole once the lens sheet lies right; beside them plain bars parallel to the lenses, at no
// multiple of their pitch, whose edges show steps until lens sheet and print are parallel.
// Units: mm unless said. Errors: PageError, worded for the user. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/image/reader.h"
#include "parser/options/length.h"
#include "tools/lentray-print/lens_data.h"
#include "tools/lentray-print/page.h"

namespace lentray::print {

enum class Marks { none, crop, all };

struct SheetStyle {
  std::optional<parser::Extent> paper;  ///< either way round; none: a page as large as it takes
  double margin = 5.0;                  ///< blank border of the page
  double bleed = 0.0;  ///< printed beyond the trim; a whole number of lenses at the sides
  bool bleed_of_picture = false;  ///< the picture's own outer part; else its edges go on
  Marks marks = Marks::all;
  Colour background = kWhite;
  std::string name;  ///< for the label
};

/// The picture with its bleed, and where the lenses are in it. Columns and rows count from the picture's first.
struct SheetArt {
  core::StoredImage image;
  double pixels = 0.0;                           ///< N
  std::int64_t first_column = 0, first_row = 0;  ///< of the image: negative where the bleed goes on
  std::int64_t first_lens = 0, end_lens = 0;     ///< of the trimmed sheet
  std::int64_t trim_left = 0, trim_right = 0, trim_top = 0, trim_bottom = 0;
  std::uint32_t cut_columns = 0;  ///< of a lens that the picture had not whole, left out
};

/// `image`: as it is to be printed (as_printed()).
SheetArt sheet_art(core::StoredImage image, const LensData& data, const SheetStyle& style);

struct SheetPage {
  Page page;
  Box art{};                ///< where the picture and its bleed are
  std::int64_t column = 0;  ///< of the page's grid, where the picture's lens 0 begins
  std::vector<std::int64_t> boundaries{};  ///< columns between lenses, of the trimmed sheet
};

/// The size of page that the sheet needs.
parser::Extent needed_extent(const SheetArt& art, const LensData& data, const SheetStyle& style);
/// On style.paper, upright or across, whichever holds it; PageError if neither does.
SheetPage sheet_page(SheetArt art, const LensData& data, const SheetStyle& style);

}  // namespace lentray::print
