// Affine transforms of row vectors, p' = p * M, so that statements
// compose from left to right. A transform carries its inverse.
// Source: reference manual 3.7, "Transformations"; matrix order as in `matrix <...>`.
#pragma once

#include <array>

#include "core/base/vec3.h"

namespace lentray::core {

/// Rows 0..2 are the images of x, y, z; row 3 is the translation.
using Matrix = std::array<std::array<double, 3>, 4>;

class Transform {
 public:
  Transform();  ///< identity

  static Transform translation(const Vec3& by);
  static Transform scaling(const Vec3& by);  ///< a component 0 must be replaced by the caller
  /// Degrees about x, then y, then z, left-handed.
  static Transform rotation(const Vec3& degrees);
  /// Radians about an axis (need not be unit; a null axis gives the identity).
  static Transform axis_rotation(const Vec3& axis, double radians);
  /// A singular matrix keeps an identity inverse and is_singular() is true.
  static Transform matrix(const Matrix& rows);

  /// This first, then `next`.
  Transform then(const Transform& next) const;
  Transform inverse() const;

  /// Object -> world.
  Vec3 point(const Vec3& p) const { return applied_point(m_rows, p); }
  /// Directions, without translation.
  Vec3 vector(const Vec3& v) const { return applied_vector(m_rows, v); }
  /// Normals (inverse transpose), not normalised.
  Vec3 normal(const Vec3& n) const { return applied_transposed(m_inverse, n); }
  /// World -> object.
  Vec3 inverse_point(const Vec3& p) const { return applied_point(m_inverse, p); }
  Vec3 inverse_vector(const Vec3& v) const { return applied_vector(m_inverse, v); }
  Vec3 inverse_normal(const Vec3& n) const { return applied_transposed(m_rows, n); }

  bool is_identity() const;
  bool is_singular() const { return m_singular; }
  const Matrix& rows() const { return m_rows; }
  const Matrix& inverse_rows() const { return m_inverse; }

  static Vec3 applied_point(const Matrix& m, const Vec3& p) {
    return {p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
            p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
            p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]};
  }
  static Vec3 applied_vector(const Matrix& m, const Vec3& v) {
    return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0],
            v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
            v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
  }
  static Vec3 applied_transposed(const Matrix& m, const Vec3& n) {
    return {n.x * m[0][0] + n.y * m[0][1] + n.z * m[0][2],
            n.x * m[1][0] + n.y * m[1][1] + n.z * m[1][2],
            n.x * m[2][0] + n.y * m[2][1] + n.z * m[2][2]};
  }

 private:
  Matrix m_rows;
  Matrix m_inverse;
  bool m_singular = false;
};

}  // namespace lentray::core
