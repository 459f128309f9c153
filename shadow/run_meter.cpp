#include "shadow/run_meter.h"

#include <algorithm>
#include <vector>

#include "core/scene/scene.h"
#include "core/trace/thread_context.h"

namespace lentray::shadow {

class RunMeter::Tester final : public core::ShadowTester {
 public:
  Tester(const RunMeter& meter, std::unique_ptr<core::ShadowTester> tester,
         core::ThreadContext& context)
      : m_meter(meter), m_tester(std::move(tester)),
        m_seen(context.scene.lights().size() * kSide * kSide) {}

  core::Visibility visibility(const core::ShadowQuery& query) override {
    const core::Visibility seen = m_tester->visibility(query);
    if (query.level != 1 || query.sample != 0) return seen;
    at(query, query.column, query.row) = {query.column, query.row, seen.blocker, true};
    if (seen.blocker) {
      if (query.column > 0) compare(kLeft, query, 1, 0, seen.blocker);
      if (query.row > 0) compare(kAbove, query, 0, 1, seen.blocker);
      if (m_meter.m_lens > 0 && query.column >= m_meter.m_lens) {
        compare(kLens, query, m_meter.m_lens, 0, seen.blocker);
      }
    }
    if (++m_rays % kReported == 0) {
      m_meter.add(m_counts);
      m_counts = {};
    }
    return seen;
  }

 private:
  static constexpr std::uint32_t kSide = 64;        ///< of the square of pixels remembered
  static constexpr std::uint32_t kReported = 2048;  ///< rays from report to report
  struct Seen {
    std::uint32_t column = 0, row = 0;
    const core::Object* blocker = nullptr;
    bool known = false;
  };

  Seen& at(const core::ShadowQuery& query, std::uint32_t column, std::uint32_t row) {
    return m_seen[(query.light * kSide + row % kSide) * kSide + column % kSide];
  }
  void compare(Neighbour neighbour, const core::ShadowQuery& query, std::uint32_t left,
               std::uint32_t up, const core::Object* blocker) {
    const std::uint32_t column = query.column - left, row = query.row - up;
    const Seen& other = at(query, column, row);
    if (!other.known || other.column != column || other.row != row) return;
    m_counts[neighbour].pairs += 1.0;
    if (other.blocker != blocker) m_counts[neighbour].changes += 1.0;
  }

  const RunMeter& m_meter;
  const std::unique_ptr<core::ShadowTester> m_tester;
  std::vector<Seen> m_seen;
  AllCounts m_counts{};
  std::uint32_t m_rays = 0;
};

std::unique_ptr<core::ShadowTester> RunMeter::make(core::ThreadContext& context) const {
  return std::make_unique<Tester>(*this, m_testers.make(context), context);
}

void RunMeter::add(const AllCounts& seen) const {
  const std::lock_guard lock(m_mutex);
  for (std::size_t i = 0; i < kNeighbours; ++i) {
    m_counts[i].pairs = 0.5 * m_counts[i].pairs + seen[i].pairs;
    m_counts[i].changes = 0.5 * m_counts[i].changes + seen[i].changes;
  }
}

double RunMeter::run_length(Neighbour neighbour) const {
  const std::lock_guard lock(m_mutex);
  const Counts& counts = m_counts[neighbour];
  return counts.pairs < 1.0 ? 0.0 : counts.pairs / std::max(counts.changes, 0.5);
}

}  // namespace lentray::shadow
