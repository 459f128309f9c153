// Reads the values of options about views, and settles them once all options are known.
// Errors: OptionError. Any number of threads, each with options of its own.
// Source of the displays' grids, sizes and aspects: docs/views.md, "Displays".
#pragma once

#include <utility>

#include "parser/options/option_values.h"
#include "parser/options/options.h"

namespace lentray::parser {

/// "420x560".
PixelSize size_of(const GivenOption& given);
/// "8x6", or the name of a display.
QuiltGrid quilt_of(const GivenOption& given);
/// "0..1".
std::pair<double, double> clocks_of(const GivenOption& given);

/// Refuses options about views that contradict each other. Gives a quilt's tiles their size: in
/// cone quilts width and height become the tile's, so that this is what a scene sees. Makes Views=
/// without View= and Quilt= a loop of pictures, and gives View= its clock.
void settle_views(RenderOptions& options);

}  // namespace lentray::parser
