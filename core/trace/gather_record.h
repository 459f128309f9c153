// Serialises one gather of a radiosity pass, so that an interrupted pass can go on where it stopped. A record
// holds the light that was gathered, the samples that the gather and the gathers of its rays added to the cache,
// and the state afterwards: the places in the cycles of directions, and the counts. Numbers have this machine's
// byte order. Pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/irradiance/irradiance_cache.h"

namespace lentray::core {

/// Of one depth.
struct GatherCounts {
  std::uint64_t queries = 0, gathers = 0, rays = 0;
  double found = 0.0;          ///< samples that were found for the queries
  std::uint64_t not_kept = 0;  ///< gathers so near to something that they serve no other place
  GatherCounts& operator-=(const GatherCounts& o) {
    queries -= o.queries;
    gathers -= o.gathers;
    rays -= o.rays;
    not_kept -= o.not_kept;
    found -= o.found;
    return *this;
  }
};

/// What a gather has changed when it is over.
struct GatherState {
  GatheredLight light;
  std::uint64_t gathers = 0;          ///< since the ray began
  float importance = 1.0f;            ///< of what the last ray met
  std::vector<std::uint64_t> places;  ///< in the cycles of directions, by depth
  std::vector<GatherCounts> counts;   ///< by depth
};

/// How many samples each store has.
std::vector<std::size_t> sizes_of(const IrradianceCache& cache);

/// With the samples that were not there when the stores had those sizes.
std::string bytes_of(const GatherState& state, const IrradianceCache& cache,
                     const std::vector<std::size_t>& before);
/// Adds the samples. False if the bytes are no such record.
bool take_gather(std::string_view bytes, GatherState& state, IrradianceCache& cache);

}  // namespace lentray::core
