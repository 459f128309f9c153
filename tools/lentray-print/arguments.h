// The command line of lentray-print: a command, its options (`--name value` or `--name=value`), and the pictures
// of `sheet`. Lengths carry their unit and are kept in mm. Errors: parser::OptionError, worded for the user. Pure.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parser/options/length.h"
#include "tools/common/photo_reader.h"
#include "tools/lentray-print/layout.h"
#include "tools/lentray-print/lens_data.h"
#include "tools/lentray-print/sheet.h"

namespace lentray::print {

enum class Command { pitch_test, phase_test, eye_test, sheet };

struct Arguments {
  Command command = Command::sheet;
  std::vector<std::filesystem::path> images;  ///< of `sheet`
  std::filesystem::path out;

  // Of all commands.
  GivenLensData lens;                             ///< --lpi, --lens-pitch, --pixels, --dpi, --dpi-y
  bool dpi_says_both = false, has_dpi_y = false;  ///< how lens.dpi_y was given
  bool mirror = false, horizontal = false, across = false;

  // Of test pages.
  std::optional<parser::Extent> size;
  std::optional<double> span, step;  ///< lines an inch
  std::optional<int> bands;
  bool fine = false, hard_edges = false;
  int phases = 8;
  double distance = 500.0, separation = 65.0;
  double focal_length = 0.0, ior = 1.56;

  // Of sheets.
  SheetStyle style;
  std::optional<double> margin;  ///< without it, the style's
  bool tiles = false;
  double overlap = 10.0;
  std::optional<double> print_pitch;      ///< --pitch, mm
  int bits = 0;                           ///< 8 or 16; 0: the picture's
  int copies = 1;                         ///< of each picture
  std::optional<LayoutGrid> grid;         ///< the places; none: as few rows and columns as it takes
  std::optional<LayoutGrid> copies_grid;  ///< of --copies 3x4: places that pictures fill in turn
  tool::Profiles profiles = tool::Profiles::kSrgb;
};

Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

}  // namespace lentray::print
