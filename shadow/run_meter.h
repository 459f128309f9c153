// How long shadows are in the picture, as seen while it is traced: how often a blocked point has
// another blocker (or none) than the pixel to its left, the one above, and the same pixel of the
// lens before. The order `adaptive` cuts its strips after it. Decorates any tester, watches points
// that the camera sees, and never changes an answer.
// Threads: any number write, as their testers go, and read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>

#include "core/trace/shadow_tester.h"

namespace lentray::shadow {

class RunMeter final : public core::ShadowTesterFactory {
 public:
  enum Neighbour : std::uint8_t { kLeft, kAbove, kLens };
  static constexpr std::size_t kNeighbours = 3;

  /// `lens`: pixels from a lens to the next, 0 without a sheet. `testers` must outlive what is made.
  RunMeter(const core::ShadowTesterFactory& testers, std::uint32_t lens)
      : m_testers(testers), m_lens(lens) {}
  std::unique_ptr<core::ShadowTester> make(core::ThreadContext& context) const override;

  /// Pixels that a shadow goes on in that direction, on average of late; 0: nothing was seen yet.
  double run_length(Neighbour neighbour) const;

  /// Of one direction: blocked points beside one that is known, and how many of them differ.
  struct Counts {
    double pairs = 0.0, changes = 0.0;
  };
  using AllCounts = std::array<Counts, kNeighbours>;
  /// Adds what was seen; what is older counts half.
  void add(const AllCounts& seen) const;

 private:
  class Tester;
  const core::ShadowTesterFactory& m_testers;
  const std::uint32_t m_lens;
  mutable std::mutex m_mutex;
  mutable AllCounts m_counts{};
};

}  // namespace lentray::shadow
