// The paper's figures, and charts of where its equations fail: which there are, their data, their
// gnuplot scripts. Charts appear whole or not at all; figures that cut or sweep leave their data
// beside the chart as CSV.
// Errors: core::ImageError where nothing can be written, std::runtime_error without gnuplot.
#pragma once

#include <string>
#include <vector>

#include "tools/lentray-model/grid.h"

namespace lentray::model {

/// 10 to 17, 23, 24a to 24e; near, theta, small, wide, edges.
const std::vector<std::string>& figure_names();
/// Figures 24a to 24e: the style that must be measured, or null.
const shadow::Style* measured_style(const std::string& figure);
/// Whether the figure shows the grid (or makes a grid of its own from the lens alone).
bool shows_grid(const std::string& figure);

/// Throws, before work is lost, if the figures asked for cannot be drawn.
void check_figures(const Arguments& arguments);
/// The chart's file.
std::string draw_figure(const std::string& figure, const Arguments& arguments,
                        const shadow::PaperSheet& sheet, const Grid& grid);

}  // namespace lentray::model
