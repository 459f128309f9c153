// What may darken something, as all lights of a scene see it: made once, before the lights' buffers.
// World space. Immutable; any number of threads. Borrows the objects.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/accel/light_drawing.h"
#include "core/base/bounds.h"
#include "core/object/leaf.h"

namespace lentray::core {

struct LightCaster {
  const Object* object;
  const Shape* shape;   ///< plain_shape()
  const Plane* plane;   ///< an opaque plane; else null
  Bounds bounds;        ///< not empty
  std::uint32_t place;  ///< as Hit::place
  CasterKind kind;
  bool opaque;
};

class LightCasters {
 public:
  /// Takes their opacity and no_shadow as they are now. In place of their list, where a buffer is wanted.
  LightCasters(const std::vector<std::unique_ptr<Object>>& objects);
  std::size_t size() const { return m_list.size(); }
  auto begin() const { return m_list.begin(); }
  auto end() const { return m_list.end(); }

 private:
  std::vector<LightCaster> m_list;  ///< in the scene's order
};

}  // namespace lentray::core
