// Where a pattern lies: transforms, turbulence and warps between a point and the pattern's space.
// Immutable. The plain cases (nothing, one affine transform) cost no virtual call.
// Source: reference manual 3.7, "Transforming Textures and Patterns", "Warps".
#pragma once

#include <memory>
#include <vector>

#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "core/noise/noise.h"
#include "core/pattern/surface_context.h"

namespace lentray::core {

/// One step from the outer space towards the pattern's.
class Warp {
 public:
  virtual ~Warp() = default;
  virtual Vec3 inwards(const Vec3& point, const SurfaceContext& surface) const = 0;
  /// Set for transforms: normals follow these, and no other warp.
  virtual const Transform* transform() const { return nullptr; }
};
using WarpPtr = std::shared_ptr<const Warp>;

WarpPtr make_transform_warp(const Transform& transform);
WarpPtr make_turbulence_warp(const Turbulence& turbulence);
/// Copies of a slab of `width` along an axis; flip components are 1 or -1.
WarpPtr make_repeat_warp(int axis, double width, const Vec3& flip, const Vec3& offset);
struct BlackHole {
  Vec3 centre, repeat, uncertainty;
  double radius = 1.0, strength = 1.0, power = 2.0;
  bool inverse = false, repeats = false, uncertain = false;
};
WarpPtr make_black_hole_warp(const BlackHole& hole);
WarpPtr make_cylindrical_warp(const Vec3& orientation, double distance_exponent);
WarpPtr make_spherical_warp(const Vec3& orientation, double distance_exponent);
WarpPtr make_toroidal_warp(const Vec3& orientation, double distance_exponent, double major_radius);
WarpPtr make_planar_warp(const Vec3& orientation, double offset);
WarpPtr make_cubic_warp();

class Placement {
 public:
  Placement() = default;
  /// The step applied first is first.
  explicit Placement(std::vector<WarpPtr> steps);

  /// This, then `inner`: for patterns inside a pattern's map.
  Placement then(const Placement& inner) const;

  Vec3 inwards(const Vec3& point, const SurfaceContext& surface = kNoSurface) const {
    if (m_kind == Kind::kNone) return point;
    if (m_kind == Kind::kAffine) return affine(point);
    return general(point, surface);
  }
  /// A normal, not normalised, into the pattern's space and back; only transforms count.
  Vec3 normal_inwards(const Vec3& normal) const;
  Vec3 normal_outwards(const Vec3& normal) const;
  bool is_none() const { return m_kind == Kind::kNone; }

 private:
  enum class Kind { kNone, kAffine, kGeneral };
  Vec3 affine(const Vec3& p) const {
    const Matrix& m = m_matrix;
    return {p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
            p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
            p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]};
  }
  Vec3 general(const Vec3& point, const SurfaceContext& surface) const;

  Kind m_kind = Kind::kNone;
  Matrix m_matrix{};  ///< inverse, when affine
  std::vector<WarpPtr> m_steps;
};

}  // namespace lentray::core
