// global_settings, read. Values the scene did not set keep stock's defaults.
// Source: reference manual 3.7, "Global Settings".
#pragma once

#include <optional>
#include <string>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/irradiance/settings.h"
#include "core/subsurface/settings.h"
#include "parser/source/source.h"

namespace lentray::parser {

using core::RadiositySettings;
using core::SubsurfaceSettings;

/// Kept; rendered later. autostop 0.5 and expand_thresholds 0.2, 35 are what stock does where they are
/// left out; its manual has 0 and 40.
struct PhotonSettings {
  double spacing = 1.0, jitter = 0.4, autostop = 0.5, expand_increase = 0.2;
  double adc_bailout = -1.0, radius = -1.0, radius_multiplier = 1.0;
  double media_radius = -1.0, media_radius_multiplier = 1.0, media_factor = 1.0;
  int count = 0, gather_min = 20, gather_max = 100, expand_min = 35, media_steps = 0;
  int max_trace_level = -1;
  std::string load_file, save_file;
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
  std::optional<SubsurfaceSettings> subsurface;
};

}  // namespace lentray::parser
