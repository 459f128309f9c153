// How a picture is sampled and made, whatever its scene and camera: what changes pixels first, then
// what never does. Plain data. Errors of what is here are found by Session::plan():
// parser::OptionError.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/render/band_queue.h"
#include "core/render/film.h"

namespace lentray::tool {

/// Columns and rows that are rendered, both ends included, from 1; what is below 1 is a part of the
/// width or height.
struct PartOfPicture {
  std::optional<double> start_column{}, end_column{}, start_row{}, end_row{};
};

struct FilmSettings {
  core::Antialiasing antialiasing{};
  int angles = 1;      ///< directions averaged within a pixel of a lens sheet
  bool alpha = false;  ///< for a scene that was built with it
  int quality = 9;     ///< below 4 nothing casts a shadow
  PartOfPicture part{};

  std::string pixel_order = "auto", shadow_cache = "auto";
  int threads = 0;                           ///< 0: all of the machine
  std::uint64_t most_radiosity_samples = 0;  ///< 0: as the memory allows
  std::uint32_t band_height = 0;             ///< rows; 0: as the memory allows
  double max_memory = 0.0;   ///< bytes, of the scene and the bands; 0: half of the machine's
  bool bundles = true;       ///< neighbouring camera rays are searched for together
  bool count_tests = false;  ///< of bounds and shapes
  bool log_shadows = false;  ///< runs, blockers and costs of shadow rays
};

/// Bytes of a band's row, with a share for the encoder.
double bytes_a_row(const core::Antialiasing& antialiasing, std::uint32_t width);

/// The picture's size, and the rows that are made at a time.
core::FrameShape frame_shape(const FilmSettings& film, std::uint32_t width, std::uint32_t height);

/// The pixels that are rendered, if not all.
std::optional<core::PixelRegion> region_of(const PartOfPicture& part, std::uint32_t width,
                                           std::uint32_t height);

}  // namespace lentray::tool
