// What the camera rays of neighbouring pixels meet first, found for many rays at once where they run side by side
// (core/bundle); of the others nothing is said, and who follows them searches for each. Which rays are searched
// together changes no bit. World space. One a thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/accel/bundle_tree.h"
#include "core/bundle/ray_bundle.h"

namespace lentray::core {

struct ThreadContext;

class FirstHits {
 public:
  static constexpr std::size_t kMost = RayBundle::kMost;

  explicit FirstHits(ThreadContext& context);
  /// False: nothing is ever known, and find() must not be called.
  bool works() const { return m_works; }
  /// Looks for what these meet, 1 to kMost, neighbours next to each other. Returns how many it has looked at: the
  /// others run elsewhere.
  std::size_t find(std::span<const Ray> rays);
  /// Of ray i of those. Holds until others are looked for.
  bool is_known(std::size_t i) const { return m_hits.answer[i] != BundleHits::Answer::kUnknown; }
  /// Of a ray that is known; null: nothing.
  const Hit* hit(std::size_t i) const {
    return m_hits.answer[i] == BundleHits::Answer::kMet ? &m_hits.hit[i] : nullptr;
  }

 private:
  bool find_together(std::span<const Ray> rays);

  ThreadContext& m_context;
  const bool m_works;
  const double m_min_distance;  ///< of hits
  BundleHits m_hits;
  RayBundle m_bundle;
  /// Of rays that run apart the next ones do so, too, most often: so many are not tried, more each time.
  std::uint32_t m_resting = 0, m_rest = 0;
};

}  // namespace lentray::core
