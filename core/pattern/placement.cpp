#include "core/pattern/placement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/base/tiny.h"
#include "core/base/whole.h"

namespace lentray::core {
namespace {

constexpr double kFarthest = 1e17;  ///< coordinates beyond are clamped
constexpr double kTwoPi = 2.0 * std::numbers::pi;

class TransformWarp final : public Warp {
 public:
  explicit TransformWarp(const Transform& transform) : m_transform(transform) {}
  Vec3 inwards(const Vec3& point, const SurfaceContext&) const override {
    return m_transform.inverse_point(point);
  }
  const Transform* transform() const override { return &m_transform; }

 private:
  Transform m_transform;
};

/// The warp that leads a point to formula(point, surface).
template <class Formula>
WarpPtr warp_of(Formula formula) {
  class Made final : public Warp {
   public:
    explicit Made(Formula f) : m_formula(std::move(f)) {}
    Vec3 inwards(const Vec3& point, const SurfaceContext& surface) const override {
      return m_formula(point, surface);
    }

   private:
    Formula m_formula;
  };
  return std::make_shared<Made>(std::move(formula));
}

Vec3 centre_near(const BlackHole& hole, const Vec3& point) {
  Vec3 centre = hole.centre;
  if (!hole.repeats) return centre;
  int block[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    if (hole.repeat[axis] < kTiny) continue;
    block[axis] = whole_of(std::floor(point[axis] / hole.repeat[axis]));
  }
  if (hole.uncertain) {
    const Vec3 random = cell_randoms(block[0], block[1], block[2]);
    for (int axis = 0; axis < 3; ++axis) centre[axis] += random[axis] * hole.uncertainty[axis];
  }
  for (int axis = 0; axis < 3; ++axis) centre[axis] += hole.repeat[axis] * block[axis];
  return centre;
}

/// Mapping warps unroll a shape onto the plane z = distance; an orientation puts that plane across
/// another axis.
Vec3 oriented(const Vec3& q, const Vec3& o) {
  if (o == Vec3{0, 0, 1}) return q;
  return {o.x * q.z + o.y * q.x + o.z * q.x, o.x * q.y - o.y * q.z + o.z * q.y,
          -o.x * q.x + o.y * q.y + o.z * q.z};
}

/// Angle about the y axis from +x towards +z, in turns 0..1; `across` = sqrt(x^2 + z^2) > 0.
double turn_about_y(double x, double z, double across) {
  if (z == 0.0) return x > 0.0 ? 0.0 : 0.5;
  const double angle = std::acos(x / across);
  return (z < 0.0 ? kTwoPi - angle : angle) / kTwoPi;
}

double distance_factor(double distance, double exponent) {
  if (exponent == 0.0) return 1.0;
  return exponent == 1.0 ? distance : std::pow(distance, exponent);
}

}  // namespace

WarpPtr make_transform_warp(const Transform& transform) {
  return std::make_shared<TransformWarp>(transform);
}
WarpPtr make_turbulence_warp(const Turbulence& turbulence) {
  return warp_of([turbulence](const Vec3& point, const SurfaceContext&) {
    return point + scaled(vector_turbulence(point, turbulence), turbulence.amount);
  });
}
WarpPtr make_repeat_warp(int axis, double width, const Vec3& flip, const Vec3& offset) {
  return warp_of([axis, width, flip, offset](Vec3 p, const SurfaceContext&) {
    // Counted in single precision: it shows far from the origin.
    const auto block = static_cast<float>(std::floor(p[axis] / width));
    p[axis] -= block * width;
    if (static_cast<std::int64_t>(block) & 1) {
      p = scaled(p, flip);
      if (flip[axis] < 0.0) p[axis] += width;
    }
    return p + offset * static_cast<double>(block);
  });
}
WarpPtr make_black_hole_warp(const BlackHole& hole) {
  return warp_of([hole](const Vec3& point, const SurfaceContext&) {
    const Vec3 offset = point - centre_near(hole, point);
    const double distance = length(offset);
    if (distance >= hole.radius) return point;
    const double depth = (hole.radius - distance) / hole.radius;
    const double pull = std::min(std::pow(depth, hole.power) * hole.strength, 1.0);
    return point + offset * (hole.inverse ? -pull : pull);
  });
}
WarpPtr make_cylindrical_warp(const Vec3& orientation, double distance_exponent) {
  return warp_of([orientation, distance_exponent](const Vec3& p, const SurfaceContext&) {
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    if (across == 0.0) return p;
    const double turn = turn_about_y(p.x, p.z, across) * distance_factor(across, distance_exponent);
    return oriented({turn, p.y, across}, orientation);
  });
}
WarpPtr make_spherical_warp(const Vec3& orientation, double distance_exponent) {
  return warp_of([orientation, distance_exponent](const Vec3& p, const SurfaceContext&) {
    const double distance = length(p);
    if (distance == 0.0) return p;
    const Vec3 unit = p / distance;
    const double across = std::sqrt(unit.x * unit.x + unit.z * unit.z);
    const double turn = across == 0.0 ? 0.0 : turn_about_y(unit.x, unit.z, across);
    const double height = 0.5 + std::asin(std::clamp(unit.y, -1.0, 1.0)) / std::numbers::pi;
    const double factor = distance_factor(distance, distance_exponent);
    return oriented({turn * factor, height * factor, distance}, orientation);
  });
}
WarpPtr make_toroidal_warp(const Vec3& orientation, double distance_exponent, double major_radius) {
  return warp_of(
      [orientation, distance_exponent, major_radius](const Vec3& p, const SurfaceContext&) {
        const double across = std::sqrt(p.x * p.x + p.z * p.z);
        if (across == 0.0) return p;
        const double turn = turn_about_y(p.x, p.z, across);
        const double x = across - major_radius;
        const double distance = std::sqrt(x * x + p.y * p.y);
        double around = std::acos(-x / distance);
        if (p.y > 0.0) around = kTwoPi - around;
        const double factor = distance_factor(distance, distance_exponent);
        return oriented({turn * factor, around / kTwoPi * factor, distance}, orientation);
      });
}
WarpPtr make_planar_warp(const Vec3& orientation, double offset) {
  return warp_of([orientation, offset](const Vec3& p, const SurfaceContext&) {
    return oriented({p.x, p.y, offset}, orientation);
  });
}

/// The faces of a cube, unfolded as a cross in the unit square.
WarpPtr make_cubic_warp() {
  return warp_of([](const Vec3& p, const SurfaceContext&) -> Vec3 {
    const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
    const auto place = [](double s) { return (s + 1.0) / 2.0; };
    constexpr double third = 1.0 / 3.0;
    if (p.x >= 0 && p.x >= ay && p.x >= az) {
      return {0.75 - 0.25 * place(p.z / p.x), third + third * place(p.y / p.x), p.x};
    }
    if (p.y >= 0 && p.y >= ax && p.y >= az) {
      return {0.25 + 0.25 * place(p.x / p.y), 1.0 - third * place(p.z / p.y), p.y};
    }
    if (p.z >= 0 && p.z >= ax && p.z >= ay) {
      return {0.25 + 0.25 * place(p.x / p.z), third + third * place(p.y / p.z), p.z};
    }
    if (p.x < 0 && ax >= ay && ax >= az) {
      return {0.25 * place(p.z / ax), third + third * place(p.y / ax), ax};
    }
    if (p.y < 0 && ay >= ax && ay >= az) {
      return {0.25 + 0.25 * place(p.x / ay), third * place(p.z / ay), ay};
    }
    return {1.0 - 0.25 * place(p.x / az), third + third * place(p.y / az), az};
  });
}

Placement::Placement(std::vector<WarpPtr> steps) : m_steps(std::move(steps)) {
  if (m_steps.empty()) return;
  const bool affine = std::all_of(m_steps.begin(), m_steps.end(),
                                  [](const WarpPtr& step) { return step->transform() != nullptr; });
  if (!affine) {
    m_kind = Kind::kGeneral;
    return;
  }
  // The outermost step is applied last by the text: matrices multiply from the pattern outwards.
  Transform whole;
  for (const WarpPtr& step : m_steps) whole = step->transform()->then(whole);
  m_matrix = whole.inverse_rows();
  m_kind = whole.is_identity() ? Kind::kNone : Kind::kAffine;
}

Placement Placement::then(const Placement& inner) const {
  std::vector<WarpPtr> steps = m_steps;
  steps.insert(steps.end(), inner.m_steps.begin(), inner.m_steps.end());
  return Placement(std::move(steps));
}

Vec3 Placement::general(const Vec3& point, const SurfaceContext& surface) const {
  Vec3 p = point;
  for (const WarpPtr& step : m_steps) p = step->inwards(p, surface);
  for (int axis = 0; axis < 3; ++axis) p[axis] = std::clamp(p[axis], -kFarthest, kFarthest);
  return p;
}

Vec3 Placement::normal_inwards(const Vec3& normal) const {
  Vec3 n = normal;
  for (const WarpPtr& step : m_steps) {
    if (const Transform* transform = step->transform()) n = transform->inverse_normal(n);
  }
  return n;
}

Vec3 Placement::normal_outwards(const Vec3& normal) const {
  Vec3 n = normal;
  for (auto step = m_steps.rbegin(); step != m_steps.rend(); ++step) {
    if (const Transform* transform = (*step)->transform()) n = transform->normal(n);
  }
  return n;
}

}  // namespace lentray::core
