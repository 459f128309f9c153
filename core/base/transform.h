// Affine transforms as POV-Ray writes them: row vectors, p' = p * M, so that statements
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
  /// Degrees about x, then y, then z, left-handed as POV-Ray has it.
  static Transform rotation(const Vec3& degrees);
  /// Radians about an axis (need not be unit; a null axis gives the identity).
  static Transform axis_rotation(const Vec3& axis, double radians);
  /// A singular matrix keeps an identity inverse and is_singular() is true.
  static Transform matrix(const Matrix& rows);

  /// This first, then `next`.
  Transform then(const Transform& next) const;
  Transform inverse() const;

  Vec3 point(const Vec3& p) const;              ///< object -> world
  Vec3 vector(const Vec3& v) const;             ///< directions, without translation
  Vec3 normal(const Vec3& n) const;             ///< normals (inverse transpose), not normalised
  Vec3 inverse_point(const Vec3& p) const;      ///< world -> object
  Vec3 inverse_vector(const Vec3& v) const;
  Vec3 inverse_normal(const Vec3& n) const;

  bool is_identity() const;
  bool is_singular() const { return m_singular; }
  const Matrix& rows() const { return m_rows; }
  const Matrix& inverse_rows() const { return m_inverse; }

 private:
  Matrix m_rows;
  Matrix m_inverse;
  bool m_singular = false;
};

}  // namespace lentray::core
