#include "parser/dump/names.h"

namespace lentray::parser {

// Switches without a default: the compiler says which kind has no name yet.

const char* name_of(CameraKind kind) { return camera_kind_name(kind); }
const char* name_of(PatternKind kind) { return pattern_name(kind); }

const char* name_of(LightKind kind) {
  switch (kind) {
    case LightKind::kPoint: return "point";
    case LightKind::kSpot: return "spotlight";
    case LightKind::kCylinder: return "cylinder";
    case LightKind::kShadowless: return "shadowless";
  }
  return "";
}

const char* name_of(WaveForm form) {
  switch (form) {
    case WaveForm::kRamp: return "ramp_wave";
    case WaveForm::kTriangle: return "triangle_wave";
    case WaveForm::kSine: return "sine_wave";
    case WaveForm::kScallop: return "scallop_wave";
    case WaveForm::kCubic: return "cubic_wave";
    case WaveForm::kPoly: return "poly_wave";
  }
  return "";
}

const char* name_of(WarpDesc::Kind kind) {
  switch (kind) {
    case WarpDesc::Kind::kTransform: return "transform";
    case WarpDesc::Kind::kTurbulence: return "warp turbulence";
    case WarpDesc::Kind::kClassicTurbulence: return "turbulence";
    case WarpDesc::Kind::kRepeat: return "repeat";
    case WarpDesc::Kind::kBlackHole: return "black_hole";
    case WarpDesc::Kind::kSpherical: return "spherical";
    case WarpDesc::Kind::kToroidal: return "toroidal";
    case WarpDesc::Kind::kPlanar: return "planar";
    case WarpDesc::Kind::kCylindrical: return "cylindrical";
    case WarpDesc::Kind::kCubic: return "cubic";
  }
  return "";
}

const char* name_of(ImageDesc::Use use) {
  switch (use) {
    case ImageDesc::Use::kDefault: return "default";
    case ImageDesc::Use::kColour: return "use_color";
    case ImageDesc::Use::kIndex: return "use_index";
    case ImageDesc::Use::kAlpha: return "use_alpha";
  }
  return "";
}

const char* name_of(ImageDesc::Decoding decoding) {
  switch (decoding) {
    case ImageDesc::Decoding::kNone: return "none";
    case ImageDesc::Decoding::kMarked: return "marked";
    case ImageDesc::Decoding::kAll: return "all";
  }
  return "";
}

const char* name_of(CsgOperation operation) {
  switch (operation) {
    case CsgOperation::kUnion: return "union";
    case CsgOperation::kMerge: return "merge";
    case CsgOperation::kIntersection: return "intersection";
    case CsgOperation::kDifference: return "difference";
    case CsgOperation::kLightGroup: return "light_group";
  }
  return "";
}

const char* name_of(BlobElement::Kind kind) {
  switch (kind) {
    case BlobElement::Kind::kSphere: return "sphere";
    case BlobElement::Kind::kCylinder: return "cylinder";
  }
  return "";
}

const char* name_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::kLinear: return "linear_spline";
    case CurveKind::kQuadratic: return "quadratic_spline";
    case CurveKind::kCubic: return "cubic_spline";
    case CurveKind::kBezier: return "bezier_spline";
    case CurveKind::kB: return "b_spline";
    case CurveKind::kNatural: return "natural_spline";
  }
  return "";
}

}  // namespace lentray::parser
