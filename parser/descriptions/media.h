// Participating media and their densities as written.
// Source: reference manual 3.7, "Media".
#pragma once

#include <vector>

#include "core/base/color.h"
#include "parser/descriptions/maps.h"
#include "parser/descriptions/pattern.h"

namespace lentray::parser {

/// A density: like a pigment, with colours that are amounts.
struct DensityDesc {
  Location where;
  PatternDesc pattern;
  core::Colour colour{{1, 1, 1}, 0, 0};  ///< of a plain density
  Ref<ColourMapDesc> colour_map;
  Ref<DensityMapDesc> density_map;
};

struct ScatteringDesc {
  int type = 1;
  core::Rgb colour;
  double eccentricity = 0.0, extinction = 1.0;
};

struct MediaDesc {
  Location where;
  int method = 3, intervals = 1, min_samples = 1, max_samples = 1;
  double confidence = 0.9, variance = 1.0 / 128.0, ratio = 0.9, jitter = 0.0;
  int aa_level = 3;
  double aa_threshold = 0.1;
  core::Rgb absorption, emission;
  ScatteringDesc scattering;
  bool ignore_photons = false;
  std::vector<Ref<DensityDesc>> densities;  ///< multiplied
};

Ref<MediaDesc> transformed(Ref<MediaDesc> media, const core::Transform& transform);

}  // namespace lentray::parser
