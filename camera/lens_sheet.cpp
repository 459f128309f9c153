#include "camera/lens_sheet.h"

#include <algorithm>
#include <cmath>

#include "camera/text.h"

namespace lentray::camera {

const char* name_of(LensModel model) {
  switch (model) {
    case LensModel::kParaxial: return "paraxial";
    case LensModel::kPinhole: return "pinhole";
    case LensModel::kThick: break;
  }
  return "thick";
}

std::optional<LensModel> model_named(std::string_view name) {
  for (const auto model : {LensModel::kParaxial, LensModel::kPinhole, LensModel::kThick}) {
    if (name == name_of(model)) return model;
  }
  return std::nullopt;
}

double LensParameters::print_pitch() const {
  // f/(nV) is 0 for an infinite V.
  return pitch * (1.0 + focal_length / (ior * view_distance));
}

namespace {

std::string complaint_of_thick(const LensParameters& lens) {
  if (lens.rays < 1 || lens.rays > kMostLensRays) {
    return "the rays of a lens must be 1 to " + std::to_string(kMostLensRays);
  }
  if (0.5 * lens.pitch <= lens.radius()) return {};
  return "there is no such lens: its surface would have a radius of " + format(lens.radius()) +
         " mm, f (n - 1)/n, so it can be " + format(2.0 * lens.radius()) +
         " mm wide at most, not " + format(lens.pitch) + " mm";
}

}  // namespace

std::string complaint(const LensParameters& lens) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!positive(lens.pitch)) return "the lens pitch must be greater than 0 mm";
  if (!positive(lens.focal_length)) return "the lens focal length must be greater than 0 mm";
  if (!(std::isfinite(lens.ior) && lens.ior >= 1.0)) {
    return "the refractive index of the lens must be at least 1";
  }
  if (!(std::isfinite(lens.pixels) && lens.pixels >= 1.0)) {
    return "a lens must be at least one pixel wide";
  }
  if (!(lens.view_distance > 0.0)) return "the viewing distance must be greater than 0 mm";
  // Beyond what anybody makes, so that what follows can be computed.
  constexpr double kLeast = 1e-6, kMost = 1e6, kMostIor = 100.0, kFarthestEye = 1e12;
  const auto beyond = [](double value) { return value < kLeast || value > kMost; };
  if (beyond(lens.pitch)) return "the lens pitch must be 1e-6 to 1e6 mm";
  if (beyond(lens.focal_length)) return "the lens focal length must be 1e-6 to 1e6 mm";
  if (lens.ior > kMostIor) return "the refractive index of the lens must be 100 at most";
  if (lens.pixels > kMost) return "a lens must be a million pixels wide at most";
  const bool finite = std::isfinite(lens.view_distance);
  if (finite && (lens.view_distance < kLeast || lens.view_distance > kFarthestEye)) {
    return "the viewing distance must be 1e-6 to 1e12 mm";
  }
  if (!(std::fabs(lens.slant) <= kSteepestSlant)) {
    return "the slant of the lenses must be -80 to 80 degrees";
  }
  return lens.model == LensModel::kThick ? complaint_of_thick(lens) : std::string();
}

double pixels_for_dpi(const LensParameters& lens, double dpi) {
  return lens.print_pitch() * dpi / 25.4 / lens.slant_cosine();
}

bool slope_of(const LensParameters& lens, double lens_offset, double& slope) {
  const double inside = lens_offset / lens.focal_length;  // tan t_in
  if (lens.model == LensModel::kParaxial) {
    slope = lens.ior * inside;
    return true;
  }
  // With s = sin t_in = q/sqrt(1+q^2): tan t = n s / sqrt(1 - n^2 s^2)
  //                                          = n q / sqrt(1 + q^2 (1 - n^2)).
  const double under = 1.0 + inside * inside * (1.0 - lens.ior * lens.ior);
  if (!(under > 0.0)) {
    slope = 0.0;
    return false;
  }
  slope = lens.ior * inside / std::sqrt(under);
  return true;
}

double offset_of(const LensParameters& lens, double slope) {
  if (lens.model == LensModel::kParaxial) return slope * lens.focal_length / lens.ior;
  const double n2 = lens.ior * lens.ior;
  return lens.focal_length * slope / std::sqrt(n2 + slope * slope * (n2 - 1.0));
}

