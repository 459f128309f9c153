// Where a shadow cache keeps what it remembers: keys. A policy maps a query to the slots worth a
// look and to the slot that remembers its blocker. A policy has
//   static constexpr std::string_view kName;
//   explicit Policy(std::size_t lights);
//   std::size_t slots() const;                 how many slots a thread's table has
//   Keys keys(const core::ShadowQuery&) const; which to look into, in order: the first that is
//                                              filled is probed, the others are not
//   std::size_t home(const core::ShadowQuery&) const;  where the blocker goes
// Policies only decide what is probed; they cannot change the picture, since an entry is put to
// the same test as the full search. Stateless, any number of threads.
// Sources: Haines & Greenberg, "The Light Buffer" (last blocker); stock's two slots a light.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/render/shadow_tester.h"

namespace lentray::shadow {

struct Keys {
  static constexpr std::size_t kMost = 2;
  std::array<std::size_t, kMost> slot{};
  std::size_t count = 0;
};

/// One slot a light: whatever blocked it last.
class LastPolicy {
 public:
  static constexpr std::string_view kName = "last";
  explicit LastPolicy(std::size_t lights) : m_lights(lights) {}
  std::size_t slots() const { return m_lights; }
  Keys keys(const core::ShadowQuery& query) const { return {{query.light, 0}, 1}; }
  std::size_t home(const core::ShadowQuery& query) const { return query.light; }

 private:
  std::size_t m_lights;
};

/// Two slots a light: points that the camera sees, and points seen in mirrors or through glass.
/// A camera ray looks into the other slot while its own is empty.
class DepthPolicy {
 public:
  static constexpr std::string_view kName = "depth";
  explicit DepthPolicy(std::size_t lights) : m_lights(lights) {}
  std::size_t slots() const { return 2 * m_lights; }
  Keys keys(const core::ShadowQuery& query) const {
    const std::size_t deeper = m_lights + query.light;
    if (query.depth == 1) return {{query.light, deeper}, 2};
    return {{deeper, 0}, 1};
  }
  std::size_t home(const core::ShadowQuery& query) const {
    return query.depth == 1 ? query.light : m_lights + query.light;
  }

 private:
  std::size_t m_lights;
};

}  // namespace lentray::shadow
