// What matters first of a composed sheet (camera/composition.h): what lies in its plane, how deep it looks, and
// whether anything jumps. One thread.
#pragma once

#include <string>
#include <vector>

#include "camera/composition.h"
#include "camera/lenticular.h"

namespace lentray::camera {

struct CompositionText {
  std::vector<std::string> lines;     ///< three
  std::vector<std::string> warnings;  ///< jumps, and a print that is nearly flat
};

/// `sheet`: the composed one.
CompositionText composition_text(const Lenticular& sheet, const CompositionRequest& asked,
                                 const Composition& composed);

}  // namespace lentray::camera
