// A log of what shadow testers answer, in the order they are asked: runs of successive blocked rays
// of each light ("continuous cache hits", the ray that fills the cache counted), which objects
// block, and what answers cost. Decorates any tester and never changes an answer.
//
// A thread has runs of its own, so with several threads a run also ends where a thread's work does;
// the paper's measure needs one thread. The log is filled as the testers go away, at the end of a
// frame. Threads: the factory is used from many.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_set>
#include <vector>

#include "core/trace/shadow_tester.h"

namespace lentray::shadow {

/// Of one light.
struct LightRuns {
  /// Runs of 2^i to 2^(i+1) - 1 rays.
  static constexpr std::size_t kClasses = 40;
  std::array<std::uint64_t, kClasses> by_length{};
  std::uint64_t runs = 0, longest = 0;
  std::uint64_t blocked = 0, rays = 0;
  /// Tests of bounds and of primitives for all rays, a cache's probe counted as one; and those for
  /// rays that the cache did not answer. Only where ThreadContext::count_tests is set.
  std::uint64_t tests = 0, miss_tests = 0;
  std::unordered_set<const core::Object*> blockers;  ///< opaque ones

  /// The most hits a cache can have: every blocker must be found once.
  std::uint64_t most_hits() const { return blocked - blockers.size(); }
  void add_run(std::uint64_t length);
  void add(const LightRuns& other);
};

class RunLog final : public core::ShadowTesterFactory {
 public:
  /// Both must outlive the testers that are made.
  explicit RunLog(const core::ShadowTesterFactory& testers) : m_testers(testers) {}
  std::unique_ptr<core::ShadowTester> make(core::ThreadContext& context) const override;
  /// One a light of the scene; empty before a tester has gone away.
  const std::vector<LightRuns>& lights() const { return m_lights; }

 private:
  class Tester;
  void take(const std::vector<LightRuns>& lights) const;

  const core::ShadowTesterFactory& m_testers;
  mutable std::mutex m_mutex;
  mutable std::vector<LightRuns> m_lights;
};

}  // namespace lentray::shadow
