// What a scene asks of subsurface light. Plain values.
// Source: reference manual 3.7, "Subsurface Light Transport"; defaults are those of POV-Ray 3.7.
#pragma once

namespace lentray::core {

/// `subsurface { }` of global_settings.
struct SubsurfaceSettings {
  int samples_diffuse = 50;  ///< of light that is scattered many times; not positive: none of it
  int samples_single = 50;   ///< of light that is scattered once, a channel
  bool radiosity = false;    ///< whether the light of other surfaces is scattered too
};

}  // namespace lentray::core
