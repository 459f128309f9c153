#include "core/geometry/bicubic_patch.h"

#include <algorithm>
#include <optional>

namespace lentray::core {
namespace {

/// Bernstein polynomials of order 3 and their derivatives.
struct Weights {
  std::array<double, 4> value, slope;
  explicit Weights(double s) {
    const double r = 1.0 - s;
    value = {r * r * r, 3.0 * s * r * r, 3.0 * s * s * r, s * s * s};
    slope = {-3.0 * r * r, 3.0 * r * (r - 2.0 * s), 3.0 * s * (2.0 * r - s), 3.0 * s * s};
  }
};

/// Stock's where the slopes give none.
Vec3 corner_normal(const Vec3& by_u, const Vec3& by_v) {
  constexpr double kFlat = 1e-10;
  const Vec3 n = cross(by_u, by_v);
  const bool known = length_squared(n) > kFlat * length_squared(by_u) * length_squared(by_v);
  return known ? normalized(n) : Vec3{1, 0, 0};
}

}  // namespace

BicubicPatch::BicubicPatch(const std::array<Vec3, 16>& points, int u_steps, int v_steps)
    : m_points(points) {
  constexpr int kMostSteps = 8;
  const auto rows = std::uint32_t{1} << std::clamp(u_steps, 0, kMostSteps);
  const auto columns = std::uint32_t{1} << std::clamp(v_steps, 0, kMostSteps);
  MeshData data;
  for (std::uint32_t i = 0; i <= rows; ++i) {
    for (std::uint32_t j = 0; j <= columns; ++j) {
      const double u = static_cast<double>(i) / rows, v = static_cast<double>(j) / columns;
      Vec3 place, by_u, by_v;
      evaluate(u, v, place, by_u, by_v);
      data.vertices.push_back(place);
      data.normals.push_back(corner_normal(by_u, by_v));
      data.uvs.push_back({u, v});
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    MeshFace face{};
    face.vertex = face.normal = face.uv = {a, b, c};
    data.faces.push_back(face);
  };
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const std::uint32_t a = i * (columns + 1) + j, b = a + 1, d = a + columns + 1, c = d + 1;
      add(a, b, c);
      add(a, c, d);
    }
  }
  m_net = std::make_unique<Mesh>(std::make_shared<const TriangleMesh>(std::move(data)),
                                 std::nullopt, true);
}

void BicubicPatch::evaluate(double u, double v, Vec3& place, Vec3& by_u, Vec3& by_v) const {
  const Weights across(u), along(v);
  place = by_u = by_v = Vec3{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const Vec3& p = m_points[4 * i + j];
      place += p * (across.value[i] * along.value[j]);
      by_u += p * (across.slope[i] * along.value[j]);
      by_v += p * (across.value[i] * along.slope[j]);
    }
  }
}

Vec2 BicubicPatch::uv(const Vec3& p, const ShapeHit& hit) const {
  const Vec2 at = m_net->uv(p, hit);
  return {at.v, at.u};
}

}  // namespace lentray::core
