// The lenticular camera whose lenses are slanted: all lens models. World space, unit directions.
//
// A pixel's light leaves the sheet at x = u/cos a + Y tan a, Y: u is its lens's axis (for the thick
// model, where its ray leaves the lens), Y the row's height. It goes along
// (T/cos a + m_y tan a) r + d + m_y u, m_y = Y/V + eye_slope_y, T by the model (camera/slanted_sheet.h).
// A pixel's area is its lens's width by the row's height, along the lens.
// Source: docs/lens/formulae.md, "Slanted sheets".
#pragma once

#include <optional>

#include "camera/lenticular.h"
#include "camera/slanted_sheet.h"
#include "camera/thick_lens.h"
#include "camera/thick_lenticular.h"

namespace lentray::camera {

class SlantedLenticular final : public Lenticular {
 public:
  SlantedLenticular(const LensParameters& lens, const SheetPlacement& placement,
                    std::uint32_t width, std::uint32_t height);
  bool ray(double column, double row, core::Ray& ray) const override;
  bool ray_at(const core::PixelPlace& place, core::Ray& out) const override;
  bool sight(const core::PixelPlace& place, core::Ray& out) const override {
    return sight_of_ray(place, out);
  }
  std::uint32_t rays_a_place() const override { return m_lens ? m_lens->rays() : 1; }
  bool one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                  core::Ray& out) const override;
  bool missing_rays_are_black() const override { return m_lens.has_value(); }
  core::EyePlace eye_place(std::uint32_t column, std::uint32_t row) const override;
  /// Left of a pixel is that N columns before, rounded: the view that is nearest. Pixels share no
  /// corners with those beside them, for strips change from row to row.
  core::PixelLattice lattice(std::uint32_t width) const override;
  Properties describe() const override;

  core::PixelPlace strip_place(std::uint32_t view, std::uint32_t views,
                               const core::PixelPlace& place) const override;
  core::PixelPlace place_at(double at, double row, double cell) const override;

  const SlantedSheet& rows() const { return m_rows; }
  std::uint64_t dark_pixels() const override { return m_dark_pixels; }
  std::vector<std::string> model_report() const override;

 protected:
  std::string dark_warning() const override;

 private:
  /// What leaves the sheet for a place; false: nothing.
  bool exit_of(const SlantedPlace& at, double row, SheetExit& out) const;
  SlantedPlace on_print(const core::PixelPlace& place) const;
  /// Along right, towards the eye that sees the scene.
  double scene_slope(const SlantedPlace& at, const SheetExit& exit, double row) const;
  void place_ray(const SlantedPlace& at, const SheetExit& exit, double row, core::Ray& out) const;
  bool is_dark(std::uint32_t column, std::uint32_t row) const;
  bool may_be_dark() const;
  std::uint64_t count_dark_pixels() const;
  RayShares count_shares() const;

  double m_stretch;  ///< scene units a mm upwards by those to the right
  SlantedSheet m_rows;
  std::optional<ThickLens> m_lens;  ///< of the thick model
  RayShares m_shares;
  std::uint64_t m_dark_pixels = 0;
};

}  // namespace lentray::camera
