// The interiors that rays travel in, as numbers: equal stacks have equal numbers, so that a ray
// carries four bytes. Every object has an interior: without an `interior` statement it is a plain
// one with the ior of the atmosphere, distinguished by the object of the source: parts of a union
// share it. One a thread; no allocation once it has grown.
// Source: reference manual 3.7, "Interior"; the order of nested and overlapping ones is stock's.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/material/interior.h"
#include "core/object/object.h"
#include "core/trace/interiors_id.h"

namespace lentray::core {

struct InteriorEntry {
  std::uintptr_t key;        ///< identity: the interior, or the source's object that has none
  const Interior* interior;  ///< null: plain
  bool hollow;               ///< the air outside goes on in it
  double ior(double atmosphere_ior) const { return interior ? interior->ior : atmosphere_ior; }
  double dispersion() const { return interior ? interior->dispersion : 1.0; }
  int bands() const { return interior ? interior->dispersion_samples : kDefaultBands; }
};

/// The interior of a surface: `attributes` are those of the leaf, `object` is the scene's.
inline InteriorEntry interior_of(const Attributes& attributes, const Object* object) {
  const Interior* own = attributes.interior;
  if (own) return {reinterpret_cast<std::uintptr_t>(own), own, attributes.hollow};
  return {std::uintptr_t{2} * object->whole() + 1, nullptr,
          attributes.hollow};  // no address is odd
}

/// Stacks of interiors, any number deep. Numbers hold until forget_if_large(); references to
/// entries until the next push() or remove().
class InteriorTable {
 public:
  InteriorTable();

  std::size_t size(InteriorsId id) const { return stack(id).size; }
  /// The innermost. Not in the open.
  const InteriorEntry& back(InteriorsId id) const {
    assert(id != InteriorsId::kOpen);
    return stack(id).entry;
  }
  /// All but the innermost. Not in the open.
  InteriorsId around(InteriorsId id) const {
    assert(id != InteriorsId::kOpen);
    return stack(id).around;
  }
  bool contains(InteriorsId id, std::uintptr_t key) const {
    for (; id != InteriorsId::kOpen; id = around(id)) {
      if (back(id).key == key) return true;
    }
    return false;
  }
  /// True in the open, and where all that surrounds the ray is hollow.
  bool is_hollow(InteriorsId id) const { return id == InteriorsId::kOpen || stack(id).hollow; }

  InteriorsId push(InteriorsId id, const InteriorEntry& entry) {
    const InteriorsId latest = stack(id).latest;
    return latest != InteriorsId::kOpen && is_entry(latest, entry) ? latest : find(id, entry);
  }
  /// Without the outermost entry of that key; the same number if there is none.
  InteriorsId remove(InteriorsId id, std::uintptr_t key) {
    if (size(id) == 1) return back(id).key == key ? InteriorsId::kOpen : id;
    return remove_among(id, key);
  }

  /// To be called where no number is in use, between camera rays: true if they count no more, since
  /// there were very many of them.
  bool forget_if_large();

 private:
  struct Stack {
    InteriorEntry entry;
    std::uint32_t size;
    InteriorsId around;
    InteriorsId latest;  ///< that was pushed on this one; kOpen: none
    bool hollow;         ///< all of it
  };
  const Stack& stack(InteriorsId id) const { return m_stacks[static_cast<std::uint32_t>(id)]; }
  bool is_entry(InteriorsId id, const InteriorEntry& entry) const {
    return back(id).key == entry.key && back(id).hollow == entry.hollow;
  }
  InteriorsId remove_among(InteriorsId id, std::uintptr_t key);
  InteriorsId find(InteriorsId id, const InteriorEntry& entry);
  InteriorsId& slot(InteriorsId id, const InteriorEntry& entry);
  void clear();
  void grow_slots();

  std::vector<Stack> m_stacks;       ///< the first is the open
  std::vector<InteriorsId> m_slots;  ///< where a stack is found; kOpen: free
  std::vector<InteriorsId> m_above;  ///< scratch
};

}  // namespace lentray::core
