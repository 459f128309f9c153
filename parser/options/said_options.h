// Options as they were said, for messages about what came of them. Pure functions.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "parser/options/options.h"

namespace lentray::parser {

/// How many of the names were said.
std::size_t said_count(const RenderOptions& options, std::span<const std::string> names);

/// The message, and behind it in brackets those of the names that were said, each as it was said
/// last: "(Lens_Radius=0.1 in sheet.ini:3, Lens_Pitch=1)". Of a lens that was not said to its
/// end, the lens sheet's name too.
std::string with_said(const std::string& message, const RenderOptions& options,
                      const std::vector<std::string>& names);

}  // namespace lentray::parser
