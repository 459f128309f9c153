#include "core/shape/quadric.h"

#include "core/numeric/bounds_help.h"
#include "core/numeric/roots.h"

namespace lentray::core {

Quadric::Quadric(const Vec3& squares, const Vec3& products, const Vec3& linear, double constant)
    : m_sq(squares), m_mix(products), m_lin(linear), m_const(constant) {
  find_bounds();
}

Quadric::Quadric(const std::array<double, 10>& c)
    : Quadric({c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}, c[9]) {}

double Quadric::value(const Vec3& p) const {
  return p.x * (m_sq.x * p.x + m_mix.x * p.y + m_lin.x) +
         p.y * (m_sq.y * p.y + m_mix.z * p.z + m_lin.y) +
         p.z * (m_sq.z * p.z + m_mix.y * p.x + m_lin.z) + m_const;
}

bool Quadric::holds(const Vec3& p, bool inverse) const {
  const double at = value(p - m_origin);
  return inverse ? at >= 0.0 : at <= 0.0;
}

Vec3 Quadric::normal(const Vec3& p, const ShapeHit&) const { return gradient(p - m_origin); }

Vec3 Quadric::gradient(const Vec3& p) const {
  return {2.0 * m_sq.x * p.x + m_mix.x * p.y + m_mix.y * p.z + m_lin.x,
          m_mix.x * p.x + 2.0 * m_sq.y * p.y + m_mix.z * p.z + m_lin.y,
          m_mix.y * p.x + m_mix.z * p.y + 2.0 * m_sq.z * p.z + m_lin.z};
}

/// The crossings of the whole line, ascending.
int Quadric::crossings(const Ray& ray, double, double, bool, double* out) const {
  const Vec3& d = ray.direction;
  const double a = d.x * (m_sq.x * d.x + m_mix.x * d.y) + d.y * (m_sq.y * d.y + m_mix.z * d.z) +
                   d.z * (m_sq.z * d.z + m_mix.y * d.x);
  const Vec3 o = ray.origin - m_origin;
  const double b = dot(gradient(o), d);
  const double c = value(o);
  if (a == 0.0 || !(b * b - 4.0 * a * c < 0.25 * (b * b))) return solve_quadratic(a, b, c, out);
  // The roots are close to each other seen from here, or there is none: decide it at the point
  // midway between them, where the terms are small.
  const double middle = -0.5 * b / a;
  const double h = -value(o + d * middle) / a;
  if (!(h >= 0.0)) return 0;
  const double half = std::sqrt(h);
  out[0] = middle - half;
  out[1] = middle + half;
  return 2;
}

/// Ellipsoids exactly. Without mixed terms also what is bounded along some axes: where all
/// squares have one sign and the other axes do not occur, or one of them only linearly.
void Quadric::find_bounds() {
  m_bounds = Bounds::everything();
  const double xx = m_sq.x, yy = m_sq.y, zz = m_sq.z;
  const double xy = 0.5 * m_mix.x, xz = 0.5 * m_mix.y, yz = 0.5 * m_mix.z;
  // Cofactors of the symmetric matrix of the squares: its inverse times the determinant.
  const double cx = yy * zz - yz * yz, cy = xx * zz - xz * xz, cz = xx * yy - xy * xy;
  const double det = xx * cx - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double size = std::max({std::fabs(xx), std::fabs(yy), std::fabs(zz)});
  const bool positive = xx > 0.0, definite = xx != 0.0 && cz > 1e-12 * size * size &&
                                             (positive ? det : -det) > 1e-12 * size * size * size;
  if (definite) {
    const Vec3 half = m_lin * -0.5;
    const double ixy = xz * yz - xy * zz, ixz = xy * yz - xz * yy, iyz = xy * xz - xx * yz;
    const Vec3 centre{(cx * half.x + ixy * half.y + ixz * half.z) / det,
                      (ixy * half.x + cy * half.y + iyz * half.z) / det,
                      (ixz * half.x + iyz * half.y + cz * half.z) / det};
    const double level = -value(centre);
    m_solid_unbounded = !positive;
    const double r = positive ? level : -level;
    if (r < 0.0) {
      m_bounds = Bounds();  // no surface
      return;
    }
    const Vec3 e{std::sqrt(level * cx / det), std::sqrt(level * cy / det),
                 std::sqrt(level * cz / det)};
    m_bounds = padded({centre - e * (1.0 + 1e-12), centre + e * (1.0 + 1e-12)});
    return;
  }
  if (m_mix != Vec3{} || size == 0.0) return;
  double sign = 0.0, level = -m_const;
  int linear = -1;
  for (int i = 0; i < 3; ++i) {
    if (m_sq[i] == 0.0) {
      if (m_lin[i] == 0.0) continue;
      if (linear >= 0) return;
      linear = i;
      continue;
    }
    if (sign != 0.0 && (m_sq[i] > 0.0) != (sign > 0.0)) return;
    sign = m_sq[i] > 0.0 ? 1.0 : -1.0;
    level += m_lin[i] * m_lin[i] / (4.0 * m_sq[i]);
  }
  m_solid_unbounded = sign < 0.0;
  constexpr double kWider = 1e-12;
  if (linear >= 0) {
    // sum of sq (x - c)^2 = level - lin * x: its left side has the sign of the squares.
    const double end = level / m_lin[linear];
    const double pad = kWider * std::fabs(end) + 1e-300;
    ((m_lin[linear] > 0.0) == (sign > 0.0) ? m_bounds.hi : m_bounds.lo)[linear] =
        (m_lin[linear] > 0.0) == (sign > 0.0) ? end + pad : end - pad;
    return;
  }
  if (level * sign < 0.0) {
    m_bounds = Bounds();
    return;
  }
  for (int i = 0; i < 3; ++i) {
    if (m_sq[i] == 0.0) continue;
    const double centre = -m_lin[i] / (2.0 * m_sq[i]);
    const double reach = std::sqrt(level / m_sq[i]) * (1.0 + kWider) + kWider * std::fabs(centre);
    m_bounds.lo[i] = centre - reach;
    m_bounds.hi[i] = centre + reach;
  }
}

std::unique_ptr<Shape> Quadric::baked(const Transform& t) const {
  // q'(p) = q(p M) with M the inverse of the linear part; the translation moves the origin.
  const double q[3][3] = {{m_sq.x, 0.5 * m_mix.x, 0.5 * m_mix.y},
                          {0.5 * m_mix.x, m_sq.y, 0.5 * m_mix.z},
                          {0.5 * m_mix.y, 0.5 * m_mix.z, m_sq.z}};
  const Matrix& m = t.inverse_rows();
  double r[3][3];
  Vec3 linear;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 row{m[i][0], m[i][1], m[i][2]};
    const Vec3 half{row.x * q[0][0] + row.y * q[1][0] + row.z * q[2][0],
                    row.x * q[0][1] + row.y * q[1][1] + row.z * q[2][1],
                    row.x * q[0][2] + row.y * q[1][2] + row.z * q[2][2]};
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = dot(half, Vec3{m[j][0], m[j][1], m[j][2]});
    linear[static_cast<int>(i)] = dot(row, m_lin);
  }
  auto moved =
      std::make_unique<Quadric>(Vec3{r[0][0], r[1][1], r[2][2]},
                                Vec3{2.0 * r[0][1], 2.0 * r[0][2], 2.0 * r[1][2]}, linear, m_const);
  moved->m_origin = t.point(m_origin);
  if (!moved->m_bounds.is_empty()) {
    moved->m_bounds.lo += moved->m_origin;
    moved->m_bounds.hi += moved->m_origin;
    moved->m_bounds = padded(moved->m_bounds);
  }
  return moved;
}

}  // namespace lentray::core
