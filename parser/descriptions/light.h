// A light_source statement, read. The space is that of the statement: an enclosing object or
// CSG keeps its transform in ObjectDesc::transform and the build step applies it.
// Source: reference manual 3.7, "Light Source"; defaults measured on stock.
#pragma once

#include <optional>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::parser {

/// `photons { ... }` of an object or light.
struct PhotonFlags {
  bool given = false;
  bool target = false;
  double density = 0.0;  ///< of `target`
  std::optional<bool> refraction, reflection;
  bool pass_through = false, collect = true, area_light = false;
};

enum class LightKind { kPoint, kSpot, kCylinder, kShadowless };

struct LightDesc {
  Location where;
  LightKind kind = LightKind::kPoint;
  bool parallel = false;
  core::Vec3 position;
  core::Colour colour;
  core::Vec3 point_at{0.0, 0.0, 1.0};
  double radius = 0.0, falloff = 0.0;  ///< spot: degrees; cylinder: scene units
  double tightness = 0.0;

  bool has_area = false;
  core::Vec3 axis1, axis2;
  int size1 = 0, size2 = 0;
  int adaptive = 100;  ///< stock's value for "not adaptive": never subdivided
  bool has_adaptive = false;
  bool jitter = false, circular = false, orient = false, area_illumination = false;

  double fade_distance = 0.0, fade_power = 0.0;
  bool media_interaction = true, media_attenuation = false;
  Ref<ObjectDesc> looks_like;  ///< already moved to the light; casts no shadow
  Ref<ObjectDesc> projected_through;
  PhotonFlags photons;

  /// One statement `translate` ... inside the block: moves what has been read so far.
  void apply(const core::Transform& t);
};

}  // namespace lentray::parser
