#include "tools/lentray-model/sweeps.h"
#include "tools/common/csv.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lentray::model {

using tool::csv_field;
using tool::number_text;
namespace {

constexpr int kSteps = 600;

std::vector<double> even(double first, double last) {
  std::vector<double> out;
  for (int i = 0; i <= kSteps; ++i) out.push_back(first + (last - first) * i / kSteps);
  return out;
}

std::vector<double> by_factors(double first, double last) {
  std::vector<double> out;
  for (int i = 0; i <= kSteps; ++i) {
    out.push_back(first * std::pow(last / first, static_cast<double>(i) / kSteps));
  }
  return out;
}

void add(Series& series, double x, const shadow::PaperSheet& sheet,
         const shadow::ShadowSquare& square) {
  const shadow::Enumeration enumeration(sheet, square);
  std::vector<Point> points;
  for (const shadow::Style& style : series.styles) {
    points.push_back(model_point(sheet, enumeration, square, style));
  }
  series.x.push_back(x);
  series.points.push_back(std::move(points));
}

/// Pitches up to what refracts no ray but the middle ones, on sheets of the same width.
void sweep_widths(Series& series, const Arguments& a, const shadow::PaperSheet& sheet) {
  const double widest = a.lens.ior > 1.0 ? 2.0 / std::sqrt(a.lens.ior * a.lens.ior - 1.0) : 3.0;
  for (const double ratio : even(0.05, 1.25 * widest)) {
    camera::LensParameters lens = a.lens;
    lens.pitch = ratio * lens.focal_length;
    const double lenses = std::round(sheet.columns().sheet_width() / lens.pitch);
    const shadow::PaperSheet other(lens, static_cast<std::uint32_t>(std::max(1.0, lenses)));
    add(series, ratio, other, a.shadow(a.slice_a, a.slice_d));
  }
}

}  // namespace

Series cut_along_a(const Arguments& a, const shadow::PaperSheet& sheet,
                   const shadow::Style& style) {
  Series series{"A, mm", false, false, {style}, {}, {}};
  for (const double size : even(a.a.first, a.a.last)) {
    add(series, size, sheet, a.shadow(size, a.slice_d));
  }
  return series;
}

Series cut_along_d(const Arguments& a, const shadow::PaperSheet& sheet,
                   const shadow::Style& style) {
  Series series{"D, mm", false, false, {style}, {}, {}};
  for (const double distance : even(a.d.first, a.d.last)) {
    add(series, distance, sheet, a.shadow(a.slice_a, distance));
  }
  return series;
}

Series sweep(const std::string& name, const Arguments& a, const shadow::PaperSheet& sheet) {
  Series series{"", true, false, shadow::paper_styles(), {}, {}};
  const double alpha = shadow::paper::fan_angle(a.lens, a.alpha);
  if (name == "near") {
    series.axis = "D, mm";
    for (const double d : by_factors(1e-3, 40.0)) add(series, d, sheet, a.shadow(a.slice_a, d));
  } else if (name == "theta") {
    series.axis = "theta / alpha";
    for (const double part : by_factors(0.1, std::min(4.0, 1.5 / alpha))) {
      add(series, part, sheet, a.shadow(a.slice_a, a.slice_a / std::tan(part * alpha)));
    }
  } else if (name == "small") {
    series.axis = "A, mm";
    for (const double size : by_factors(0.1 * sheet.pixel(), 4.0 * a.lens.pitch)) {
      add(series, size, sheet, a.shadow(size, a.slice_d));
    }
  } else if (name == "wide") {
    series.axis = "P / f";
    series.logarithmic = false;
    series.logarithmic_hits = true;
    sweep_widths(series, a, sheet);
  } else if (name == "edges") {
    series.axis = "Xstart, mm";
    series.logarithmic = false;
    const double half = 0.5 * sheet.columns().sheet_width();
    for (const double x : even(-half - a.slice_a, half)) {
      add(series, x, sheet, {a.slice_a, a.slice_d, x, a.start_down()});
    }
  } else {
    throw std::logic_error("no sweep '" + name + "'");
  }
  return series;
}

std::string csv_of(const Series& series) {
  std::string out = csv_field(series.axis);
  for (const shadow::Style& style : series.styles) {
    for (const char* what : {"printed", "refracted", "enumerated"}) {
      out += "," + csv_field(style.name() + " " + what);
    }
  }
  out += "\n";
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    out += number_text(series.x[i]);
    for (const Point& p : series.points[i]) {
      out += "," + (p.printed ? std::to_string(*p.printed) : "") + "," +
             (p.refracted ? std::to_string(*p.refracted) : "") + "," + std::to_string(p.enumerated);
    }
    out += "\n";
  }
  return out;
}

}  // namespace lentray::model
