#include "core/object/object.h"

#include <algorithm>

#include "core/object/csg.h"
#include "core/object/gated.h"
#include "core/object/leaf.h"

namespace lentray::core {

bool Object::passes_clips(const Vec3& p) const {
  for (const auto& clip : clips()) {
    if (!clip->inside(p)) return false;
  }
  return true;
}

Bounds Object::within_clips(Bounds b) const {
  if (clips().empty()) return b;
  for (const auto& clip : clips()) b.intersect(clip->solid_bounds());
  return b.is_empty() ? Bounds() : b;
}

Ball Object::within_clips(Ball ball) const {
  for (const auto& clip : clips()) ball = smaller(ball, clip->solid_ball());
  return ball;
}

bool is_seen_afar(const Object& object) {
  const auto is_one = [](const Leaf* leaf) {
    return leaf->transform() || leaf->shape().traits().is_seen_afar;
  };
  if (const auto* leaf = dynamic_cast<const Leaf*>(&object)) return is_one(leaf);
  std::vector<const Leaf*> leaves;
  object.leaves(leaves);
  return std::ranges::any_of(leaves, is_one);
}

void complete(Object& object) {
  if (dynamic_cast<const Leaf*>(&object)) return;
  if (const auto* gated = dynamic_cast<const Gated*>(&object)) return complete(gated->content());
  if (auto* csg = dynamic_cast<Csg*>(&object)) {
    for (const auto& child : csg->children()) complete(*child);
    csg->build_search();
  }
}

}  // namespace lentray::core
