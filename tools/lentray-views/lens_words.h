// Lens data of a command line, said in lentray's words: a sheet by its name, lenses or strips an inch, thickness, radius,
// angle, the printer's resolution.
// Errors: parser::OptionError and camera::CameraError, worded for the user. Reads lens_sheets.ini. One thread.
#pragma once

#include <string_view>

#include "parser/options/option_values.h"
#include "parser/options/options.h"
#include "tools/lentray-views/sheet.h"

namespace lentray::views {

/// Does what the option of lentray does that has this name.
void take_lens_word(parser::RenderOptions& words, std::string_view name,
                    const parser::GivenOption& given);

/// What a command line says of its lenses, complete: the words have the data of the sheet that they name and what `sheet`
/// says, and `sheet` has what follows from the words. `has_size`: the lens sheet's size is said too.
void complete_lens(parser::RenderOptions& words, SheetOptions& sheet, bool has_size);

/// Whether the words say how wide lenses are.
bool says_pitch(const parser::RenderOptions& words);

}  // namespace lentray::views
