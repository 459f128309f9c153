// Event counts. One Counters a thread, merged once at the end of a frame; no locks, no atomics.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lentray::core {

struct ShadowCounts {
  std::uint64_t rays = 0;     ///< searches towards a light, cache hits included
  std::uint64_t blocked = 0;  ///< ended by an opaque blocker
  std::uint64_t probes = 0, hits = 0, misses = 0;  ///< of the shadow cache
  std::uint64_t cached = 0;  ///< of Shadow_Cache=auto: rays that asked a cache
  void add(const ShadowCounts& o) {
    rays += o.rays;
    blocked += o.blocked;
    probes += o.probes;
    hits += o.hits;
    misses += o.misses;
    cached += o.cached;
  }
};

struct Counters {
  std::uint64_t camera_rays = 0, reflected_rays = 0, refracted_rays = 0;
  std::uint64_t cut_rays = 0;     ///< kMostRays surfaces lay before them
  std::uint64_t dark_pixels = 0;  ///< camera gave no ray (total internal reflection in the sheet)
  std::uint64_t antialiased_pixels = 0;  ///< that got more samples than antialiasing gives to all
  std::uint64_t bounds_tests = 0, primitive_tests = 0;
  std::map<std::string, std::uint64_t, std::less<>> tests_by_type;  ///< primitive_tests, by name
  std::vector<ShadowCounts> lights;                                 ///< one a light of the scene
  void merge(const Counters& other);
  void add_tests(std::string_view type, std::uint64_t number);
};

}  // namespace lentray::core
