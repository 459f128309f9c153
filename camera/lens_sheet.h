// A lenticular sheet: which lens a pixel lies behind, where under it, and the direction in which
// that pixel is seen. One dimensional; rows and the place in the world are the camera's affair.
//
// Units: millimetres on the sheet, slopes (tangents against the sheet's normal) for directions.
// Positive offsets look towards +right: the picture is orthoscopic, ready for display.
// Immutable. Source: the optics of a plano-convex lens sheet; tests/unit/camera/camera_lens_sheet_test
// holds every formula, tests/image/rays_test the rays against stock.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/numeric/lens_columns.h"

namespace lentray::camera {

enum class LensModel {
  kParaxial,  ///< tan t = n o/f: slopes linear in the offset
  kPinhole,   ///< sin t = n sin t_in: Snell's law through a pinhole
  kThick,     ///< several rays a pixel through a round surface (camera/thick_lens.h)
};
const char* name_of(LensModel model);
std::optional<LensModel> model_named(std::string_view name);

/// A sheet as its maker describes it.
struct LensParameters {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double pitch = 1.124;        ///< P, mm
  double focal_length = 3.03;  ///< f, mm, from the lens's vertex to the print, in the material
  double ior = 1.6;            ///< n; 1: no refraction
  double pixels = 15.0;        ///< N, pixels a lens; may be fractional
  double view_distance = kInfinity;  ///< V, mm
  LensModel model = LensModel::kPinhole;
  std::uint32_t rays = 16;      ///< K, rays a pixel of the thick model
  double surface_radius = 0.0;  ///< of the thick model's surface, mm; 0: it focuses on the print
  /// What offsets from the middle of a cell are multiplied by before the model asks where they look:
  /// below 1 the eyes of the views stand closer together, and depth is compressed. The print stays.
  double depth_factor = 1.0;
  /// tan a of the lenses against the picture's columns; positive: their tops lean to the right. Pitches
  /// are measured across the lenses, N along a row (camera/slanted_sheet.h).
  double slant = 0.0;

  bool is_finite() const { return view_distance < kInfinity; }
  /// P' = P (1 + f/(nV)): the pitch of the printed strips.
  double print_pitch() const;
  double slant_cosine() const { return 1.0 / std::sqrt(1.0 + slant * slant); }  ///< cos a
  /// P'/N in mm: a pixel's size across the lenses.
  double pixel_size() const { return print_pitch() / pixels; }
  /// Pixels an inch of the print, along a row.
  double print_dpi() const { return 25.4 / pixel_size() * slant_cosine(); }
  double lenses_per_inch() const { return 25.4 / pitch; }
  /// R of the round surface, mm; without one of its own f (n - 1)/n, which focuses on the print.
  double radius() const {
    return surface_radius > 0.0 ? surface_radius : focal_length * (ior - 1.0) / ior;
  }
};

/// The slope of light along a lens, for each slope T across it: at_zero + lean T.
struct SlopeAlong {
  double at_zero = 0.0, lean = 0.0;
  double at(double across) const { return at_zero + lean * across; }
};

constexpr std::uint32_t kMostLensRays = 1024;
/// The tangent of 80 degrees, rounded up.
constexpr double kSteepestSlant = 5.67128182;

/// Why the parameters describe no sheet, or empty. Lenses must be at least a pixel wide, and those of
/// the thick model no wider than the circle that their surface is part of.
std::string complaint(const LensParameters& lens);

/// N for a print resolution: N = P' DPI / (25.4 cos a).
double pixels_for_dpi(const LensParameters& lens, double dpi);

/// Where a pixel column lies under its lens. The thick model's slope is that of the ray through the
/// lens's vertex, which Snell's law gives as it gives the pinhole's.
struct LensColumn {
  double lens = 0.0;  ///< i = floor((k + 1/2)/N); between whole numbers: beside a lens's axis
  double axis = 0.0;  ///< x_i, mm from the sheet's middle
  double cell_centre = 0.0;  ///< c_i, in the print
  double centre = 0.0;       ///< X_k, in the print
  double cell_offset = 0.0;  ///< e = X_k - c_i
  double lens_offset = 0.0;  ///< o = X_k - x_i; with a depth factor e is multiplied by it
  double slope = 0.0;        ///< tan t; 0 when dark
  bool dark = false;         ///< total internal reflection: that ray shows nothing
};

/// Of a slanted sheet it has the sizes, and the columns of the row at its middle height, their offsets
/// and slopes across the lenses.
class LensSheet {
 public:
  /// `eye_slope`: horizontal slope of the line from the eye (finite or not) to the sheet's middle,
  /// -e_x/V for an eye whose foot is e_x beside the middle. The print shifts along with the eye; with
  /// an infinite V by just what makes the middle view look along eye_slope, whatever the model.
  /// The parameters must be valid (complaint() empty) and width > 0.
  LensSheet(const LensParameters& lens, std::uint32_t width, double eye_slope = 0.0);

