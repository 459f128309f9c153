#include "tools/lentray-batch/scheduler.h"

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>

#include "tools/common/duration.h"

namespace lentray::batch {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSmall = 20.0;       ///< seconds of one processor
constexpr double kGrace = 3.0;        ///< seconds between asking and killing
constexpr double kMostMemory = 0.85;  ///< of the machine's, of all runs together
constexpr double kStockTime = 5.0;    ///< how many times a scene's limit stock may take

}  // namespace

Scheduler::Scheduler(const Plan& plan, std::function<void(const Row&)> keep,
                     BatchProgress& progress)
    : m_plan(plan), m_keep(std::move(keep)), m_progress(progress), m_told(Clock::now()) {}

int Scheduler::slots() const {
  return m_plan.arguments.jobs > 0 ? m_plan.arguments.jobs : m_plan.processors;
}

void Scheduler::add(std::unique_ptr<Job> job) {
  next(*job);
  m_jobs.push_back(std::move(job));
}

/// Puts a job where it waits for what it needs next.
void Scheduler::next(Job& job) {
  if (job.needs_picture()) {
    (slots() == 1 ? m_large : m_small).push_back(&job);
  } else if (job.needs_views() || job.needs_comparison()) {
    m_after.push_back(&job);
  } else {
    finish(job);
  }
}

void Scheduler::finish(Job& job) {
  m_keep(job.row());
  m_progress.finished(job.row());
  m_news = true;
}

bool Scheduler::start(Job& job, Kind kind) try {
  const double share = std::min(m_plan.memory_limit(), kMostMemory * m_plan.memory / slots());
  tool::Launch launch;
  switch (kind) {
    case Kind::small: launch = job.render(1, share); break;
    case Kind::large: launch = job.render(m_plan.processors, m_plan.memory_limit()); break;
    case Kind::views: launch = job.split_views(); break;
    case Kind::comparison: launch = job.compare(1); break;
  }
  m_running.push_back({&job, kind, std::make_unique<tool::Child>(launch), false, false, "", 0.0});
  if (m_running.size() > 1) {
    for (Running& run : m_running) run.had_company = true;
  }
  return true;
} catch (const std::exception& error) {
  job.give_up(error.what());
  if (!can_be_tried_again(job, !m_running.empty())) finish(job);
  return false;
}

/// Alone a picture is begun in any case.
bool Scheduler::has_room_for(const Job& job) const {
  if (m_running.empty()) return true;
  std::error_code error;
  const auto disk = std::filesystem::space(m_plan.arguments.out, error);
  if (error) return true;
  double needed = job.room();
  for (const Running& run : m_running) needed += run.job->room();
  return needed <= static_cast<double>(disk.available);
}

/// True if the job waits for another run, because its last one found too little room on the disk.
bool Scheduler::can_be_tried_again(Job& job, bool had_company) {
  constexpr int kMostTimes = 3;
  if (!job.lacked_room() || m_lacked_room[&job] >= kMostTimes) return false;
  if (!had_company && !make_room_for(job)) return false;
  ++m_lacked_room[&job];
  job.try_again();
  had_company ? m_alone.push_back(&job) : m_alone.push_front(&job);
  return true;
}

/// What others have kept, and after that the reserve. False: there is nothing to be had.
bool Scheduler::make_room_for(const Job& job) const {
  bool is_made = false;
  for (const std::unique_ptr<Job>& other : m_jobs) {
    if (other.get() != &job && other->needs_picture()) is_made |= other->drop_journal();
    if (other.get() != &job && other->lacked_room()) is_made |= other->drop_journal();
  }
  return is_made || m_plan.state->free_reserve();
}

void Scheduler::fill() {
  const auto free = [this] { return static_cast<int>(m_running.size()) < slots(); };
  const auto is_large = [](const Running& run) { return run.kind == Kind::large; };
  if (std::ranges::any_of(m_running, is_large)) return;
  const auto take = [this](std::deque<Job*>& queue) {
    Job* const job = queue.front();
    queue.pop_front();
    return job;
  };
  while (free() && !m_after.empty()) {
    Job* const job = take(m_after);
    start(*job, job->needs_views() ? Kind::views : Kind::comparison);
  }
  while (free() && !m_small.empty() && has_room_for(*m_small.front()))
    start(*take(m_small), Kind::small);
  while (m_running.empty() && !m_large.empty()) start(*take(m_large), Kind::large);
  while (m_running.empty() && !m_alone.empty()) start(*take(m_alone), Kind::large);
}

void Scheduler::set_back(Running& run) {
  run.is_set_back = true;
  run.is_asked = true;
  run.asked_at = run.child->seconds();
  run.child->ask_to_stop();
}

