// The paper's arrangement without its approximations: which pixels' shadow rays are blocked when a
// rectangle of shadow lies on a plane facing the sheet, found from the lens's own formulae, and how
// many blocked ones follow each other in an order of pixels: the "continuous cache hits".
//
// Space: across the sheet to the right, down it, both in mm from its middle; D in mm behind it.
// The viewing distance is infinite. Pixels are square.
// Blocked: the ray of a pixel meets the plane in [Xstart, Xstart + A] x [Ystart, Ystart + A],
// edges included; an edge within 1e-9 mm of a ray is moved that far off it, outwards. Continuous
// hits: the longest run of successive blocked shadow rays in the order, the ray that fills the
// cache counted. Pixels that see nothing (total reflection in the sheet) cast no shadow ray.
// Errors: std::invalid_argument for what is no sheet or no shadow. Immutable, any number of
// threads.
// Source: docs/lens/formulae.md for the rays; tests/unit/shadow/shadow_enumeration_test holds it against pixel
// after pixel, tests/image/hit_model_test against the kernel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "camera/lens_sheet.h"
#include "shadow/hit_model/equations.h"

namespace lentray::shadow {

/// A sheet with its rows.
class PaperSheet {
 public:
  /// `rows` 0: as many as columns. Whole lenses if N is whole.
  PaperSheet(const camera::LensParameters& lens, std::uint32_t lenses, std::uint32_t rows = 0);

  const camera::LensSheet& columns() const { return m_columns; }
  const camera::LensParameters& lens() const { return m_columns.lens(); }
  std::uint32_t width() const { return m_columns.width(); }
  std::uint32_t rows() const { return m_rows; }
  double pixel() const { return lens().pixel_size(); }
  double height() const { return m_rows * pixel(); }
  /// Where the middle of a row is, mm down from the middle of the sheet.
  double row_place(std::uint32_t row) const { return (row + 0.5 - 0.5 * m_rows) * pixel(); }
  /// Where the ray of a column meets a plane; not for dark columns.
  double column_place(std::uint32_t column, double distance) const {
    const camera::LensColumn& c = m_columns.column(column);
    return c.axis + distance * c.slope;
  }

 private:
  camera::LensSheet m_columns;
  std::uint32_t m_rows;
};

struct ShadowSquare {
  double size = 0.0;        ///< A, mm, across and down
  double distance = 0.0;    ///< D, mm, 0 or more
  double x = 0.0, y = 0.0;  ///< Xstart, Ystart, mm
};

/// A style of grouping, and the strips of the last two.
struct Style {
  enum class Kind { kRows, kViews, kColumns, kCombined, kStrips };
  Kind kind = Kind::kRows;
  /// Pixels a strip; 0: what fits the shadow, lens by lens (the ideal that the paper presupposes).
  std::uint32_t width = 0, height = 0;

  bool is_ideal() const { return width == 0; }
  /// "rows", "views", "columns", "combined", "strips", "combined(4)", "strips(4,8)". Those but the
  /// ideal ones are pixel orders of that name.
  std::string name() const;
  friend bool operator==(const Style&, const Style&) = default;
};
/// The five of the paper, ideal.
const std::vector<Style>& paper_styles();

/// What an edge becomes that is to keep away from all of `places`; `outwards` is -1 or 1.
double clear_edge(const std::vector<double>& places, double edge, int outwards);

class Enumeration {
 public:
  enum Ray : std::uint8_t { kOpen, kBlocked, kNone };

  Enumeration(const PaperSheet& sheet, const ShadowSquare& shadow);

  /// The shadow with its edges off the rays.
  double left() const { return m_left; }
  double right() const { return m_right; }
  double top() const { return m_top; }
  double bottom() const { return m_bottom; }

  /// Of each column, if its row is blocked; of each row, if its column is.
  const std::vector<Ray>& columns() const { return m_columns; }
  const std::vector<Ray>& rows() const { return m_rows; }
  std::uint64_t blocked_columns() const { return m_blocked_columns; }
  std::uint64_t blocked_rows() const { return m_blocked_rows; }
  /// Shadow rays of the whole picture, and those that are blocked.
  std::uint64_t rays() const { return m_rays; }
  std::uint64_t blocked() const { return m_blocked_columns * m_blocked_rows; }
  std::uint64_t continuous_hits(const Style& style) const;

 private:
  class Counting;

  const PaperSheet& m_sheet;
  double m_left, m_right, m_top, m_bottom;
  std::vector<Ray> m_columns, m_rows;
  std::uint64_t m_blocked_columns = 0, m_blocked_rows = 0, m_rays = 0;
};

/// The paper's equation for a style on a sheet; nothing where it has none (strips that do not fit
/// the shadow).
struct ClosedForm {
  bool exists = false;
  std::uint64_t hits = 0;
};
ClosedForm closed_form(const PaperSheet& sheet, const ShadowSquare& shadow, const Style& style,
                       paper::Alpha kind);

}  // namespace lentray::shadow
