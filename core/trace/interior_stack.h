// The interiors a ray travels in, innermost last. Every object has one: without an `interior`
// statement it is a plain one with the ior of the atmosphere, told apart by the object
// of the source: parts of a union share it.
// Source: reference manual 3.7, "Interior"; the order of nested and overlapping ones is stock's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/material/interior.h"
#include "core/object/object.h"

namespace lentray::core {

/// Without initialisers on purpose: a stack is copied with every ray and mostly empty.
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

/// Deeper nesting than kCapacity is not followed: what is pushed beyond is forgotten.
class InteriorStack {
 public:
  static constexpr std::size_t kCapacity = 24;

  InteriorStack() {}  // not defaulted: that would clear all entries
  InteriorStack(const InteriorStack& o) { copy(o); }
  InteriorStack& operator=(const InteriorStack& o) {
    if (this != &o) copy(o);
    return *this;
  }

  bool empty() const { return m_size == 0; }
  std::size_t size() const { return m_size; }
  const InteriorEntry* begin() const { return m_entries.data(); }
  const InteriorEntry* end() const { return m_entries.data() + m_size; }
  const InteriorEntry& back() const { return m_entries[m_size - 1]; }
  void clear() { m_size = 0; }
  void push(const InteriorEntry& entry) {
    if (m_size < kCapacity) m_entries[m_size++] = entry;
  }
  bool contains(std::uintptr_t key) const {
    for (std::size_t i = 0; i < m_size; ++i) {
      if (m_entries[i].key == key) return true;
    }
    return false;
  }
  /// True in the open, and where all that surrounds the ray is hollow.
  bool is_hollow() const {
    for (std::size_t i = 0; i < m_size; ++i) {
      if (!m_entries[i].hollow) return false;
    }
    return true;
  }
  /// Removes the outermost entry of that key; false if there is none.
  bool remove(std::uintptr_t key) {
    std::size_t i = 0;
    while (i < m_size && m_entries[i].key != key) ++i;
    if (i == m_size) return false;
    for (; i + 1 < m_size; ++i) m_entries[i] = m_entries[i + 1];
    --m_size;
    return true;
  }

 private:
  void copy(const InteriorStack& o) {
    m_size = o.m_size;
    for (std::size_t i = 0; i < m_size; ++i) m_entries[i] = o.m_entries[i];
  }
  std::size_t m_size = 0;
  std::array<InteriorEntry, kCapacity> m_entries;
};

/// What refraction at a surface depends on: before it over behind it.
struct Bend {
  double ior = 1.0, dispersion = 1.0;
  int bands = kDefaultBands;  ///< that light is split into, if dispersion is not 1
};

/// Changes the stack as a ray passes the surface of that interior. Nested objects count as cut out of those around them. Where objects overlap, the one that was entered
/// last fills the overlap, and leaving the other one there bends nothing.
Bend enter(const InteriorEntry& entry, double atmosphere_ior, InteriorStack& inside);

/// For the Fresnel term: the ior behind the surface over the ior before it. Leaving a nested object
/// compares with the innermost interior, which is most often the object itself, as in stock.
double relative_ior(const InteriorEntry& entry, const InteriorStack& inside, double atmosphere_ior);

/// What is left of light after `depth` in an interior, as seen by rays (shadows need a fade power).
Rgb fade_in_interior(const Interior& interior, double depth);

}  // namespace lentray::core
