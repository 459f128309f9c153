// Sizes of paper by their names. Units: mm. Source: ISO 216, ANSI/ASME Y14.1. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parser/options/length.h"

namespace lentray::print {

/// Upright. Letter case is ignored.
std::optional<parser::Extent> paper_named(std::string_view name);
/// For messages.
std::string paper_names();

}  // namespace lentray::print
