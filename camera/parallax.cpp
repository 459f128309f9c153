#include "camera/parallax.h"

#include <algorithm>
#include <cmath>

#include "core/base/bounds.h"

namespace lentray::camera {
double parallax(const Lenticular& sheet, double depth) {
  const LensParameters& lens = sheet.sheet().lens();
  const double step =
      lens.ior * lens.pixel_size() / lens.focal_length * lens.depth_factor;  // slope a view
  if (std::isinf(depth)) return step * lens.view_distance / lens.pitch;
  const double behind = depth / sheet.scale();  // mm
  return step * behind / (1.0 + behind / lens.view_distance) / lens.pitch;
}

std::vector<double> column_bends(const LensSheet& sheet) {
  const LensParameters& lens = sheet.lens();
  std::vector<double> out(sheet.width(), lens.ior / lens.focal_length);
  if (lens.model == LensModel::kParaxial) return out;
  for (std::uint32_t k = 1; k < sheet.width(); ++k) {
    const LensColumn &a = sheet.column(k - 1), &b = sheet.column(k);
    const double step = b.lens_offset - a.lens_offset;
    if (a.lens != b.lens || a.dark || b.dark || !(step > 0.0)) continue;
    const double bend = (b.slope - a.slope) / step;
    out[k - 1] = std::max(out[k - 1], bend);
    out[k] = std::max(out[k], bend);
  }
  return out;
}

// A step of e in a cell moves what a lens shows of the depth z by z bend e. Another lens shows the point
// then, whose own direction differs: by x f/(nV) of the print.
double parallax_at_bend(const Lenticular& sheet, double depth, double bend) {
  const LensParameters& lens = sheet.sheet().lens();
  const double step = lens.pixel_size() * lens.depth_factor * bend / lens.pitch;
  const double turn = bend * lens.focal_length / (lens.ior * lens.view_distance);  // 0: V infinite
  const double behind = depth / sheet.scale();                                     // mm
  const double under = 1.0 + behind * turn;
  return under > 0.0 ? step * behind / under : -core::Bounds::kInf;
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
