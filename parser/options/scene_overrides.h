// How well a picture is sampled, whatever its scene says: so that a study can vary it from the command
// line. What is not given stays as the scene has it. Nothing here turns on what a scene does not use.
#pragma once

#include <optional>

namespace lentray::parser {

struct MediaSettings {
  std::optional<int> method, intervals;
  std::optional<int> samples;  ///< the least and the most
  std::optional<double> confidence;
};

struct RadiosityOverrides {
  std::optional<int> count;  ///< 1..1600
  std::optional<double> error_bound;
  std::optional<int> nearest_count, recursion_limit;  ///< 1..20
};

struct PhotonOverrides {
  std::optional<int> count;   ///< instead of a spacing too
  std::optional<int> gather;  ///< at most, at a point
};

struct SceneOverrides {
  MediaSettings media;
  RadiosityOverrides radiosity;
  PhotonOverrides photons;
  std::optional<int>
      subsurface_samples;  ///< of light scattered many times, and of light scattered once
  std::optional<int> area_light_samples;  ///< along each axis that has more than one; 1..1000
  /// Of area lights: halvings of the grid before corners that are alike end it; -1: all samples.
  std::optional<int> area_light_adaptive;
  std::optional<int> blur_samples;     ///< of scenes with focal blur: the least and the most
  std::optional<int> max_trace_level;  ///< 1..256
  std::optional<double> adc_bailout;
};

}  // namespace lentray::parser
