// Which samples of radiosity serve a query of one depth. A pass asks ahead of time on many threads, while
// no samples are added, and again when it is the query's turn: what was found then still holds unless one
// of the samples that were added since is of use. World space. Reading is thread-safe while nobody adds.
// Source: reference manual 3.7, "Radiosity", "low_error_factor"; the rule is the one that replays stock's
// pictures (tests/image/radiosity_test.cpp).
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/irradiance/irradiance_cache.h"
#include "core/trace/indirect_light.h"

namespace lentray::core {

/// What was found for a query when there were so many samples.
struct EarlyReuse {
  static constexpr std::size_t kNotAsked = SampleStore::kAll;
  Reuse reuse;
  std::size_t samples = kNotAsked;
};

class SampleLookup {
 public:
  /// `is_last`: as the picture does. The cache outlives it.
  SampleLookup(const IrradianceCache& cache, int depth, bool is_last)
      : m_store(cache.store(depth)), m_settings(cache.settings()),
        m_error_factor(rules_at(m_settings, depth).error_factor),
        m_error_bound(m_settings.error_bound * (is_last ? 1.0 : m_settings.low_error_factor)),
        m_smooth(is_last && depth == 0) {}

  const Vec3& normal_of(const IndirectQuery& query) const {
    return m_settings.normal ? query.layer_normal : query.surface_normal;
  }
  Reuse find(const IndirectQuery& query, std::size_t limit = SampleStore::kAll) const {
    return m_store.find(asked(query), limit);
  }
  EarlyReuse find_early(const IndirectQuery& query) const {
    return {find(query), m_store.samples().size()};
  }
  /// The same as find(query), to the bit.
  Reuse find(const IndirectQuery& query, const EarlyReuse& early) const {
    constexpr std::size_t kFew = 16;  ///< looked at one by one they are quicker than all anew
    const std::size_t samples = m_store.samples().size();
    if (early.samples > samples || samples - early.samples > kFew) return find(query);
    return m_store.serves(asked(query), early.samples) ? find(query) : early.reuse;
  }

 private:
  ReuseQuery asked(const IndirectQuery& query) const {
    constexpr double kLowWeight = 0.25;  ///< of a ray, from which on errors are borne more easily
    const double tolerated = m_error_bound + std::max(0.0, kLowWeight - query.weight);
    return {query.point, normal_of(query), tolerated * m_error_factor, m_smooth};
  }

  const SampleStore& m_store;
  const RadiositySettings& m_settings;
  double m_error_factor, m_error_bound;
  bool m_smooth;
};

}  // namespace lentray::core
