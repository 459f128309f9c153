// What a scene asks of photons: how many are shot, how they are followed, and how light is gathered from
// them. Lengths in scene units. Plain values.
// Source: reference manual 3.7, "Photons"; autostop and expand_thresholds are what stock does where they are
// left out, for which its manual has 0 and 40.
#pragma once

#include <string>

namespace lentray::core {

/// `photons { }` of global_settings.
struct PhotonSettings {
  double spacing = 1.0, jitter = 0.4, autostop = 0.5, expand_increase = 0.2;
  double adc_bailout = -1.0;  ///< below 0: the scene's
  double radius = -1.0, radius_multiplier = 1.0;
  double media_radius = -1.0, media_radius_multiplier = 1.0;
  double media_factor = 1.0;  ///< greater than 0
  int count = 0;              ///< about so many photons reach targets; 0: `spacing` says
  int gather_min = 20, gather_max = 100, expand_min = 35;
  int media_steps = 0;       ///< at most so many photons in a piece of a way through media
  int max_trace_level = -1;  ///< below 0: the scene's
  std::string load_file, save_file;
};

}  // namespace lentray::core