void Scheduler::watch_time(Running& run) {
  const double limit = m_plan.arguments.time_limit;
  if (run.is_asked) {
    if (run.child->seconds() > run.asked_at + kGrace) run.child->kill();
    return;
  }
  const bool renders = run.kind == Kind::small || run.kind == Kind::large;
  const double taken = run.child->seconds() + (renders ? run.job->seconds() : 0.0);
  if (limit > 0.0 && taken > (renders ? limit : kStockTime * limit)) {
    run.over = "longer than " + tool::duration_text(renders ? limit : kStockTime * limit) +
               " (--time-limit)";
    run.is_asked = true;
    run.asked_at = run.child->seconds();
    run.child->ask_to_stop();
  } else if (run.kind == Kind::small && run.child->seconds() > kSmall) {
    set_back(run);
  }
}

/// Lentray keeps to its share itself; stock does not, and libraries may not.
void Scheduler::watch_memory() {
  double all = 0.0;
  Running* largest = nullptr;
  double most = 0.0;
  for (Running& run : m_running) {
    const auto bytes = static_cast<double>(run.child->resident_bytes());
    all += bytes;
    if (run.is_asked || bytes <= most) continue;
    most = bytes;
    largest = &run;
  }
  if (largest == nullptr) return;
  const bool is_over = most > 1.2 * m_plan.memory_limit() + 2e8;
  if (!is_over && all <= kMostMemory * m_plan.memory) return;
  if (largest->kind == Kind::small && !is_over) return set_back(*largest);
  largest->over = "takes more memory than is allowed (--memory-limit)";
  largest->is_asked = true;
  largest->child->kill();
}

void Scheduler::watch() {
  constexpr std::chrono::milliseconds kOften{200};
  for (Running& run : m_running) watch_time(run);
  if (Clock::now() - m_watched < kOften) return;
  m_watched = Clock::now();
  watch_memory();
}

void Scheduler::ended(Running& run, const tool::Ended& how) {
  Job& job = *run.job;
  switch (run.kind) {
    case Kind::views: job.views_split(how); break;
    case Kind::comparison:
      job.compared(run.over.empty() ? how : tool::Ended{137, how.wall, how.cpu, how.memory});
      break;
    case Kind::small:
    case Kind::large: {
      const bool is_set_back = run.is_set_back && how.status != 0 && run.over.empty();
      job.rendered(how, is_set_back);
      if (!run.over.empty() && how.status != 0) job.give_up(run.over);
      if (is_set_back || (run.kind == Kind::small && job.lacked_memory())) {
        job.try_again();
        m_large.push_back(&job);
        return;
      }
      if (can_be_tried_again(job, run.had_company)) return;
      break;
    }
  }
  next(job);
}

void Scheduler::reap() {
  for (std::size_t i = 0; i < m_running.size();) {
    const auto how = m_running[i].child->ended();
    if (!how) {
      ++i;
      continue;
    }
    Running run = std::move(m_running[i]);
    m_running.erase(m_running.begin() + static_cast<std::ptrdiff_t>(i));
    ended(run, *how);
  }
}

/// What runs is asked to stop, and keeps what it has: the next batch goes on with it.
void Scheduler::stop_all() {
  for (Running& run : m_running) run.child->ask_to_stop();
  const auto until = Clock::now() + std::chrono::milliseconds(1500);
  while (!m_running.empty() && Clock::now() < until) {
    if (tool::wait_for_news(std::chrono::milliseconds(50)) != 0) break;  // a second signal
    std::erase_if(m_running, [this](Running& run) {
      const auto how = run.child->ended();
      if (!how) return false;
      const bool renders = run.kind == Kind::small || run.kind == Kind::large;
      if (renders && how->status == 0) {
        run.job->rendered(*how, false);
        if (!run.job->needs_views() && !run.job->needs_comparison()) finish(*run.job);
      }
      return true;
    });
  }
  m_running.clear();  // kills
}

bool Scheduler::run() {
  constexpr std::chrono::milliseconds kPatience{200};
  constexpr std::chrono::seconds kTell{60};
  for (;;) {
    fill();
    if (m_running.empty() && m_small.empty() && m_large.empty() && m_after.empty() &&
        m_alone.empty())
      return true;
    m_progress.running(m_running.size());
    if (tool::wait_for_news(kPatience) != 0) {
      stop_all();
      return false;
    }
    reap();
    watch();
    if (m_now_and_then && m_news && Clock::now() - m_told > kTell) {
      m_now_and_then();
      m_told = Clock::now();
      m_news = false;
    }
  }
}

}  // namespace lentray::batch
