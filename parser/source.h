// Source texts and places in them. A SourceManager owns every file read in a run.
// Lines and columns count from 1; columns in bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lentray::parser {

/// A place in a source: small, copied freely. file 0 is "nowhere" (built in, command line).
struct Location {
  std::uint32_t file = 0;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

}  // namespace lentray::parser
