#include "tools/session/film.h"

#include <algorithm>
#include <cmath>

#include "core/base/memory_limit.h"
#include "core/render/frame.h"
#include "parser/options/options.h"
#include "shadow/pixel_orders.h"
#include "tools/common/machine.h"

namespace lentray::tool {
namespace {

/// How many of `size` columns or rows lie before an edge; what is below 1 is a part of them all.
/// As stock: a start of 1 is the first column, an end of 1 the whole width; and 0.9 is the float
/// next to it, which leaves a column less than a reader might think.
std::uint32_t columns_before(double given, std::uint32_t size, bool is_start, const char* name) {
  const double edge = static_cast<float>(given);
  const bool is_part = is_start ? edge < 1.0 : edge <= 1.0;
  const double before =
      is_part ? std::floor(edge * size) : std::floor(edge) - (is_start ? 1.0 : 0.0);
  if (before > size || (is_start && before >= size)) {
    throw parser::OptionError(std::string(name) + " lies beyond the picture's " +
                              std::to_string(size));
  }
  return static_cast<std::uint32_t>(before);
}

}  // namespace

double bytes_a_row(const core::Antialiasing& antialiasing, std::uint32_t width) {
  return 1.25 * core::bytes_a_band_row(antialiasing, width);
}

core::FrameShape frame_shape(const FilmSettings& film, std::uint32_t width, std::uint32_t height) {
  core::FrameShape shape{width, height, film.band_height};
  if (film.band_height == 0) {
    const double limit = film.max_memory > 0.0 ? film.max_memory : 0.5 * machine_memory();
    const double row = bytes_a_row(film.antialiasing, width);
    // In steps, so that the same run gets the same bands.
    constexpr double kStep = 16.0 * 1024 * 1024;
    const double scene = std::ceil(core::resident_bytes() / kStep) * kStep;
    shape.band_height = shadow::band_height(film.pixel_order, width, height, row, limit - scene);
    if (shape.band_height * row > limit - scene) {
      throw parser::OptionError(
          "Max_Memory is less than the scene and a row of the picture take; that is " +
          core::memory_text(scene + row));
    }
  }
  // Tiles of antialiasing are not cut.
  const std::uint32_t grain = core::Film::rows_together(film.antialiasing);
  shape.band_height = (std::min(shape.band_height, height) + grain - 1) / grain * grain;
  return shape;
}

std::optional<core::PixelRegion> region_of(const PartOfPicture& part, std::uint32_t width,
                                           std::uint32_t height) {
  if (!part.start_column && !part.end_column && !part.start_row && !part.end_row)
    return std::nullopt;
  core::PixelRegion region;
  region.left = columns_before(part.start_column.value_or(1.0), width, true, "Start_Column");
  region.top = columns_before(part.start_row.value_or(1.0), height, true, "Start_Row");
  region.right = columns_before(part.end_column.value_or(1.0), width, false, "End_Column");
  region.bottom = columns_before(part.end_row.value_or(1.0), height, false, "End_Row");
  if (region.left >= region.right) throw parser::OptionError("Start_Column lies behind End_Column");
  if (region.top >= region.bottom) throw parser::OptionError("Start_Row lies behind End_Row");
  return region;
}

}  // namespace lentray::tool
