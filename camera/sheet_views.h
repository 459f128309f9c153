// Views of a lens sheet as pictures of any size, and quilts of views. World space, unit directions.
//
// View j of M looks through every lens at the print offset e_j = ((j + 1/2)/M - 1/2) P' from the
// middle of its cell. A SizedView has W x H pixels of equal shape all over the sheet: the ray of a
// place is that of a lens whose axis lies there, with the sheet's own model. V infinite: parallel
// rays. V finite and paraxial: the perspective of the eye at -V n e_j/f beside the sheet's own.
// Thick: K rays a pixel, over its own row's height. View 0 looks through the left edges of the cells,
// so its eye is the rightmost one.
//
// A Quilt puts the pictures of cameras side by side: the first one lower left, from there to the
// right and upwards. Looking Glass displays want the leftmost camera first.
// Immutable, any number of threads. Source: docs/lens/formulae.md; docs/views.md.
#pragma once

#include <memory>
#include <vector>

#include "camera/lenticular.h"

namespace lentray::camera {

class SizedView final : public CameraOfOthers {
 public:
  /// The sheet must outlive it. view < views; width, height > 0.
  SizedView(const Lenticular& sheet, std::uint32_t view, std::uint32_t views, std::uint32_t width,
            std::uint32_t height);
  bool one_ray_at(const core::PixelPlace& place, const core::PlaceRay& which,
                  core::Ray& out) const override;
  core::EyePlace eye_place(std::uint32_t column, std::uint32_t row) const override {
    return {column, row, m_view};
  }
  Properties describe() const override;

  /// e_j in cells, -1/2 to 1/2, and in mm.
  double cell_offset() const { return m_offset; }
  double print_offset() const { return m_offset * m_sheet.sheet().lens().print_pitch(); }

 private:
  Found find(const core::PixelPlace& place) const override;

  const Lenticular& m_sheet;
  std::uint32_t m_view, m_views;
  double m_offset;
  double m_lenses_a_column, m_rows_a_row;  ///< of the sheet, by columns and rows of the view
};

/// View j of M in that size: the sheet's own columns where they are just these pixels, so that the
/// bits are those of the sheet; else a SizedView.
std::shared_ptr<const Camera> make_view(const Lenticular& sheet, std::uint32_t view,
                                        std::uint32_t views, std::uint32_t width,
                                        std::uint32_t height);

class Quilt final : public CameraOfOthers {
 public:
  /// columns * (rows) cameras of one size, at least one; `about` goes before the quilt's own
  /// properties.
  Quilt(std::vector<std::shared_ptr<const Camera>> tiles, std::uint32_t columns, Properties about);
  /// Pixels of a tile join within its row of tiles only: beyond its left edge lies what lies there
  /// in the tile's own picture. Rows join through: a tile's upper row is compared with the tile
  /// above.
  core::PixelLattice lattice(std::uint32_t width) const override;
  Properties describe() const override;

 private:
  Found find(const core::PixelPlace& place) const override;

  std::vector<std::shared_ptr<const Camera>> m_tiles;
  std::uint32_t m_columns, m_rows, m_tile_width, m_tile_height;
  Properties m_about;
};

/// The lens whose M views, at equal steps over its width, are seen under that angle between the
/// outermost ones: paraxial, one pixel a view, without refraction. `distance`: V in mm, may be
/// infinite. 0 < degrees < 180, views > 1.
LensParameters lens_of_cone(double degrees, std::uint32_t views, double pitch, double distance);

}  // namespace lentray::camera
