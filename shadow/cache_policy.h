// Where a shadow cache keeps what it remembers: keys. A policy maps a query to the slots worth a
// look and to those that remember its blocker. A policy has
//   static constexpr std::string_view kName;
//   static constexpr std::size_t kProbes;      how many different blockers may be tried
//   explicit Policy(const core::Scene&);
//   std::size_t slots() const;                 how many slots a thread's table has
//   Keys keys(const core::ShadowQuery&) const; which to look into, in order; the first kProbes
//                                              different ones are tried
//   Keys homes(const core::ShadowQuery&) const; where the blocker goes
// Policies only decide what is probed; they cannot change the picture, since an entry is put to
// the same test as the full search. Stateless, any number of threads.
// Sources: Haines & Greenberg, "The Light Buffer" (last blocker); stock's two slots a light; Pearce,
// "Shadow Caching" (a cache for each place in the ray tree).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/render/shadow_tester.h"
#include "core/scene/scene.h"

namespace lentray::shadow {

struct Keys {
  static constexpr std::size_t kMost = 8;
  std::array<std::size_t, kMost> slot{};
  std::size_t count = 0;
};

/// One slot a light: whatever blocked it last.
class LastPolicy {
 public:
  static constexpr std::string_view kName = "last";
  static constexpr std::size_t kProbes = 1;
  explicit LastPolicy(const core::Scene& scene) : m_lights(scene.lights().size()) {}
  std::size_t slots() const { return m_lights; }
  Keys keys(const core::ShadowQuery& query) const { return {{query.light}, 1}; }
  Keys homes(const core::ShadowQuery& query) const { return keys(query); }

 private:
  std::size_t m_lights;
};

/// Two slots a light: points that the camera sees, and points seen in mirrors or through glass.
/// A camera ray looks into the other slot while its own is empty.
class DepthPolicy {
 public:
  static constexpr std::string_view kName = "depth";
  static constexpr std::size_t kProbes = 1;
  explicit DepthPolicy(const core::Scene& scene) : m_lights(scene.lights().size()) {}
  std::size_t slots() const { return 2 * m_lights; }
  Keys keys(const core::ShadowQuery& query) const {
    const std::size_t deeper = m_lights + query.light;
    if (query.depth == 1) return {{query.light, deeper}, 2};
    return {{deeper}, 1};
  }
  Keys homes(const core::ShadowQuery& query) const {
    return {{query.depth == 1 ? query.light : m_lights + query.light}, 1};
  }

 private:
  std::size_t m_lights;
};

/// A slot for each light and place in the ray tree: the way of reflections and refractions from
/// the camera to the point.
class TreePolicy {
 public:
  static constexpr std::string_view kName = "tree";
  static constexpr std::size_t kProbes = 1;
  explicit TreePolicy(const core::Scene& scene) : m_lights(scene.lights().size()) {}
  std::size_t slots() const { return m_lights * core::kTreePlaces; }
  Keys keys(const core::ShadowQuery& query) const {
    return {{query.light * core::kTreePlaces + query.tree_place}, 1};
  }
  Keys homes(const core::ShadowQuery& query) const { return keys(query); }

 private:
  std::size_t m_lights;
};

/// What blocked around the point in the picture: for each light and column the last blocker of a
/// camera ray's point there, so the pixel to the left and the row above; points in mirrors and behind
/// glass have slots of their own.
class NeighbourhoodPolicy {
 public:
  static constexpr std::string_view kName = "neighbourhood";
  static constexpr std::size_t kProbes = 2;
  explicit NeighbourhoodPolicy(const core::Scene& scene) : m_lights(scene.lights().size()) {}
  std::size_t slots() const { return m_lights * kEach; }
  Keys keys(const core::ShadowQuery& query) const {
    return {{at(query, 0), at(query, kColumns - 1), at(query, 1)}, 3};
  }
  Keys homes(const core::ShadowQuery& query) const { return {{at(query, 0)}, 1}; }

 private:
  static constexpr std::size_t kColumns = 4096;  ///< wider pictures wrap around
  static constexpr std::size_t kEach = kColumns * 2;
  /// Deeper points in the other half: they lie elsewhere in the scene.
  std::size_t at(const core::ShadowQuery& query, std::size_t shift) const {
    const std::size_t half = query.depth == 1 ? 0 : kColumns;
    return query.light * kEach + half + (query.column + shift) % kColumns;
  }
  std::size_t m_lights;
};

}  // namespace lentray::shadow
