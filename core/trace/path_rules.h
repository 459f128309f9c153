// What rays of one use do otherwise than others. Plain values.
#pragma once

namespace lentray::core {

struct PathRules {
  double adc_bailout;
  bool lights = true;       ///< false: no light source lights a surface
  bool highlights = true;   ///< that lights make
  bool area_lights = true;  ///< false: area lights are points
  bool subsurface = true;   ///< false: translucent surfaces are dark
  bool volumes = true;      ///< fog, rainbows and media count
};

}  // namespace lentray::core
