// A lens of a sheet as a piece of glass with a round surface: where the light of a place in the print
// leaves the sheet, and in which direction, for each point of the lens's aperture.
//
// The surface is a circle's arc of radius R = f (n - 1)/n, which focuses on the print: at `a` from the
// axis it lies R - sqrt(R^2 - a^2) behind the vertex. The aperture is as wide as the pitch. In the
// glass the ray is straight, and it refracts at the surface. A ray that runs into the bulge of the
// next lens goes through it; the sheet is periodic and has no end.
//
// A ray that rises along the lenses, by `rise` for each mm of depth, is skew. Refraction keeps n times
// the unit direction's part along the lenses, so the cross-section sees a flat ray in a lens of index
// sqrt((n^2 - q^2)/(1 - q^2)), where q is that part in the air. Where eyes lie on a line that is not
// perpendicular to the lenses, a ray's rise grows with its slope across them (SlopeAlong).
//
// Units: mm; slopes are tangents against the sheet's normal. Positive offsets look towards +right.
// Immutable, any number of threads. Source: Snell's law in vector form; docs/lens/formulae.md;
// tests/unit/camera/camera_thick_lens_test holds the rays, tests/image/thick_lens_test the pictures.
#pragma once

#include <cstdint>

#include "camera/lens_sheet.h"

namespace lentray::camera {

/// Where a ray leaves the sheet, as the eye sees it.
struct SheetExit {
  double across = 0.0;  ///< from the axis of the ray's own lens, mm
  double depth = 0.0;   ///< behind the vertices, mm
  double slope = 0.0;   ///< tan t, towards +right into the display
};

enum class LensRayEnd {
  kLeaves,     ///< straight from its lens
  kSpills,     ///< runs into the bulge of the next lens, and leaves through that or a further one
  kReturns,    ///< runs into the bulge of the next lens and back to the print: it shows nothing
  kReflected,  ///< is totally reflected in its own lens: it shows nothing
  kHidden,     ///< the straight way from the print to the point leaves the glass: it shows nothing
};
/// The ray shows something.
inline bool shows(LensRayEnd end) {
  return end == LensRayEnd::kLeaves || end == LensRayEnd::kSpills;
}

class ThickLens {
 public:
  /// The parameters must be valid for LensModel::kThick (complaint() empty).
  explicit ThickLens(const LensParameters& lens);

  /// K, of a pixel: each goes through its own part of the aperture.
  std::uint32_t rays() const { return m_rays; }
  /// In mm from the axis, a place of the aperture: -0.5 to 0.5 from its middle.
  double at_part(double part) const { return part * m_pitch; }
  /// The middle of part j, from the left.
  double middle(std::uint32_t j) const { return at_part((j + 0.5) / m_rays - 0.5); }
  /// The ray of a lens offset (mm) through the aperture at `across` (mm from the axis) that rises as
  /// `along` says. `out` says nothing for a ray that shows nothing.
  LensRayEnd leave(double offset, double across, const SlopeAlong& along, SheetExit& out) const;
  /// None of the rays of a lens offset through the middles of the parts shows anything.
  bool is_dark(double offset, const SlopeAlong& along) const;

 private:
  /// A point of the surface. In the cross-section the normal into the glass is (-across, inwards),
  /// and the tangent towards +right is (inwards, across), both of length R.
  struct Point {
    double across, inwards, depth;
  };
  /// A flat ray in the air, just after the lens it left.
  struct AirRay {
    double x, z;    ///< from the middle of that lens's circle
    double dx, dz;  ///< where the light goes: dz < 0 is towards the eye. Unit
  };

  Point point_at(double across) const;
  /// The sine of the angle in the glass against the normal, times R; false if the straight way from the
  /// print to the point leaves the glass.
  bool incidence(const Point& point, double offset, double& sine) const;
  bool meets_next_lens(const AirRay& ray) const;
  /// The flat ray in a lens of that index, through as many lenses as it meets.
  LensRayEnd follow(const Point& point, double sine, double ior, SheetExit& out) const;
  void enter_next_lens(AirRay& ray, double side) const;
  bool pass_lens(AirRay& ray, double ior) const;
  LensRayEnd spill(const Point& point, double sine, const SlopeAlong& along, SheetExit& out) const;

  double m_pitch, m_focal_length, m_ior, m_radius;
  double m_edge;  ///< depth of the edge between two lenses
  std::uint32_t m_rays;
};

}  // namespace lentray::camera
