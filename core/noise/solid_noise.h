// Perlin's noise, of generator 3, before it is brought into range. Any thread: each keeps the cells it
// asked for lately.
#pragma once

#include "core/noise/noise.h"

namespace lentray::core {

double solid_noise(double x, double y, double z);
/// The same at two points, in less time than one after the other.
NoisePair solid_noise(NoisePair x, NoisePair y, NoisePair z);

}  // namespace lentray::core
