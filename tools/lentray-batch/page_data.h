// What the page knows as JSON, pictures apart: the headline, the cards and the rows, with links to files. Keys are
// those of page.js, which reads them. Pure functions; threads: any number.
// Errors: none; text is cut and repaired here, so that it can be written as JSON.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/lentray-batch/page.h"
#include "tools/lentray-batch/page_cards.h"

namespace lentray::batch {

/// How much of a row's text there is room for.
struct TextLimits {
  std::size_t messages = 0;  ///< lines
  std::size_t line = 0;      ///< bytes of a line, a name or a reason
  std::size_t words = 0;     ///< of the command, and of other lists
  std::size_t files = 0;     ///< that the picture depends on
};
/// From all that is wanted to the least.
const std::vector<TextLimits>& text_limits();

/// `rows[i]` is the row with that index, of those that the cards name.
nlohmann::json page_data(const std::vector<Row>& rows, const std::vector<Card>& cards,
                         const PageOptions& options, const TextLimits& limits);

}  // namespace lentray::batch
