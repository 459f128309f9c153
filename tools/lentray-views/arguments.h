// The command line of lentray-views. Errors: parser::OptionError, worded for the user. Pure.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parser/options/length.h"
#include "parser/options/options.h"
#include "tools/common/photo_reader.h"
#include "tools/lentray-views/join.h"
#include "tools/lentray-views/resize.h"
#include "tools/lentray-views/sheet.h"
#include "tools/lentray-views/strips.h"

namespace lentray::views {

enum class Task {
  kDescribe,
  kViews,
  kLens,
  kQuilt,
  kEye,
  kStereo,
  kAnaglyph,
  kWiggle,
  kPreview,
  kInterlace,
  kListSheets
};

struct Size {
  std::uint32_t width = 0, height = 0;
};

/// Both ends included.
struct Range {
  std::uint32_t first = 0, last = 0;
};

struct Arguments {
  Task task = Task::kDescribe;
  std::vector<std::filesystem::path> pictures;
  std::filesystem::path out;   ///< empty: beside nothing, in the current folder, named by the task
  std::optional<Range> range;  ///< of views; empty: all
  std::optional<std::uint32_t> count;  ///< views that are counted
  std::uint32_t lens = 0;
  std::uint32_t columns = 0, rows = 0;  ///< of a quilt
  std::optional<Eye> eye;
  bool between = false;       ///< colours between pixels of the print
  double eyes = 65.0;         ///< mm between two eyes
  std::optional<Range> pair;  ///< views of the left and the right eye
  bool one_zone = false;      ///< both eyes look into one zone
  Anaglyph anaglyph = Anaglyph::kDubois;
  int delay = 100;           ///< ms
  double page_limit = 20.0;  ///< MB of a preview
  bool from_left =
      false;  ///< pictures are from the leftmost camera to the rightmost, or from the highest down
  bool given_order = false;  ///< pictures stay in the order that they are given in
  tool::Profiles profiles = tool::Profiles::kSrgb;
  bool square = false;
  std::optional<Size> size;               ///< of each view, or of the integral image
  std::optional<parser::Extent> size_mm;  ///< of the lens sheet of an integral image that is made
  Filter filter = Filter::kLanczos3;
  std::filesystem::path like;  ///< an integral image
  /// Of --wiggle: the views begin again after the last one, or go to and fro; of --interlace: what the file says of it.
  std::optional<bool> is_loop;
  bool takes_any = false;  ///< --interlace: integral images too
  SheetOptions sheet;
  parser::RenderOptions lens_words;  ///< what else is said of the lenses, in lentray's words
};

Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

}  // namespace lentray::views
