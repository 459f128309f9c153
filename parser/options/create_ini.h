// The options of a run as an INI file that asks for them again (Create_Ini, +GI).
// Source: reference manual 3.7, "Resuming Options". Pure functions.
#pragma once

#include <string>

#include "parser/options/options.h"

namespace lentray::parser {

/// Every option with its value, also where that is the usual one; a line each, LF. What only this
/// program's own modes ask for (--dump) is left out. Throws OptionError where a value cannot stand in an INI file.
std::string ini_text(const RenderOptions& options);

/// Those lines that decide what colours the pixels get, the frame's clock apart.
std::string picture_lines(const RenderOptions& options);

/// Those of them that decide what light there is, wherever it is seen from.
std::string light_lines(const RenderOptions& options);

/// Those that decide how a picture's file holds them, its name apart.
std::string file_lines(const RenderOptions& options);

/// Where Create_Ini writes: "" for nowhere, and the scene's name with .ini where it was only turned on.
std::string ini_path(const RenderOptions& options);

}  // namespace lentray::parser
