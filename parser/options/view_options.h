// What a command line asks of the views of a lens sheet, and of quilts (docs/views.md). What was
// not said stays empty. Plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

namespace lentray::parser {

struct PixelSize {
  std::uint32_t width = 0, height = 0;
  bool operator==(const PixelSize&) const = default;
};

struct QuiltGrid {
  std::uint32_t columns = 0, rows = 0;
  std::optional<PixelSize> display_size{};  ///< of the whole quilt, where a display was named
  std::optional<double> display_aspect{};   ///< its width by its height
  std::uint32_t views() const { return columns * rows; }
};

struct ViewOptions {
  std::optional<std::uint32_t> count;  ///< Views=M
  std::optional<PixelSize> size;       ///< of each view, or of a quilt's tile
  std::optional<QuiltGrid> quilt;
  std::optional<double> aspect;  ///< of the display a quilt is for
  std::optional<double> cone;    ///< degrees between a quilt's outermost cameras
  /// Clocks of the first and the last view.
  std::optional<std::pair<double, double>> clocks;
};

inline constexpr double kUsualViewCone = 35.0;  ///< degrees
inline constexpr std::uint32_t kMostViews = 1'000'000;

}  // namespace lentray::parser
