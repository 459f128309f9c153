// A bump-mapped normal as written. Source: reference manual 3.7, "Normal".
#pragma once

#include "parser/descriptions/maps.h"
#include "parser/descriptions/pattern.h"

namespace lentray::parser {

struct NormalDesc {
  Location where;
  PatternDesc pattern;
  double amount = 0.5;
  double bump_size = 1.0;
  bool no_bump_scale = false;
  double accuracy = 0.02;  ///< distance of the samples that give the slope
  Ref<SlopeMapDesc> slope_map;
  Ref<NormalMapDesc> normal_map;
};

}  // namespace lentray::parser
