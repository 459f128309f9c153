// A slanted lens sheet: its lenses stand at an angle to the picture's columns. Which lens a pixel
// lies behind, where under it, and the direction in which it is seen.
//
// Units: mm on the sheet, x to the right and y upwards from its middle; slopes (tangents against the
// sheet's normal) for directions. The slant a is positive where the tops of the lenses lean to the
// right, as in "/". In the lenses' frame u = x cos a - y sin a runs across them and
// w = x sin a + y cos a along them. P and P' are measured across the lenses, N along a row.
//
// Light leaves the sheet at the height of its pixel's row, and towards the eyes' line, which is level:
// its slope along y is that of the row. Its slope T across the lens is the lens model's. The two
// give its slope along x: T / cos a + m_y tan a.
// Immutable, any number of threads. Source: docs/lens/formulae.md, "Slanted sheets";
// tests/unit/camera/camera_slanted_sheet_test holds the rays, tests/image/slanted_sheets_test the pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "camera/lens_sheet.h"

namespace lentray::camera {

/// The picture behind a slanted sheet.
struct SlantedPrint {
  std::uint32_t width = 0, height = 0;  ///< pixels
  double sheet_height = 0.0;            ///< mm
  /// Slopes of the line from the eye to the sheet's middle.
  double eye_slope_x = 0.0, eye_slope_y = 0.0;
};

/// Where a place of the print lies under its lens.
struct SlantedPlace {
  double axis = 0.0;         ///< u of the lens's axis, mm
  double cell_offset = 0.0;  ///< e, mm across the lens, in the print
  double lens_offset = 0.0;  ///< o, mm across the lens, from its axis
};

class SlantedSheet {
 public:
  /// The parameters must be valid (complaint() empty), the sizes positive. A slant of 0 is possible.
  SlantedSheet(const LensParameters& lens, const SlantedPrint& print);

  const LensParameters& lens() const { return m_lens; }
  const SlantedPrint& print() const { return m_print; }
  double cosine() const { return m_cosine; }  ///< cos a
  double sine() const { return m_cosine * m_lens.slant; }
  double lenses() const { return m_lenses; }  ///< L, along a row

  /// Height of a place in the picture's rows above the sheet's middle, mm on the sheet.
  double row_height(double row) const {
    return (0.5 - row / m_print.height) * m_print.sheet_height;
  }
  /// The slope of a row's light upwards: m_y = Y/V + eye_slope_y.
  double rise(double row) const {
    return row_height(row) / m_lens.view_distance + m_print.eye_slope_y;
  }
  /// How many columns the strips behind the lenses lie to the right of where they are at the sheet's
  /// middle height.
  double shift(double row) const { return row_height(row) * m_columns_a_mm; }

  /// The lens of a pixel, of the picture or beyond its edges; the lens number is that along the row at
  /// the middle height. A pixel centred on a boundary (within a part 1e-9 of a lens) belongs to the
  /// right-hand lens.
  std::int64_t lens_of(std::int64_t column, std::int32_t row) const;
  /// A place of a pixel's row, in columns, under the strip of a lens, as if that strip lay behind a
  /// lens that stands `across` lenses to the right.
  SlantedPlace place(double column, double row, std::int64_t lens, double across = 0.0) const;
  /// The lens whose axis is nearest to (i + 1/2 - L/2) P/cos a, place i of a row.
  std::int64_t nearest_lens(std::int64_t place, std::int32_t row) const;
  /// The place of a row that is nearest to a lens's axis; it may lie beyond the sheet's edges.
  std::int64_t nearest_place(std::int64_t lens, std::int32_t row) const;
  /// The part of its cell at which a pixel of a row lies, 0 at the cell's left edge, below 1.
  double part_of_cell(std::int64_t column, std::int32_t row) const;
  /// Its number among the pixels of its row that lie behind its lens, from the left.
  std::int64_t view_of(std::int64_t column, std::int32_t row) const;
  /// The column whose pixel view j of `views` shows at place i of a row: of the nearest lens, the
  /// pixel that is nearest to the print offset ((j + 1/2)/views - 1/2) P'. Beyond the picture's edges it
  /// is that of the next lens within.
  std::uint32_t view_column(std::uint32_t view, std::uint32_t views, std::int64_t place,
                            std::int32_t row) const;

  /// The slope along a lens of light that rises by m_y.
  SlopeAlong along(double rise) const { return {rise / m_cosine, m_lens.slant}; }
  /// T of a lens offset; that of the model thick is that of light through the vertex, which `pinhole`
  /// has too. False on total reflection.
  bool slope_across(double lens_offset, const SlopeAlong& along, double& slope) const;
  /// The lens offset that is seen along the slopes m_x, m_y: the inverse of slope_across.
  double offset_seen(double slope_x, double slope_y) const;
  /// The slope along x of light with that slope across its lens.
  double slope_x(double across, double rise) const {
    return across / m_cosine + rise * m_lens.slant;
  }
  /// x of a point at that u and height, mm.
  double x_of(double across, double height) const {
    return across / m_cosine + height * m_lens.slant;
  }
  /// In columns of the print, the place under a lens that lies at a print offset e in a row.
  double column_at(double cell_offset, double lens, double row) const;
  /// u of the axis of a lens, which need not be a whole one.
  double axis_of(double lens) const { return (lens + 0.5 - 0.5 * m_lenses) * m_lens.pitch; }
  /// o - e of a lens.
  double offset_of_cell(double axis) const { return axis * m_growth + m_shift; }

 private:
  LensParameters m_lens;
  SlantedPrint m_print;
  double m_cosine, m_lenses;
  double m_growth;        ///< f/(nV)
  double m_columns_a_mm;  ///< that a strip lies to the right, for each mm upwards
  double m_shift = 0.0;
};

/// tan a of a text: degrees ("9.46", "-18"), or the tangent itself as a fraction ("1/6"). Empty: it is
/// neither, or not between -80 and 80 degrees.
std::optional<double> tangent_of_slant(std::string_view text);
inline constexpr const char* kSlantExpected =
    "an angle of -80 to 80 degrees (9.46) or its tangent as a fraction (1/6) is expected";
/// The slant in degrees.
double slant_degrees(const LensParameters& lens);

}  // namespace lentray::camera
