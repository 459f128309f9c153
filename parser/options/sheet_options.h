// What the options of lens sheets do: rows of parser/options/options_table.h.
// Errors: OptionError. Any number of threads, each with options of its own.
#pragma once

#include "parser/options/option_values.h"
#include "parser/options/options.h"

namespace lentray::parser::sheet_option {

void pitch(RenderOptions& o, const GivenOption& g);
void lpi(RenderOptions& o, const GivenOption& g);
void print_lpi(RenderOptions& o, const GivenOption& g);
void focal_length(RenderOptions& o, const GivenOption& g);
void thickness(RenderOptions& o, const GivenOption& g);
void radius(RenderOptions& o, const GivenOption& g);
void ior(RenderOptions& o, const GivenOption& g);
void angle(RenderOptions& o, const GivenOption& g);
/// A name, or `list`.
void sheet(RenderOptions& o, const GivenOption& g);
void pixels(RenderOptions& o, const GivenOption& g);
/// Degrees, or a tangent as a fraction.
void slant(RenderOptions& o, const GivenOption& g);
/// Pixels an inch along rows, and perhaps x and those downwards.
void print_dpi(RenderOptions& o, const GivenOption& g);
void width(RenderOptions& o, const GivenOption& g);
void height(RenderOptions& o, const GivenOption& g);
/// mm or inf.
void view_distance(RenderOptions& o, const GivenOption& g);
void sheet_distance(RenderOptions& o, const GivenOption& g);
/// Pixels of a view, or a length on the print with its unit.
void depth_budget(RenderOptions& o, const GivenOption& g);
void front(RenderOptions& o, const GivenOption& g);
void model(RenderOptions& o, const GivenOption& g);
void tolerance(RenderOptions& o, const GivenOption& g);
void rays(RenderOptions& o, const GivenOption& g);
void view(RenderOptions& o, const GivenOption& g);

}  // namespace lentray::parser::sheet_option
