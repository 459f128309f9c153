// What the options of the output file do, its type, bits and dithering: rows of
// parser/options/options_table.h.
// Errors: OptionError. Any number of threads, each with options of its own.
#pragma once

#include <string_view>

#include "parser/options/options_table.h"

namespace lentray::parser::output_option {

/// On or off, or with a sign a type as below.
void to_file(RenderOptions& o, const GivenOption& g);
/// A type, and behind it bits or, of some, g for grey: N16, Pg.
void type(RenderOptions& o, const GivenOption& g);
void bits(RenderOptions& o, const GivenOption& g);
/// +THxx turns it on, -THxx off; the method is kept either way.
void dither(RenderOptions& o, const GivenOption& g);
void dither_method(RenderOptions& o, const GivenOption& g);

void write_type(const RenderOptions& o, std::string_view name, IniLines& out);
void write_dither_method(const RenderOptions& o, std::string_view name, IniLines& out);

}  // namespace lentray::parser::output_option
