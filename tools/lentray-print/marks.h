// Marks round the pictures of a lens sheet: for cutting, and for laying the lens sheet on.
//
// Crop marks at the corners of all that is cut out; gratings of the strips' own pitch round the whole, in step with its
// lenses, which turn dark or light as a whole once the lens sheet lies right; beside them plain bars parallel to the
// lenses, at no multiple of their pitch, whose edges show steps until lens sheet and print are parallel.
// Units: mm unless said. Errors: none. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/numeric/lens_columns.h"
#include "tools/lentray-print/lens_data.h"
#include "tools/lentray-print/page.h"

namespace lentray::print {

enum class Marks { none, crop, all };

/// How far marks reach from the pictures and their bleed.
struct MarkRoom {
  std::int64_t gap_lenses = 0, line_lenses = 0;
  double bar_width = 0.0;
  double across = 0.0, down = 0.0;
};
/// `is_across`: the page is turned by a quarter when it is done, as for lenses that lie across. Words then stand where they
/// are read upright on the turned page.
MarkRoom mark_room(const LensData& data, Marks marks, bool is_across);

/// What is marked, on the page.
struct MarkedSheet {
  std::vector<Box> cuts{};    ///< what is cut out
  std::vector<Box> art{};     ///< the same with its bleed
  Box all_cut{}, all{};       ///< what holds all of them
  core::LensColumns lenses;   ///< in the page's columns
  std::int64_t end_lens = 0;  ///< of all that is cut out; it begins with lens 0
  std::string name{};
  bool is_across = false;
};

/// A part of the label; the heavier it is, the longer it stays where there is no room for all.
struct LabelFact {
  std::string text;
  int weight = 0;
};
struct Label {
  std::string text;
  double height = 0.0;  ///< of its letters
};
/// As many facts as have room in that width; the last two in smaller letters, if it takes these. Empty: not even one.
Label label_within(std::vector<LabelFact> facts, double width);

void put_marks(Page& page, const MarkedSheet& sheet, const LensData& data, Marks marks);

/// Lenses or rows of that pitch that cover a length.
std::int64_t whole_in(double length, double pitch);

}  // namespace lentray::print
