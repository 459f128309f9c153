// The command line of lentray-diff: its own options, and lentray's, which go to lentray as they
// are and to stock as far as they change what is seen there (Declare=, +L, +Q, +MV, +K, +UA,
// File_Gamma=, frames and clocks, also from INI files).
// Errors: parser::OptionError. Pure but for reading INI files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/image/compare.h"
#include "parser/options/options.h"
#include "tools/lentray-diff/seen_arguments.h"
#include "tools/lentray-diff/stock.h"

namespace lentray::diff {

/// Whether stock renders again in other orders, so that its noise is known: where the scene has light that depends on
/// them, always, never.
enum class AskNoise { where_it_is, always, never };

struct Arguments {
  std::optional<SeenArguments> seen;            ///< --seen: nothing else counts then
  std::filesystem::path scene;                  ///< empty when two pictures are compared
  std::vector<std::filesystem::path> pictures;  ///< none or two
  core::Grade asked = core::Grade::match;
  AskNoise noise = AskNoise::where_it_is;
  std::filesystem::path prefix;  ///< of the pictures that are written
  std::filesystem::path json;
  std::filesystem::path wrappers;  ///< only write wrapper scenes into that folder
  bool write_pictures = true, all_lenses = false;
  std::filesystem::path lentray;  ///< the program; empty: beside lentray-diff
  std::vector<std::string> for_lentray;
  parser::RenderOptions options;  ///< what they mean
  bool stock_alone = false;       ///< stock's picture, with nothing to compare it with
  std::filesystem::path ours,
      statistics;      ///< of lentray's run of the scene, which is then not repeated
  StockOptions stock;  ///< processes: also lentray's threads
};

Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

}  // namespace lentray::diff
