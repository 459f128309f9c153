#include "camera/parallax.h"

#include <algorithm>
#include <cmath>

#include "core/base/bounds.h"

namespace lentray::camera {
namespace {

/// Pixels a view of a point `depth` behind the sheet, where directions change by `bend` a mm of the
/// print. A step of e in a cell moves what a lens shows of the depth z by z bend e, and the lens that
/// shows the point is another then, whose own direction differs: x f/(nV) of the print.
double parallax_where(const Lenticular& sheet, double depth, double bend) {
  const LensParameters& lens = sheet.sheet().lens();
  const double step = lens.pixel_size() * lens.depth_factor * bend / lens.pitch;
  // 1/V as the lens models have it; 0 when V is infinite.
  const double turn = bend * lens.focal_length / (lens.ior * lens.view_distance);
  if (std::isinf(depth)) return turn > 0.0 ? step / turn : core::Bounds::kInf;
  const double behind = depth / sheet.scale();  // mm
  const double under = 1.0 + behind * turn;
  return under > 0.0 ? step * behind / under : -core::Bounds::kInf;
}

/// The most that directions change a mm of the print, from a column of a lens to the next.
double steepest_bend(const LensSheet& sheet) {
  const LensParameters& lens = sheet.lens();
  double most = lens.ior / lens.focal_length;
  if (lens.model == LensModel::kParaxial) return most;
  for (std::uint32_t k = 1; k < sheet.width(); ++k) {
    const LensColumn &a = sheet.column(k - 1), &b = sheet.column(k);
    const double step = b.lens_offset - a.lens_offset;
    if (a.lens != b.lens || a.dark || b.dark || !(step > 0.0)) continue;
    most = std::max(most, (b.slope - a.slope) / step);
  }
  return most;
}

}  // namespace

double parallax(const Lenticular& sheet, double depth) {
  const LensParameters& lens = sheet.sheet().lens();
  const double step =
      lens.ior * lens.pixel_size() / lens.focal_length * lens.depth_factor;  // slope a view
  if (std::isinf(depth)) return step * lens.view_distance / lens.pitch;
  const double behind = depth / sheet.scale();  // mm
  return step * behind / (1.0 + behind / lens.view_distance) / lens.pitch;
}

double largest_parallax(const Lenticular& sheet, double depth) {
  return parallax_where(sheet, depth, steepest_bend(sheet.sheet()));
}

DepthInterval depths_within(const Lenticular& sheet, double pixels) {
  const LensParameters& lens = sheet.sheet().lens();
  const double step =
      lens.ior * lens.pixel_size() * lens.depth_factor / (lens.focal_length * lens.pitch);
  const double mm = pixels / step;  // of depth, with V infinite
  const double part = mm / lens.view_distance;
  const double infinite = core::Bounds::kInf;
  return {-mm / (1.0 + part) * sheet.scale(),
          part < 1.0 ? mm / (1.0 - part) * sheet.scale() : infinite};
}

}  // namespace lentray::camera
