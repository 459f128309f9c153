// Options as they were said, for messages about what came of them. Pure functions.
#pragma once

#include <span>
#include <string>

#include "parser/options/options.h"

namespace lentray::parser {

/// "Lens_Radius=0.1 in sheet.ini:3, Lens_Pitch=1": those of the names that were said, each as it was said last, with
/// the lens sheet by name where one of them is a lens's. Empty: none was.
struct SaidText {
  std::string text;
  std::size_t count = 0;  ///< of the names
};
SaidText said_text(const RenderOptions& options, std::span<const std::string> names);

/// The same behind a message, in brackets.
std::string with_said(const std::string& message, const SaidText& said);

}  // namespace lentray::parser
