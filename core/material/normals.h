// The kinds of normal perturbation: displacements of their own, slopes of a pattern, and maps.
// Source: reference manual 3.7, "Normal", "Slope Maps", "Normal Maps"; compared with stock by
// tests/image/normals_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/material/blend_map.h"
#include "core/material/normal.h"
#include "core/material/placed_pattern.h"

namespace lentray::core {

using NormalPtr = std::shared_ptr<const NormalPerturbation>;

/// Adds a vector to a normal, in pattern space.
class Displacement {
 public:
  virtual ~Displacement() = default;
  virtual Vec3 displaced(const Vec3& point, const Vec3& normal) const = 0;
};
using DisplacementPtr = std::unique_ptr<const Displacement>;

DisplacementPtr make_bumps_displacement(double amount);
DisplacementPtr make_dents_displacement(double amount, int generator);
DisplacementPtr make_wrinkles_displacement(double amount);
DisplacementPtr make_ripples_displacement(double amount, int sources, double frequency,
                                          double phase);
DisplacementPtr make_waves_displacement(double amount, int sources, double frequency, double phase);
DisplacementPtr make_quilted_displacement(double amount, double control0, double control1);
/// coords 0: facets by the normal, of a size; else by the point.
DisplacementPtr make_facets_displacement(double size, double coords, double metric);

/// `keep_scale` is no_bump_scale: the transforms' scale then changes the apparent depth.
NormalPtr make_displaced_normal(Placement placement, DisplacementPtr displacement, bool keep_scale);
/// The slope of a pattern, from samples `accuracy` away.
NormalPtr make_slope_normal(PlacedPattern pattern, double amount, double accuracy,
                            std::optional<BlendMap<SlopePoint>> slopes, bool keep_scale);
/// Null entries leave the normal as it is.
NormalPtr make_normal_map(PlacedPattern pattern, BlendMap<NormalPtr> map, bool keep_scale);
NormalPtr make_average_normal(Placement placement, BlendMap<NormalPtr> map, bool keep_scale);
/// A perturbation inside the space of a texture map's pattern.
NormalPtr make_placed_normal(Placement placement, NormalPtr normal, bool keep_scale);

}  // namespace lentray::core
