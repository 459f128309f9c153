// What a scene asks of radiosity, and what follows from it for each bounce. Lengths of reuse are shares of
// the distance to the camera. Plain values.
// Source: reference manual 3.7, "Radiosity"; the rules of deeper bounces are those that replay stock's
// pictures (tests/image/radiosity_test.cpp).
#pragma once

namespace lentray::core {

/// `radiosity { }` of global_settings.
struct RadiositySettings {
  double adc_bailout = 0.01, brightness = 1.0, error_bound = 1.8, gray_threshold = 0.0;
  double low_error_factor = 0.5, maximum_reuse = 0.2, minimum_reuse = 0.015;
  double max_sample = -1.0;  ///< not positive: no limit
  double pretrace_start = 0.08, pretrace_end = 0.04;
  int count = 35, direction_pool = 1600, nearest_count = 5, nearest_count_adaptive = 0;
  int recursion_limit = 2;
  bool always_sample = false, media = false, normal = false, subsurface = false;
  double default_importance = 1.0;  ///< of objects without one, and of the sky
};

/// A sample of depth d gathers light for a surface that is seen after d bounces.
struct DepthRules {
  unsigned rays;         ///< that a sample gathers with
  double wanted;         ///< how many samples a place is to have
  double error_factor;   ///< on the error bound and on the lengths of reuse
  double gather_weight;  ///< that a gather's rays begin with, and
  int gather_level;      ///< the levels above them
};
DepthRules rules_at(const RadiositySettings& settings, int depth);

}  // namespace lentray::core
