// Charts for tests of charts and pages.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tools/lentray-chart/front.h"

namespace lentray::chart {

inline Error sample_error(double rms) {
  Error error;
  error.rms = rms;
  error.psnr = rms > 0.0 ? 20.0 * std::log10(255.0 / rms) : std::numeric_limits<double>::infinity();
  error.share = std::min(1.0, rms / 20.0);
  error.largest = std::min(255.0, 30.0 * rms);
  return error;
}

inline Point sample_point(const std::string& id, Kind kind, double seconds, double rms) {
  Point p;
  p.setting.id = id;
  p.setting.label = id + " in words";
  p.setting.kind = kind;
  p.setting.options = {"+X" + id};
  p.state = State::done;
  p.cpu_s = {0.9 * seconds, seconds, 1.2 * seconds};
  p.error = sample_error(rms);
  return p;
}

inline Point plain_point(double seconds, double rms) {
  Point p = sample_point("plain", Kind::exact, seconds, rms);
  p.setting.label = "your options";
  p.setting.options.clear();
  p.setting.is_plain = true;
  return p;
}

inline Point exact_point(const std::string& id, double seconds, double rms) {
  Point p = sample_point(id, Kind::exact, seconds, rms);
  p.from_plain = sample_error(0.0);
  return p;
}

inline Chart sample_chart(std::vector<Point> points) {
  Chart chart;
  chart.scene = "scene.pov";
  chart.command = "lentray scene.pov";
  chart.width = 64;
  chart.height = 48;
  chart.reference.change = 0.01;
  chart.reference.is_converged = true;
  chart.reference.options = {"+A0.0", "+R9"};
  chart.reference.steps = {{"4 samples", 0.5}, {"16 samples", 0.01}};
  chart.points = std::move(points);
  derive(chart);
  return chart;
}

}  // namespace lentray::chart
