#include "shadow/run_log.h"

#include <algorithm>
#include <bit>

#include "core/scene/scene.h"
#include "core/trace/thread_context.h"

namespace lentray::shadow {

void LightRuns::add_run(std::uint64_t length) {
  ++by_length[std::min<std::size_t>(kClasses - 1, std::bit_width(length) - 1)];
  ++runs;
  longest = std::max(longest, length);
}

void LightRuns::add(const LightRuns& other) {
  for (std::size_t i = 0; i < kClasses; ++i) by_length[i] += other.by_length[i];
  runs += other.runs;
  longest = std::max(longest, other.longest);
  blocked += other.blocked;
  rays += other.rays;
  tests += other.tests;
  miss_tests += other.miss_tests;
  blockers.insert(other.blockers.begin(), other.blockers.end());
}

class RunLog::Tester final : public core::ShadowTester {
 public:
  Tester(const RunLog& log, std::unique_ptr<core::ShadowTester> tester,
         core::ThreadContext& context)
      : m_log(log), m_tester(std::move(tester)), m_counters(context.counters),
        m_lights(context.scene.lights().size()), m_current(m_lights.size(), 0) {}
  ~Tester() override {
    for (std::size_t i = 0; i < m_lights.size(); ++i) end_run(i);
    m_log.take(m_lights);
  }

  core::Visibility visibility(const core::ShadowQuery& query) override {
    LightRuns& light = m_lights[query.light];
    const core::ShadowCounts& counts = m_counters.lights[query.light];
    const std::uint64_t hits = counts.hits, tests = tests_of(counts);
    const core::Visibility seen = m_tester->visibility(query);
    ++light.rays;
    light.tests += tests_of(counts) - tests;
    if (counts.hits == hits) light.miss_tests += tests_of(counts) - tests;
    if (seen.blocker != nullptr) {
      ++light.blocked;
      ++m_current[query.light];
      light.blockers.insert(seen.blocker);
    } else {
      end_run(query.light);
    }
    return seen;
  }

 private:
  std::uint64_t tests_of(const core::ShadowCounts& counts) const {
    return m_counters.bounds_tests + m_counters.primitive_tests + counts.probes;
  }
  void end_run(std::size_t light) {
    if (m_current[light] > 0) m_lights[light].add_run(m_current[light]);
    m_current[light] = 0;
  }

  const RunLog& m_log;
  const std::unique_ptr<core::ShadowTester> m_tester;
  const core::Counters& m_counters;
  std::vector<LightRuns> m_lights;
  std::vector<std::uint64_t> m_current;
};

std::unique_ptr<core::ShadowTester> RunLog::make(core::ThreadContext& context) const {
  return std::make_unique<Tester>(*this, m_testers.make(context), context);
}

void RunLog::take(const std::vector<LightRuns>& lights) const {
  const std::lock_guard lock(m_mutex);
  if (m_lights.size() < lights.size()) m_lights.resize(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) m_lights[i].add(lights[i]);
}

}  // namespace lentray::shadow
