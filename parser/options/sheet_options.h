// What the options of lens sheets do: rows of parser/options/options_table.h.
// Errors: OptionError. Any number of threads, each with options of its own.
#pragma once

#include <string_view>

#include "parser/options/options_table.h"

namespace lentray::parser::sheet_option {

/// A name, or `list`.
void sheet(RenderOptions& o, const GivenOption& g);
/// Degrees, or a tangent as a fraction.
void slant(RenderOptions& o, const GivenOption& g);
/// up or across.
void direction(RenderOptions& o, const GivenOption& g);
/// The name of a paper, or WxH: width and height at once.
void sheet_size(RenderOptions& o, const GivenOption& g);
/// Pixels an inch along rows, and perhaps x and those downwards.
void print_dpi(RenderOptions& o, const GivenOption& g);
/// mm or inf.
void view_distance(RenderOptions& o, const GivenOption& g);
void sheet_distance(RenderOptions& o, const GivenOption& g);
/// print, scene or viewer.
void depth(RenderOptions& o, const GivenOption& g);
/// The name of an object, or its place.
void sheet_at(RenderOptions& o, const GivenOption& g);
/// Pixels of a view, or a length on the print with its unit.
void depth_budget(RenderOptions& o, const GivenOption& g);
void front(RenderOptions& o, const GivenOption& g);
void model(RenderOptions& o, const GivenOption& g);

void write_direction(const RenderOptions& o, std::string_view name, IniLines& out);
void write_slant(const RenderOptions& o, std::string_view name, IniLines& out);
void write_print_dpi(const RenderOptions& o, std::string_view name, IniLines& out);
void write_depth_budget(const RenderOptions& o, std::string_view name, IniLines& out);
void write_depth(const RenderOptions& o, std::string_view name, IniLines& out);
void write_model(const RenderOptions& o, std::string_view name, IniLines& out);

}  // namespace lentray::parser::sheet_option
