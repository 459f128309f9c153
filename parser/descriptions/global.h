// global_settings, read. Values the scene did not set keep stock's defaults.
// Source: reference manual 3.7, "Global Settings".
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/irradiance/settings.h"
#include "core/photon/photon_maps.h"
#include "core/photon/settings.h"
#include "core/subsurface/settings.h"
#include "parser/source/source.h"

namespace lentray::parser {

using core::PhotonSettings;
using core::RadiositySettings;
using core::SubsurfaceSettings;

/// What a file of photons holds; null: none was read.
struct LoadedPhotons {
  std::shared_ptr<const core::PhotonMaps> maps;
};

struct GlobalDesc {
  Location where;
  std::optional<double> assumed_gamma;  ///< a number; see gamma_is_srgb
  bool gamma_is_srgb = false;           ///< `assumed_gamma srgb`
  int assumed_gamma_version = 370;      ///< #version x 100 where it stood
  std::optional<int> max_trace_level;
  std::optional<double> adc_bailout;
  std::optional<core::Rgb> ambient_light;
  core::Vec3 irid_wavelength{0.70, 0.52, 0.48};
  int number_of_waves = 10;
  std::optional<int> noise_generator;  ///< 1..3
  double mm_per_unit = 10.0;
  std::optional<RadiositySettings> radiosity;
  std::optional<PhotonSettings> photons;
  LoadedPhotons loaded_photons;  ///< of load_file
  std::optional<SubsurfaceSettings> subsurface;
};

}  // namespace lentray::parser
