// How far two pictures of the same size differ, and the grade that earns.
//
// Unit of every difference: 1/255 of full scale, whatever the bits of the files. The difference of
// a pixel is the largest over R, G and B (grey counts as all three); alpha is not compared
// (core/image/display.h makes pictures in which it is seen).
// Grades, from what stock POV-Ray renders reproduce of each other:
//   exact  at least 99.9 % of the pixels within 1/255
//   match  at least 99 % within 2/255 (of a single lens: or all but 30 pixels), and PSNR >= 40 dB
//   noise  within stock's own noise, below; given by grade_by_noise() alone
//   close  PSNR >= 30 dB after an 8 x 8 box filter on both, for scenes that are noisy in stock too
//   fails  the rest
// Noise: stock's pictures of one scene differ where its samples of indirect light depend on the order of the work.
// S is the root of the mean square of what its pictures with other blocks or threads are off its own, as means of
// 16 x 16 pixels have it (`rms`) and in all (`bias`). A picture is within it where
//   rms <= max(0.3, 1.5 S)  and  |bias| <= max(0.2, 1.5 S of the bias)
// Errors: std::invalid_argument for pictures of different size. Threads: any number.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/image/reader.h"

namespace lentray::core {

enum class Grade { fails, close, noise, match, exact };  ///< ordered: worse < better
std::string_view name_of(Grade grade);
std::optional<Grade> grade_named(std::string_view name);

/// Columns first, first + step, ... (count of them), all rows. A view of an interlaced picture
/// has the step N, a lens the step 1.
struct Columns {
  std::vector<std::uint32_t> list;
  static Columns all(std::uint32_t width);
  static Columns range(std::uint32_t begin, std::uint32_t end);  ///< [begin, end)
  static Columns every(std::uint32_t first, std::uint32_t step, std::uint32_t width);
};

/// Means of 16 x 16 pixels beside each other, in 1/255.
struct BlockDifference {
  double rms = 0.0;   ///< root of the mean square over blocks, R, G and B
  double bias = 0.0;  ///< mean difference of the channel that is farthest off, signed
};
/// Also the difference of a picture whose views differ so.
BlockDifference root_mean_square(std::span<const BlockDifference> differences);
bool is_within(const BlockDifference& difference, const BlockDifference& noise);

struct Comparison {
  std::uint64_t pixels = 0;
  std::uint64_t beyond_1 = 0, beyond_2 = 0;  ///< pixels that differ by more than 1/255, 2/255
  double largest = 0.0, mean = 0.0;          ///< of the pixels' differences, in 1/255
  double psnr = 0.0;                         ///< dB over all channels; infinite when equal
  double smooth_psnr = 0.0;                  ///< the same after the box filter
  BlockDifference blocks;
  std::optional<BlockDifference> noise;  ///< stock's own, where it counts
  Grade grade = Grade::fails;
  double share_beyond_1() const { return pixels ? double(beyond_1) / double(pixels) : 0.0; }
  double share_beyond_2() const { return pixels ? double(beyond_2) / double(pixels) : 0.0; }
};

/// Pixels a single lens may have beyond 2/255 and still match.
inline constexpr std::uint64_t kLensAllowance = 30;

/// R, G, B of a pixel on the scale 0 .. 255.
std::array<double, 3> level(const StoredImage& image, std::uint32_t column, std::uint32_t row);
/// The largest difference over R, G and B, in 1/255.
double pixel_difference(const StoredImage& a, const StoredImage& b, std::uint32_t column,
                        std::uint32_t row);

/// `columns` side by side are taken for a picture (that matters to the box filter alone).
Comparison compare(const StoredImage& a, const StoredImage& b, const Columns& columns,
                   std::uint64_t allowance = 0);

/// An integral image: whole, behind each lens, and each view if N is whole.
struct LensComparison {
  Comparison whole;
  std::vector<Comparison> lenses;
  std::vector<Comparison> views;  ///< empty at fractional N
};
/// Lens of a column: floor((k + 1/2) / lens_pixels). Throws std::invalid_argument for
/// lens_pixels < 1.
LensComparison compare_lenses(const StoredImage& a, const StoredImage& b, double lens_pixels);

/// Below match the grade is noise or fails from now on: close does not count. `stock` and `others`: stock's pictures,
/// one as `result` was compared with, and those that differ by its noise. Views are each graded by their own noise.
void grade_by_noise(LensComparison& result, const StoredImage& stock,
                    std::span<const StoredImage> others);

/// The whole reaches `asked`, and every lens and view reaches the lesser of `asked` and match. Lenses are not asked
/// where noise counts: a lens is too narrow for its blocks.
bool reaches(const LensComparison& result, Grade asked);

}  // namespace lentray::core
