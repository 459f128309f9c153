// Where a shadow cache keeps what it remembers: keys. A policy maps a query to the slots worth a
// look and to those that remember its blocker. A policy has
//   static constexpr std::string_view kName;
//   static constexpr std::size_t kProbes;      how many different blockers may be tried
//   explicit Policy(const core::Scene&);
//   std::size_t slots() const;                 how many slots a thread's table has
//   Keys<N> keys(const core::ShadowQuery&) const;  which to look into, in order; the first kProbes
//                                                  different entries are tried
//   Keys<M> homes(const core::ShadowQuery&) const; where the blocker goes
// Policies only decide what is probed; they cannot change the picture, since an entry is put to
// the same test as the full search. Stateless, any number of threads.
// Sources: Haines & Greenberg, "The Light Buffer" (last blocker); POV-Ray 3.7 (two slots a light);
// Pearce, "Shadow Caching" (a cache for each place in the ray tree).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/scene/scene.h"
#include "core/trace/shadow_tester.h"

namespace lentray::shadow {

template <std::size_t kCount>
using Keys = std::array<std::size_t, kCount>;

/// So many slots a light, one of which is tried.
template <std::size_t kEach>
class SlotsALight {
 public:
  static constexpr std::size_t kProbes = 1;
  explicit SlotsALight(const core::Scene& scene) : m_lights(scene.lights().size()) {}
  std::size_t slots() const { return kEach * m_lights; }

 protected:
  const std::size_t m_lights;
};

/// One slot a light: whatever blocked it last.
class LastPolicy : public SlotsALight<1> {
 public:
  static constexpr std::string_view kName = "last";
  using SlotsALight::SlotsALight;
  Keys<1> keys(const core::ShadowQuery& query) const { return {query.light}; }
  Keys<1> homes(const core::ShadowQuery& query) const { return keys(query); }
};

/// Two slots a light: points that the camera sees, and points seen in mirrors or through glass.
/// A camera ray looks into the other slot while its own is empty.
class DepthPolicy : public SlotsALight<2> {
 public:
  static constexpr std::string_view kName = "depth";
  using SlotsALight::SlotsALight;
  Keys<2> keys(const core::ShadowQuery& query) const {
    return {homes(query)[0], m_lights + query.light};
  }
  Keys<1> homes(const core::ShadowQuery& query) const {
    return {query.level == 1 ? query.light : m_lights + query.light};
  }
};

/// A slot for each light and place in the ray tree: the way of reflections and refractions from
/// the camera to the point.
class TreePolicy : public SlotsALight<core::kTreePlaces> {
 public:
  static constexpr std::string_view kName = "tree";
  using SlotsALight::SlotsALight;
  Keys<1> keys(const core::ShadowQuery& query) const {
    return {query.light * core::kTreePlaces + query.tree_place};
  }
  Keys<1> homes(const core::ShadowQuery& query) const { return keys(query); }
};

}  // namespace lentray::shadow
