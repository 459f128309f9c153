// The lenticular camera with lenses of glass: each pixel is the mean of K rays, one through each of K
// parts of its lens's aperture (camera/thick_lens.h), at a height of its own in the pixel's row.
// Those of pixels that an eye blends lie at different places (core/render/eye_place.h).
// World space, unit directions.
//
// A ray that leaves its lens `across` from the axis and `depth` behind the vertices has the line
// through C + (x_i + across) s r + depth s d + Y u along v = tan t r + d + (Y/V + eye_slope_y) u: the
// row's height Y is that where the light leaves the sheet. The line starts lens_front before the
// sheet. A ray that shows nothing is black and counts as the others do.
// Reports and dark pixels are of rays through the middles of the parts. ray(), ray_at() and sight()
// have the ray through the lens's vertex, which is also that of K = 1.
// Source: docs/lens/formulae.md.
#pragma once

#include "camera/lenticular.h"
#include "camera/thick_lens.h"

namespace lentray::camera {

/// Of the rays of the sheet's middle row.
struct RayShares {
  double spilled = 0.0;  ///< run into the bulge of the next lens
  double dark = 0.0;     ///< show nothing

  /// All rays of a lens offset.
  void add(const ThickLens& lens, double offset, const SlopeAlong& along);
  /// The same as parts of so many rays.
  RayShares of(double rays) const { return {spilled / rays, dark / rays}; }
  /// The report's line of them.
  std::string line(std::uint32_t rays) const;
  void describe(std::uint32_t rays, Properties& out) const;
};
class ThickLenticular final : public Lenticular {
 public:
  ThickLenticular(const LensParameters& lens, const SheetPlacement& placement, std::uint32_t width,
                  std::uint32_t height);
  bool ray(double column, double row, core::Ray& ray) const override;
  bool ray_at(const core::PixelPlace& place, core::Ray& out) const override;
  bool sight(const core::PixelPlace& place, core::Ray& out) const override {
    return sight_of_ray(place, out);
  }
  std::uint32_t rays_a_place() const override { return m_lens.rays(); }
  bool one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                  core::Ray& out) const override;
  bool missing_rays_are_black() const override { return true; }
  Properties describe() const override;

  /// Pixels none of whose parts shows anything at its middle.
  std::uint64_t dark_pixels() const override { return m_dark_pixels; }
  const RayShares& shares() const { return m_shares; }
  std::vector<std::string> model_report() const override;

 protected:
  std::string dark_warning() const override;

 private:
  LensColumn column_at(const core::PixelPlace& place) const;
  void place_ray(const LensColumn& column, const SheetExit& exit, double row, core::Ray& out) const;
  bool through_vertex(const LensColumn& column, double row, core::Ray& out) const;
  RayShares count_shares() const;
  std::uint64_t count_dark_pixels() const;
  /// Some ray of the column shows something in every row.
  bool is_never_dark(const LensColumn& column) const;
  ThickLens m_lens;
  RayShares m_shares;
  std::uint64_t m_dark_pixels = 0;
};

}  // namespace lentray::camera
