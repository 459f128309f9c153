// The sheets that the tests of the paper's model share.
#pragma once

#include "shadow/hit_model/enumeration.h"

namespace lentray::test {

/// Square pixels, the paper's focal length.
inline shadow::PaperSheet sheet_of(double pixels, std::uint32_t lenses, std::uint32_t rows,
                                   double ior = 1.6, double pitch = 1.124) {
  camera::LensParameters lens;
  lens.pixels = pixels;
  lens.ior = ior;
  lens.pitch = pitch;
  return {lens, lenses, rows};
}

}  // namespace lentray::test
