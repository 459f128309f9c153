#include "parser/descriptions/pattern.h"

namespace lentray::parser {

const char* pattern_name(PatternKind kind) {
  static constexpr const char* kNames[] = {
      "color",     "agate",         "aoi",           "average",         "bozo",
      "boxed",     "brick",         "bumps",         "cells",           "checker",
      "crackle",   "cubic",         "cylindrical",   "density_file",    "dents",
      "facets",    "function",      "gradient",      "granite",         "hexagon",
      "image_map", "image_pattern", "bump_map",      "material_map",    "leopard",
      "mandel",    "julia",         "magnet mandel", "magnet julia",    "marble",
      "object",    "onion",         "pavement",      "pigment_pattern", "planar",
      "potential", "proximity",     "quilted",       "radial",          "ripples",
      "slope",     "spherical",     "spiral1",       "spiral2",         "spotted",
      "square",    "tiles",         "tiling",        "triangular",      "uv_mapping",
      "waves",     "wood",          "wrinkles"};
  return kNames[static_cast<int>(kind)];
}

TurbulenceDesc& PatternDesc::classic_turbulence() {
  if (placement.empty() || placement.front().kind != WarpDesc::Kind::kClassicTurbulence) {
    WarpDesc warp;
    warp.kind = WarpDesc::Kind::kClassicTurbulence;
    placement.insert(placement.begin(), warp);
  }
  return placement.front().turbulence;
}

void PatternDesc::transform(const core::Transform& by) {
  if (!placement.empty() && placement.back().kind == WarpDesc::Kind::kTransform) {
    placement.back().transform = placement.back().transform.then(by);
    return;
  }
  WarpDesc warp;
  warp.transform = by;
  placement.push_back(warp);
}

}  // namespace lentray::parser
