// A finish as written. `albedo` is applied when its block ends, as stock does: the numbers here are
// those that shade.
// Source: reference manual 3.7, "Finish".
#pragma once

#include <optional>

#include "core/base/color.h"
#include "parser/source/source.h"

namespace lentray::parser {

inline bool operator==(const Location& a, const Location& b) {
  return a.file == b.file && a.offset == b.offset;
}

struct ReflectionDesc {
  core::Rgb minimum, maximum;
  bool block = false;  ///< reflection { ... }: varies by angle
  bool fresnel = false;
  double falloff = 1.0, metallic = 0.0;
  bool operator==(const ReflectionDesc&) const = default;
};

struct SubsurfaceDesc {
  core::Rgb translucency, anisotropy;
  bool operator==(const SubsurfaceDesc&) const = default;
};

struct FinishDesc {
  Location where;
  core::Rgb ambient{0.1f, 0.1f, 0.1f};
  core::Rgb emission;
  double diffuse = 0.6, diffuse_back = 0.0;
  double albedo_factor = 1.0;   ///< of `diffuse albedo`, in both
  bool diffuse_albedo = false;  ///< only while the block is read; so the two below
  double brilliance = 1.0;
  double phong = 0.0, phong_size = 40.0;
  bool phong_albedo = false;
  double specular = 0.0, roughness = 0.05;
  bool specular_albedo = false;
  double metallic = 0.0;
  ReflectionDesc reflection;
  double reflection_exponent = 1.0;
  bool conserve_energy = false;
  double crand = 0.0;
  double irid = 0.0, irid_thickness = 0.0, irid_turbulence = 0.0;
  std::optional<SubsurfaceDesc> subsurface;
  /// Old scenes give refraction here; they go to the interior of what bears the texture.
  std::optional<double> ior, caustics, refraction;
  bool operator==(const FinishDesc&) const = default;
};

}  // namespace lentray::parser
