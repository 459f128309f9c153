#include "camera/slanted_sheet.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace lentray::camera {
namespace {

/// The part of a lens by which a pixel's centre may miss a boundary and still lie on it. Heights are
/// quotients, which rounding would otherwise put on either side.
constexpr double kOnBoundary = 1e-9;

std::optional<double> whole_text_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() ||
      !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

}  // namespace

SlantedSheet::SlantedSheet(const LensParameters& lens, const SlantedPrint& print)
    : m_lens(lens), m_print(print), m_cosine(lens.slant_cosine()),
      m_lenses(print.width / lens.pixels),
      m_growth(lens.focal_length / (lens.ior * lens.view_distance)),
      m_columns_a_mm(lens.slant * m_cosine * lens.pixels / lens.pitch) {
  const double across = print.eye_slope_x * m_cosine - print.eye_slope_y * sine();
  m_shift = lens.is_finite() ? across * lens.focal_length / lens.ior
                             : offset_seen(print.eye_slope_x, print.eye_slope_y);
}

std::int64_t SlantedSheet::lens_of(std::int64_t column, std::int32_t row) const {
  const double at = (static_cast<double>(column) + 0.5 - shift(row + 0.5)) / m_lens.pixels;
  return static_cast<std::int64_t>(std::floor(at + kOnBoundary));
}

SlantedPlace SlantedSheet::place(double column, double row, std::int64_t lens,
                                 double across) const {
  const auto own = static_cast<double>(lens);
  SlantedPlace out;
  out.axis = axis_of(own + across);
  // e in cells: the difference of two lengths would lose digits on a wide sheet.
  out.cell_offset = ((column - shift(row)) / m_lens.pixels - own - 0.5) * m_lens.print_pitch();
  out.lens_offset = out.cell_offset * m_lens.depth_factor + offset_of_cell(out.axis);
  return out;
}

double SlantedSheet::column_at(double cell_offset, double lens, double row) const {
  return (lens + 0.5 + cell_offset / m_lens.print_pitch()) * m_lens.pixels + shift(row);
}

std::int64_t SlantedSheet::nearest_lens(std::int64_t place, std::int32_t row) const {
  const double at = static_cast<double>(place) - shift(row + 0.5) / m_lens.pixels;
  return static_cast<std::int64_t>(std::floor(at + 0.5 + kOnBoundary));
}

std::int64_t SlantedSheet::nearest_place(std::int64_t lens, std::int32_t row) const {
  const double at = static_cast<double>(lens) + shift(row + 0.5) / m_lens.pixels;
  return static_cast<std::int64_t>(std::floor(at + 0.5 + kOnBoundary));
}

double SlantedSheet::part_of_cell(std::int64_t column, std::int32_t row) const {
  const double at = (static_cast<double>(column) + 0.5 - shift(row + 0.5)) / m_lens.pixels;
  return std::max(0.0, at - static_cast<double>(lens_of(column, row)));
}

std::int64_t SlantedSheet::view_of(std::int64_t column, std::int32_t row) const {
  const double at = part_of_cell(column, row) + kOnBoundary;
  return static_cast<std::int64_t>(std::floor(at * m_lens.pixels));
}

std::uint32_t SlantedSheet::view_column(std::uint32_t view, std::uint32_t views, std::int64_t place,
                                        std::int32_t row) const {
  const double moved = shift(row + 0.5);
  std::int64_t lens = nearest_lens(place, row);
  std::int64_t column = 0;
  constexpr int kTries = 3;
  for (int i = 0; i < kTries; ++i) {
    const double at =
        m_lens.pixels * (static_cast<double>(lens) + (view + 0.5) / views + kOnBoundary) + moved;
    column = static_cast<std::int64_t>(std::floor(at));
    const std::int64_t owner = lens_of(column, row);
    if (owner != lens) column += owner < lens ? 1 : -1;
    if (column >= 0 && column < m_print.width) return static_cast<std::uint32_t>(column);
    lens += column < 0 ? 1 : -1;
  }
  // No lens has all of its pixels in this row.
  return static_cast<std::uint32_t>(
      std::clamp<std::int64_t>(column, 0, std::int64_t{m_print.width} - 1));
}

bool SlantedSheet::slope_across(double lens_offset, const SlopeAlong& along, double& slope) const {
  const double q = lens_offset / m_lens.focal_length;  // tan t_in across the lens
  if (m_lens.model == LensModel::kParaxial) {
    slope = m_lens.ior * q;
    return true;
  }
  // Snell's law keeps the parts of n times the unit direction along the sheet. With M the slope along
  // the lens, T^2 = q^2 (n^2 + (n^2 - 1)(T^2 + M^2)), M = at_zero + lean T: a quadratic equation for
  // T, whose root on the side of q holds.
  const double n2 = m_lens.ior * m_lens.ior, k = n2 - 1.0;
  const double c = n2 + k * along.at_zero * along.at_zero;
  const double b = k * along.at_zero * along.lean;
  const double a = 1.0 - q * q * k * (1.0 + along.lean * along.lean);
  const double under = q * q * b * b + a * c;
  const double root = under >= 0.0 ? std::sqrt(under) - q * b : 0.0;
  if (!(root > 0.0)) {
    slope = 0.0;
    return false;
  }
  slope = q * c / root;
  return true;
}

double SlantedSheet::offset_seen(double slope_x, double slope_y) const {
  const double across = slope_x * m_cosine - slope_y * sine();
  if (m_lens.model == LensModel::kParaxial) return across * m_lens.focal_length / m_lens.ior;
  const double n2 = m_lens.ior * m_lens.ior;
  return m_lens.focal_length * across /
         std::sqrt(n2 + (n2 - 1.0) * (slope_x * slope_x + slope_y * slope_y));
}

std::optional<double> tangent_of_slant(std::string_view text) {
  constexpr double kSteepest = 80.0 * std::numbers::pi / 180.0;
  const std::size_t bar = text.find('/');
  const auto first = whole_text_number(text.substr(0, bar));
  if (!first) return std::nullopt;
  double tangent = 0.0;
  if (bar == std::string_view::npos) {
    const double radians = *first * std::numbers::pi / 180.0;
    if (!(std::fabs(radians) <= kSteepest)) return std::nullopt;
    tangent = std::tan(radians);
  } else {
    const auto second = whole_text_number(text.substr(bar + 1));
    if (!second || *second == 0.0) return std::nullopt;
    tangent = *first / *second;
  }
  if (!(std::fabs(tangent) <= kSteepestSlant)) return std::nullopt;
  return tangent;
}

double slant_degrees(const LensParameters& lens) {
  return std::atan(lens.slant) * 180.0 / std::numbers::pi;
}

}  // namespace lentray::camera
