#include "core/pass/pass_list.h"

#include <chrono>

#include "core/base/cpu_seconds.h"

namespace lentray::core {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

bool PassList::run(const PassOptions& options) {
  double work = options.film_work;
  for (const Pass* pass : m_passes) work += pass->work();
  m_listener = options.progress;
  m_progress.emplace(options.progress, work);
  if (m_passes.empty()) return true;
  try {
    PassTeam::run(options.threads, options.levels, [&](PassTeam& team) {
      for (std::size_t i = 0; i < m_passes.size(); ++i) {
        const Clock::time_point start = Clock::now();
        const double cpu = cpu_seconds();
        m_progress->begin(m_passes[i]->work());
        if (options.ledger) options.ledger->begin(i);
        PassRun run(team, *m_progress, options.cancel, options.ledger);
        run.check_cancelled();
        m_passes[i]->run(run);
        m_reports.push_back({m_passes[i]->name(),
                             std::chrono::duration<double>(Clock::now() - start).count(),
                             cpu_seconds() - cpu, run.numbers()});
      }
    });
  } catch (const PassCancelled&) {
    return false;
  }
  if (options.ledger) options.ledger->finish();
  m_progress->begin(options.film_work);
  return true;
}

Progress* PassList::film_progress() {
  if (!m_listener) return nullptr;
  return m_passes.empty() ? m_listener : &*m_progress;
}

}  // namespace lentray::core
