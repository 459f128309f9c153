// Which lights of the light groups around an object light it. Source: reference manual 3.7, "Light
// Groups"; nesting as measured on stock (tests/image/light_group_test.cpp): a group's lights are
// handed down to its objects as the statement ends, inner groups first, and no further than to a
// compound that was handed lights before. Copying a group makes it forget its own list, not what
// its objects have; so the same nesting differs between a group and an object made of it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace lentray::parser {

/// A compound object (CSG, light_group, text, light_source with looks_like) on the way from the
/// scene to an object in at least one group. Lives while its parts are built; links to those
/// around it. Indices are of the scene's lights.
class LightScope {
 public:
  /// A compound that is no group.
  LightScope(const LightScope* around, bool copied)
      : m_around(around), m_copied(copied || (around && around->m_copied)) {}
  /// A light_group.
  LightScope(const LightScope* around, bool copied, std::vector<std::uint32_t> lights, bool global)
      : m_around(around), m_copied(copied || (around && around->m_copied)),
        m_lights(std::move(lights)), m_group(true), m_global(global) {}
  /// A light_source around what it looks like, which global lights always light.
  static LightScope of_light(const LightScope* around) {
    LightScope scope(around, false);
    scope.m_light = true;
    return scope;
  }

  /// Whether lights outside all groups light what is in here: the outermost group says.
  bool global() const;
  /// The grouped lights that light what is in here, in the order they count.
  std::vector<std::uint32_t> local() const;

 private:
  const LightScope* m_around;
  bool m_copied;                        ///< it or what is around it was made from an identifier
  std::vector<std::uint32_t> m_lights;  ///< a group's own
  bool m_group = false, m_light = false, m_global = false;
};

}  // namespace lentray::parser
