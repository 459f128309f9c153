#include "core/base/transform.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lentray::core {
namespace {

constexpr Matrix kIdentity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix r;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      r[i][j] =
          a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + (i == 3 ? b[3][j] : 0.0);
    }
  }
  return r;
}

/// All numbers without a branch: most that are asked are the identity.
bool is_identity_matrix(const Matrix& m) {
  static_assert(sizeof(Matrix) == 12 * sizeof(double));
  const double* const a = m[0].data();
  const double* const b = kIdentity[0].data();
  std::uint64_t differ = 0;  // all bits but the sign are 0 where two numbers are equal
  for (int i = 0; i < 12; ++i) differ |= std::bit_cast<std::uint64_t>(a[i] - b[i]) << 1;
  return differ == 0;
}

/// The same numbers as the product with the identity, which has no negative zeros.
Matrix times_identity(Matrix m) {
  for (auto& row : m) {
    for (double& x : row) x += 0.0;
  }
  return m;
}

bool invert(const Matrix& m, Matrix& out) {
  const Vec3 a{m[0][0], m[0][1], m[0][2]}, b{m[1][0], m[1][1], m[1][2]},
      c{m[2][0], m[2][1], m[2][2]};
  const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double det = dot(a, bc);
  if (det == 0.0 || !std::isfinite(1.0 / det)) return false;
  const double s = 1.0 / det;
  for (int i = 0; i < 3; ++i) {
    out[i] = {bc[i] * s, ca[i] * s, ab[i] * s};
  }
  const Vec3 t = Transform::applied_vector(out, {m[3][0], m[3][1], m[3][2]});
  out[3] = {-t.x, -t.y, -t.z};
  return true;
}

}  // namespace

Transform::Transform() : m_rows(kIdentity), m_inverse(kIdentity) {}

Transform Transform::translation(const Vec3& by) {
  Transform t;
  t.m_rows[3] = {by.x, by.y, by.z};
  t.m_inverse[3] = {-by.x, -by.y, -by.z};
  return t;
}

Transform Transform::scaling(const Vec3& by) {
  Transform t;
  for (int i = 0; i < 3; ++i) {
    t.m_rows[i][i] = by[i];
    t.m_inverse[i][i] = 1.0 / by[i];
  }
  return t;
}

Transform Transform::rotation(const Vec3& degrees) {
  constexpr double rad = std::numbers::pi / 180.0;
  Transform t;
  for (int axis = 0; axis < 3; ++axis) {
    if (degrees[axis] == 0.0) continue;
    const double c = std::cos(degrees[axis] * rad), s = std::sin(degrees[axis] * rad);
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    Transform one;
    one.m_rows[j][j] = c;
    one.m_rows[j][k] = s;
    one.m_rows[k][j] = -s;
    one.m_rows[k][k] = c;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) one.m_inverse[a][b] = one.m_rows[b][a];
    }
    t = t.then(one);
  }
  return t;
}

Transform Transform::axis_rotation(const Vec3& axis, double radians) {
  const Vec3 a = normalized(axis);
  Transform t;
  if (a == Vec3{}) return t;
  const double c = std::cos(radians), s = std::sin(radians);
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, last = (i + 2) % 3;
    // The order of operations is fixed: scenes see the last bit.
    t.m_rows[i][i] = a[i] * a[i] + c * (1.0 - a[i] * a[i]);
    t.m_rows[i][next] = a[i] * a[next] * (1.0 - c) + a[last] * s;
    t.m_rows[i][last] = a[i] * a[last] * (1.0 - c) - a[next] * s;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t.m_inverse[j][i] = t.m_rows[i][j];
  }
  return t;
}

Transform Transform::matrix(const Matrix& rows) {
  Transform t;
  t.m_rows = rows;
  t.m_singular = !invert(rows, t.m_inverse);
  if (t.m_singular) t.m_inverse = kIdentity;
  return t;
}

Transform Transform::then(const Transform& next) const {
  Transform t;
  if (is_identity_matrix(m_rows) && is_identity_matrix(m_inverse)) {
    t.m_rows = times_identity(next.m_rows);
    t.m_inverse = times_identity(next.m_inverse);
  } else {
    t.m_rows = product(m_rows, next.m_rows);
    t.m_inverse = product(next.m_inverse, m_inverse);
  }
  t.m_singular = m_singular || next.m_singular;
  return t;
}

Transform Transform::inverse() const {
  Transform t;
  t.m_rows = m_inverse;
  t.m_inverse = m_rows;
  t.m_singular = m_singular;
  return t;
}

bool Transform::is_identity() const { return is_identity_matrix(m_rows); }

}  // namespace lentray::core
