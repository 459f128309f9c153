#include "parser/shapes/blob_fields.h"

#include <cmath>

#include "core/numeric/bounds_help.h"

namespace lentray::parser {
namespace {

/// z turned into that direction, from that point on.
core::Transform along(const Vec3& from, const Vec3& direction) {
  const Vec3 z = normalized(direction);
  Vec3 x, y;
  core::make_frame(z, x, y);
  return core::Transform::matrix(
      {{{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}, {from.x, from.y, from.z}}});
}

}  // namespace

std::vector<core::BlobField> blob_fields(const BlobShape& blob) {
  std::vector<core::BlobField> fields;
  for (const BlobElement& e : blob.elements) {
    core::BlobField field;
    field.radius = std::fabs(e.radius);
    field.strength = e.strength;
    const Vec3 axis = e.b - e.a;
    if (e.kind == BlobElement::Kind::kCylinder && length(axis) > 0.0) {
      field.length = length(axis);
      field.to_blob = along(e.a, axis);
    } else {
      field.to_blob = core::Transform::translation(e.a);
    }
    field.to_blob = field.to_blob.then(e.transform);
    fields.push_back(field);
  }
  return fields;
}

}  // namespace lentray::parser
