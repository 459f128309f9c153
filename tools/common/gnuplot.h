// Charts by gnuplot. Shared by tools that chart.
// Errors: std::runtime_error without gnuplot or with what it says. Threads: any number.
#pragma once

#include <filesystem>
#include <string>

namespace lentray::tool {

/// Throws if gnuplot cannot be started.
void check_gnuplot();
/// What every script begins with: format "png" or "svg", size in pixels.
std::string gnuplot_preamble(const std::string& format, int width, int height);
/// The chart's bytes. The script begins with gnuplot_preamble() and reads `data` from 'data'.
std::string gnuplot(const std::string& script, const std::string& data);

}  // namespace lentray::tool
