#include "parser/descriptions/pattern.h"

namespace lentray::parser {

const char* pattern_name(PatternKind kind) {
  switch (kind) {
#define LENTRAY_PATTERN(kind, words) \
  case PatternKind::kind:            \
    return words;
#include "parser/descriptions/patterns.def"
#undef LENTRAY_PATTERN
  }
  return "";
}

core::Turbulence& PatternDesc::classic_turbulence() {
  if (placement.empty() || placement.front().kind != WarpDesc::Kind::kClassicTurbulence) {
    WarpDesc warp;
    warp.kind = WarpDesc::Kind::kClassicTurbulence;
    placement.insert(placement.begin(), warp);
  }
  return placement.front().own.edit().turbulence;
}

void PatternDesc::transform(const core::Transform& by) {
  if (!placement.empty() && placement.back().kind == WarpDesc::Kind::kTransform) {
    core::Transform& last = placement.back().transform.edit();
    last = last.then(by);
    return;
  }
  WarpDesc warp;
  warp.transform = by;
  placement.push_back(warp);
}

}  // namespace lentray::parser
