// The command line of lentray-diff --seen. Errors: parser::OptionError. Pure.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parser/options/options.h"

namespace lentray::diff {

struct SeenArguments {
  std::vector<std::filesystem::path> pictures;  ///< two
  std::filesystem::path json;                   ///< empty: none
  std::filesystem::path out;                    ///< folder of pictures; empty: none
  double arc_minutes = 1.0;
  bool across = false;  ///< lenses lie across the upright pictures
  /// Lens_Pixels, Print_DPI and View_Distance, as far as they are given: they go before what files
  /// say.
  parser::RenderOptions lens_words{};

  /// Of --dpi.
  std::optional<double> rows_an_inch() const;
};

/// Of words of which one is --seen.
SeenArguments parse_seen_arguments(const std::vector<std::string>& words);

}  // namespace lentray::diff
