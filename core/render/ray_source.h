// Where camera rays come from; camera/ implements it. Immutable, any number of threads.
#pragma once

#include "core/base/ray.h"

namespace lentray::core {

class RaySource {
 public:
  virtual ~RaySource() = default;
  /// Ray through a place of the image in pixels: the centre of pixel (i, k) is (i + 0.5, k + 0.5),
  /// row 0 on top. World space; the direction is unit unless the camera documents otherwise.
  /// False: the pixel shows nothing and is black.
  virtual bool ray(double column, double row, Ray& ray) const = 0;
};

}  // namespace lentray::core
