// How far two integral images are apart for an eye before their lens sheet.
//
// Nobody sees a pixel of a print. A lens blurs a few of its columns together, and an eye blends
// rows that are closer than it can tell apart. So what is seen of a lens in a row, at a part c of
// the lens, is a mean of linear light:
//   columns  of that lens, with the weights max(0, 1 - |k + 1/2 - x|/h) at x = origin + (i + c) N;
//            they add up to 1. h is 2/15 of a lens, and a column at least
//   rows     around it, with the weights of a normal distribution whose full width at half its
//            height is the eye's angle at its distance, integrated over each row; they add up to 1
// Nothing is mixed across lenses. Rows of a picture's top and bottom that lack some of the rows
// around them are not seen, nor are lenses that the picture's edges cut.
// Differences are of CIE L*, 0 black to 100 white.
//
// Units: N, h and x in columns; parts of a lens from 0, its left edge, to 1. Light: 0 black, 1
// white.
// Errors: std::invalid_argument, worded for the user. Immutable, any number of threads.
// Source: h is 0.085 mm of 40 lenses an inch, where the lens's own blur takes 2.3 to 3.3 of 15
// columns; CIE 15, L*; Rec. 709, luminance. tests/unit/tools/seen_measure_test evaluates it a
// second time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lentray::diff {

/// One quantity of light, row 0 on top.
struct LightPlane {
  std::uint32_t width = 0, height = 0;
  std::vector<float> values{};
  float at(std::uint32_t column, std::uint32_t row) const {
    return values[std::size_t{row} * width + column];
  }
};

/// Weights of linear R, G and B in luminance.
inline constexpr std::array<double, 3> kLuminance{0.2126, 0.7152, 0.0722};

/// The lenses of an integral image.
struct LensRows {
  double pixels = 1.0;  ///< N, 1 or more; may be fractional
  /// Where lens 0 begins in each row, in columns, steadily more or steadily less; empty: at 0 in
  /// all, lenses are upright.
  std::vector<double> origins{};
  double origin(std::uint32_t row) const { return origins.empty() ? 0.0 : origins[row]; }
};

struct EyeBeforePrint {
  double rows_an_inch = 600.0;
  double distance = 400.0;   ///< mm
  double arc_minutes = 1.0;  ///< that the eye tells apart
  /// The normal distribution's standard deviation, in rows.
  double sigma() const;
};

/// The weights of the rows around a row, from the highest to the lowest: an odd number of them.
std::vector<double> row_weights(const EyeBeforePrint& eye);

/// CIE L* of a relative luminance.
double lightness(double luminance);

/// The parts of a lens that eyes are taken to see.
inline constexpr std::array<double, 5> kSeenParts{0.1, 0.3, 0.5, 0.7, 0.9};
inline constexpr std::size_t kMiddlePart = 2;

class EyeMeasure {
 public:
  /// Of pictures of that size. Throws where no lens is seen whole, or no row with all around it.
  EyeMeasure(LensRows lenses, const EyeBeforePrint& eye, std::uint32_t width, std::uint32_t height);

  std::int64_t first_lens() const { return m_first_lens; }  ///< that of column 0 of what is seen
  std::uint32_t first_row() const { return m_reach; }       ///< that of its row 0
  std::uint32_t lenses() const { return m_lenses; }
  std::uint32_t rows() const { return m_height - 2 * m_reach; }
  /// Of the seen lenses that at a place of a row that is seen, in columns from 0; none: it is not
  /// seen there.
  std::optional<std::uint32_t> lens_at(double column, std::uint32_t row) const;
  /// Half the width of the blur over columns.
  double blur() const { return m_blur; }
  /// Whether a lens is whole in a row that is seen and in all rows around it; both counted among
  /// what is seen. Upright lenses always are.
  bool is_seen(std::uint32_t lens, std::uint32_t row) const;

  /// What an eye sees at a part of each lens: lenses() x rows(). 0 where is_seen() is false.
  LightPlane seen(const LightPlane& picture, double part) const;

 private:
  /// The columns of a lens in a row, and their weights.
  struct Taps {
    std::uint32_t first = 0;
    std::vector<float> weights{};  ///< none: the lens is not whole there
  };
  std::vector<Taps> taps(std::uint32_t row, double part) const;
  bool is_whole(std::int64_t lens, std::uint32_t row) const;
  LightPlane through_lenses(const LightPlane& picture, double part) const;

  LensRows m_lens;
  std::vector<double> m_weights;  ///< of rows
  std::uint32_t m_reach = 0;      ///< rows above and below that are mixed in
  std::uint32_t m_width, m_height;
  double m_blur;
  std::int64_t m_first_lens = 0;
  std::uint32_t m_lenses = 0;
};

/// A place in what is seen; lens and row are those of the picture.
struct SeenPoint {
  double part = 0.0;
  std::int64_t lens = 0;
  std::uint32_t row = 0;
};

/// Of L*, second picture less first.
struct SeenDifference {
  std::size_t points = 0;
  double rms = 0.0;
  double within_99 = 0.0;  ///< what 99 % of the points do not exceed, without sign
  double largest = 0.0;    ///< without sign
  double bias = 0.0;       ///< mean, signed
  SeenPoint where{};       ///< the largest
};
struct SeenDifferences {
  SeenDifference all;
  std::vector<SeenDifference> parts;  ///< as kSeenParts
  LightPlane largest;                 ///< over the parts, without sign: lenses() x rows()
};

/// `first`, `second`: luminances that are seen at kSeenParts, one after another.
SeenDifferences seen_differences(const EyeMeasure& measure, const std::vector<LightPlane>& first,
                                 const std::vector<LightPlane>& second);

}  // namespace lentray::diff