LensSheet::LensSheet(const LensParameters& lens, std::uint32_t width, double eye_slope)
    : m_lens(lens), m_eye_slope(eye_slope),
      m_shift(lens.is_finite() ? eye_slope * lens.focal_length / lens.ior
                               : offset_of(lens, eye_slope)),
      m_lenses(width / lens.pixels) {
  m_columns.reserve(width);
  for (std::uint32_t k = 0; k < width; ++k) {
    // Not through lengths: rounding there would move whole pixels at fractional N.
    m_columns.push_back(place(k + 0.5, lens_of(k)));
    if (m_columns.back().dark) ++m_dark;
  }
}

LensColumn LensSheet::place(double column, std::int64_t lens) const {
  // e first, in cells: the difference of two lengths would lose digits on a wide sheet.
  return at(column / m_lens.pixels - static_cast<double>(lens) - 0.5, static_cast<double>(lens));
}

std::int64_t LensSheet::lens_of(std::int64_t k) const { return columns().lens_of(k); }

LensColumn LensSheet::beside(std::int64_t k, double across, double turn) const {
  const auto lens = static_cast<double>(lens_of(k));
  const double column = static_cast<double>(k) + 0.5 + turn;
  return at(column / m_lens.pixels - lens - 0.5, lens + across);
}

std::int64_t LensSheet::left_of(std::int64_t k) const {
  const std::int64_t lens = lens_of(k) - 1;
  // The nearest whole number to k - N is at most half a pixel off and so at most one column beyond
  // the lens's own.
  std::int64_t column = std::llround(static_cast<double>(k) - m_lens.pixels);
  if (lens_of(column) < lens) ++column;
  if (lens_of(column) > lens) --column;
  return column;
}

LensColumn LensSheet::at(double cells, double lens) const {
  const double print_pitch = m_lens.print_pitch();
  LensColumn c;
  c.lens = lens;
  c.axis = (lens + 0.5 - m_lenses / 2.0) * m_lens.pitch;
  c.cell_centre =
      c.axis * (1.0 + m_lens.focal_length / (m_lens.ior * m_lens.view_distance)) + m_shift;
  c.cell_offset = cells * print_pitch;
  c.centre = c.cell_centre + c.cell_offset;
  c.lens_offset = c.cell_offset * m_lens.depth_factor + m_shift +
                  c.axis * m_lens.focal_length / (m_lens.ior * m_lens.view_distance);
  c.dark = !slope_of(m_lens, c.lens_offset, c.slope);
  return c;
}

std::uint32_t LensSheet::views() const {
  if (is_slanted()) return 0;
  return std::floor(m_lens.pixels) == m_lens.pixels ? static_cast<std::uint32_t>(m_lens.pixels) : 0;
}

double LensSheet::widest_pitch() const {
  if (m_lens.model == LensModel::kParaxial || m_lens.ior == 1.0) return LensParameters::kInfinity;
  const double limit = m_lens.focal_length / std::sqrt(m_lens.ior * m_lens.ior - 1.0);
  double widest = LensParameters::kInfinity;
  for (const LensColumn& c : m_columns) {
    // Offsets grow linearly with the pitch: o = a P + shift.
    const double a = (c.lens_offset - m_shift) / m_lens.pitch;
    if (a == 0.0) continue;
    widest =
        std::min(widest, std::max(0.0, (limit - (a > 0.0 ? m_shift : -m_shift)) / std::fabs(a)));
  }
  return widest;
}

double LensSheet::largest_eye_miss() const {
  if (!m_lens.is_finite() || m_lens.model == LensModel::kParaxial) return 0.0;
  double largest = 0.0;
  for (const LensColumn& c : m_columns) {
    double middle = 0.0;  // slope of the same view's ray through the sheet's middle
    if (c.dark || !slope_of(m_lens, c.cell_offset * m_lens.depth_factor + m_shift, middle))
      continue;
    const double wanted = offset_of(m_lens, middle + c.axis / m_lens.view_distance);
    largest = std::max(largest, std::fabs(c.lens_offset - wanted) / m_lens.pixel_size());
  }
  return largest;
}

double LensSheet::paraxial_error() const {
  LensParameters paraxial = m_lens, snell = m_lens;
  paraxial.model = LensModel::kParaxial;
  snell.model = LensModel::kPinhole;
  double largest = 0.0;
  for (const LensColumn& c : m_columns) {
    double slope = 0.0;
    slope_of(paraxial, c.lens_offset, slope);
    largest = std::max(largest, std::fabs(offset_of(snell, slope) - c.lens_offset));
  }
  return largest / m_lens.pixel_size();
}

LensModel LensSheet::cheapest_model(double within_pixels) const {
  return paraxial_error() <= within_pixels ? LensModel::kParaxial : LensModel::kPinhole;
}

}  // namespace lentray::camera
