#include "camera/parallax.h"

#include <algorithm>
#include <cmath>

#include "core/base/bounds.h"

namespace lentray::camera {

double ParallaxRule::at(double mm) const {
  if (std::isinf(mm)) return turn > 0.0 ? step / turn : step * mm;
  const double under = 1.0 + mm * turn;
  return under > 0.0 ? step * mm / under : -core::Bounds::kInf;
}

// A step of e in a cell moves what a lens shows of the depth z by z bend e. Another lens shows the point
// then, whose own direction differs: by x f/(nV) of the print, and x/D - m x/V for an eye of the scene's.
ParallaxRule parallax_rule(const Lenticular& sheet, double bend) {
  const LensParameters& lens = sheet.sheet().lens();
  if (const auto& eye = sheet.placement().eye) {
    return parallax_rule(lens, eye->distance / sheet.scale(), eye->factor, bend);
  }
  return {lens.pixel_size() * lens.depth_factor * bend / lens.pitch,
          bend * lens.focal_length / (lens.ior * lens.view_distance)};
}

ParallaxRule parallax_rule(const LensParameters& lens, double eye, double factor, double bend) {
  const double beyond =
      bend * lens.focal_length / lens.ior - 1.0;  // 0 under lenses seen straight on
  return {lens.pixel_size() * factor * bend / lens.pitch,
          1.0 / eye + factor * beyond / lens.view_distance};
}

double parallax(const Lenticular& sheet, double depth) {
  const LensParameters& lens = sheet.sheet().lens();
  return parallax_rule(sheet, lens.ior / lens.focal_length).at(depth / sheet.scale());
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

double most_bend(const LensSheet& sheet) { return std::ranges::max(column_bends(sheet)); }

DepthInterval depths_within(const Lenticular& sheet, double pixels) {
  const LensParameters& lens = sheet.sheet().lens();
  const ParallaxRule rule = parallax_rule(sheet, lens.ior / lens.focal_length);
  const double mm = pixels / rule.step;  // of depth, with an infinitely far eye
  const double part = mm * rule.turn;
  const double infinite = core::Bounds::kInf;
  return {-mm / (1.0 + part) * sheet.scale(),
          part < 1.0 ? mm / (1.0 - part) * sheet.scale() : infinite};
}

}  // namespace lentray::camera