  const LensParameters& lens() const { return m_lens; }
  double eye_slope() const { return m_eye_slope; }
  std::uint32_t width() const { return static_cast<std::uint32_t>(m_columns.size()); }
  /// L = W/N: fractional when the last lens is cut, or where the picture was rounded to whole pixels.
  double lenses() const { return m_lenses; }
  /// Lenses that own at least one pixel.
  std::uint32_t lens_count() const { return static_cast<std::uint32_t>(m_columns.back().lens) + 1; }
  /// The columns behind each lens; of a slanted sheet those at its middle height.
  core::LensColumns columns() const { return {m_lens.pixels}; }
  /// L as it is reported: whole unless the last lens is cut.
  double counted_lenses() const { return columns().counted(width()); }
  bool is_slanted() const { return m_lens.slant != 0.0; }
  /// L P / cos a: the sheet's width in mm.
  double sheet_width() const { return m_lenses * m_lens.pitch / m_lens.slant_cosine(); }
  /// L P' / cos a: the print's width in mm.
  double print_width() const { return m_lenses * m_lens.print_pitch() / m_lens.slant_cosine(); }

  const LensColumn& column(std::uint32_t k) const { return m_columns[k]; }
  /// A place that need not be a pixel's centre, under a given lens (for finer sampling).
  LensColumn place(double column, std::int64_t lens) const;
  /// What column k (of the sheet or beyond its edges) shows beside its lens's axis, `across` lenses
  /// to the right, as if a lens stood there with the same strip of the print behind it; `turn`
  /// pixels of the print off the column's middle.
  LensColumn beside(std::int64_t k, double across, double turn) const;
  /// The lens of a column, of the sheet or beyond its edges.
  std::int64_t lens_of(std::int64_t k) const;
  /// The column of the lens before that shows most nearly the same: k - N for whole N, else the one
  /// whose offset in its cell is nearest.
  std::int64_t left_of(std::int64_t k) const;

  /// Whole N: the number of views; 0 when N is fractional or the sheet slanted.
  std::uint32_t views() const;
  std::uint32_t dark_columns() const { return m_dark; }
  /// The widest pitch that leaves no column of this sheet dark, all else equal, in mm.
  /// Infinite when no pitch does (n = 1, or the paraxial model).
  double widest_pitch() const;
  /// How far, in print pixels, a column's ray misses the eye of its view: 0 for the paraxial
  /// model; with Snell's law the rays of a view meet only nearly. 0 when V is infinite.
  double largest_eye_miss() const;
  /// How far, in print pixels, the paraxial model is from Snell's law at the worst column: the
  /// distance in the print between where the paraxial ray starts and where Snell's law has it start.
  double paraxial_error() const;
  /// The cheapest model that is nowhere farther than that from Snell's law.
  LensModel cheapest_model(double within_pixels) const;

 private:
  /// `cells`: the offset from the cell's middle, in cells.
  LensColumn at(double cells, double lens) const;

  LensParameters m_lens;
  double m_eye_slope;
  double m_shift;  ///< of the print, mm
  double m_lenses;
  std::vector<LensColumn> m_columns;
  std::uint32_t m_dark = 0;
};

/// tan t of a lens offset o (mm). False on total internal reflection.
bool slope_of(const LensParameters& lens, double lens_offset, double& slope);
/// The lens offset that is seen at a slope: the inverse of slope_of.
double offset_of(const LensParameters& lens, double slope);

}  // namespace lentray::camera
