#include "tools/lentray-views/lens_words.h"

#include <algorithm>
#include <string>

#include "camera/lens_request.h"
#include "parser/options/lens_sheets.h"
#include "parser/options/options_table.h"
#include "parser/options/said_options.h"

namespace lentray::views {

using camera::LensRequest;
using parser::RenderOptions;

namespace {

void take_sheet(const SheetOptions& sheet, LensRequest& lens) {
  lens.pixels = sheet.pixels;
  lens.slant = sheet.slant;
  lens.view_distance = sheet.view_distance;
  lens.model = sheet.model;
  if (sheet.pitch) lens.pitch = sheet.pitch;
  if (sheet.focal_length) lens.focal_length = sheet.focal_length;
  if (sheet.ior) lens.ior = sheet.ior;
}

/// Strips an inch of so many pixels a lens at a resolution along a row.
double strips_an_inch(const LensRequest& lens) {
  camera::LensParameters leaning;
  leaning.slant = lens.slant.value_or(0.0);
  return *lens.print_dpi / (*lens.pixels * leaning.slant_cosine());
}

}  // namespace

void take_lens_word(RenderOptions& words, std::string_view name, const parser::GivenOption& given) {
  std::ranges::find(parser::option_table(), name, &parser::OptionRow::name)
      ->access.apply(words, given);
  words.said[std::string(name)] = {given.shown, ""};
}

bool says_pitch(const RenderOptions& words) {
  const LensRequest& lens = words.lens;
  return lens.pitch || lens.lpi || lens.print_lpi || (lens.thickness && lens.angle);
}

void complete_lens(RenderOptions& words, SheetOptions& sheet, bool has_size) {
  LensRequest& lens = words.lens;
  const bool is_described = !words.lens_sheet.empty() || lens.lpi || lens.print_lpi ||
                            lens.thickness || lens.radius || lens.angle;
  take_sheet(sheet, lens);
  parser::apply_lens_sheet(words, parser::installed_lens_sheet_files());
  // As lentray has it of prints.
  if (!lens.view_distance && (has_size || lens.has_print_data())) {
    lens.view_distance = camera::kUsualViewDistance;
  }
  if (!says_pitch(words) && lens.print_dpi && lens.pixels) lens.print_lpi = strips_an_inch(lens);
  if (!says_pitch(words)) return;
  try {
    if (is_described) {
      const camera::SolvedLens solved = camera::solve(camera::with_lens_pitch(lens));
      sheet.pitch = solved.pitch;
      sheet.focal_length = solved.thickness;
      sheet.ior = solved.ior;
    }
    if (lens.print_dpi && !lens.pixels) sheet.pixels = camera::resolve(lens, 1, nullptr).pixels;
  } catch (const camera::CameraError& error) {
    throw parser::OptionError(parser::with_said(error.what(), words, error.about()));
  }
}

}  // namespace lentray::views
