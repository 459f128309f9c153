// Shapes and objects without what only spares work, as references: boxes without end, every face of a mesh, each
// part of CSG asked for each crossing. Errors: none. Threads: any.
#pragma once

#include <vector>

#include "core/object/csg.h"
#include "core/object/gated.h"
#include "core/object/leaf.h"
#include "core/shape/outline.h"

namespace lentray::core {

/// Opens the boxes that a shape keeps of its parts. Answers keep their bits; bounds() may become infinite.
struct PlainShapes {
  static void open(Shape& shape);
  static void open(Outline& outline);
};

/// Answers of an object that it does not take itself, but from its shapes: no balls, boxes or hierarchies.
class PlainObject {
 public:
  /// Borrows the object, and opens the boxes of its shapes.
  explicit PlainObject(Object& object);
  void all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
           const RayQuery& query) const;
  bool nearest(const Ray& ray, double t_min, double t_max, Hit& hit, const RayQuery& query) const;
  bool any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const;
  bool inside(const Vec3& p) const;

 private:
  Object& m_object;
};

}  // namespace lentray::core
