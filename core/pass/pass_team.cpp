#include "core/pass/pass_team.h"

#include <algorithm>
#include <utility>

#include "core/base/deep_threads.h"

namespace lentray::core {
namespace {

/// Looks before a thread goes to sleep: some 20 microseconds, about what waking up takes.
constexpr int kLooks = 20000;

}  // namespace

void PassTeam::run(unsigned threads, std::size_t levels,
                   const std::function<void(PassTeam&)>& lead) {
  PassTeam team(std::clamp(threads, 1u, kEnd - 1));
  std::exception_ptr failure;
  run_on_threads(team.m_count, levels, [&] {
    const unsigned thread = team.m_arrived.fetch_add(1);
    if (thread > 0) return team.serve(thread);
    try {
      lead(team);
    } catch (...) {
      failure = std::current_exception();
    }
    team.m_state = kEnd;
    team.m_state.notify_all();
  });
  if (failure) std::rethrow_exception(failure);
}

void PassTeam::do_share(unsigned thread) {
  try {
    (*m_share)(thread);
  } catch (...) {
    const std::lock_guard lock(m_mutex);
    if (!m_failure) m_failure = std::current_exception();
  }
}

void PassTeam::all(const Share& share) {
  m_share = &share;
  std::uint32_t state = (m_state.load() / kOne + 1) * kOne + kOpen;
  m_state.store(state);
  m_state.notify_all();
  do_share(0);
  state = m_state.fetch_and(~kOpen) & ~kOpen;
  while ((state & kInside) != 0) {
    m_state.wait(state);
    state = m_state.load();
  }
  m_share = nullptr;
  if (m_failure) std::rethrow_exception(std::exchange(m_failure, nullptr));
}

void PassTeam::serve(unsigned thread) {
  std::uint32_t last = 0;  // of which share it was
  int looks = 0;
  for (std::uint32_t state = m_state.load(); state != kEnd; state = m_state.load()) {
    if ((state & kOpen) == 0 || state / kOne == last) {
      if (++looks > kLooks) m_state.wait(state);
      continue;
    }
    looks = 0;
    if (!m_state.compare_exchange_weak(state, state + 1)) continue;
    last = state / kOne;
    do_share(thread);
    if (((m_state.fetch_sub(1) - 1) & (kOpen | kInside)) == 0) m_state.notify_all();
  }
}

}  // namespace lentray::core
