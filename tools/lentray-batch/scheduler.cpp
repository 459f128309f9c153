#include "tools/lentray-batch/scheduler.h"

#include <algorithm>
#include <exception>
#include <filesystem>

#include "tools/common/duration.h"

namespace lentray::batch {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGrace = 3.0;        ///< seconds between asking and killing
constexpr double kMostMemory = 0.85;  ///< of the machine's, of all runs together
constexpr double kStockTime =
    4.0 * kStocksTimes;  ///< of a scene's limit: stock's picture, and three for its noise

}  // namespace

Scheduler::Scheduler(const Plan& plan, std::function<void(const Row&)> keep,
                     BatchProgress& progress)
    : m_plan(plan), m_keep(std::move(keep)), m_progress(progress), m_told(Clock::now()) {}

int Scheduler::slots() const {
  return m_plan.arguments.jobs > 0 ? m_plan.arguments.jobs : m_plan.processors;
}

int Scheduler::free_slots() const {
  int taken = 0;
  for (const Running& running : m_running) taken += running.threads;
  return slots() - taken;
}

void Scheduler::add(std::unique_ptr<Job> job) {
  next(*job);
  m_jobs.push_back(std::move(job));
}

/// Puts a job where it waits for what it needs next.
void Scheduler::next(Job& job) {
  if (job.needs_picture()) {
    if (m_small.empty() || !m_small.back().take(job)) m_small.emplace_back(job, m_plan.turn);
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

void Scheduler::start(PictureRun run, Kind kind, int threads) try {
  const double share =
      std::min(m_plan.memory_limit(), kMostMemory * m_plan.memory * threads / slots());
  tool::Launch launch;
  switch (kind) {
    case Kind::small: launch = run.launch(threads, share); break;
    case Kind::large: launch = run.launch(m_plan.processors, m_plan.memory_limit()); break;
    case Kind::views: launch = run.job().split_views(); break;
    case Kind::comparison: launch = run.job().compare(1); break;
  }
  m_running.push_back({run, kind, threads, std::make_unique<tool::Child>(launch)});
  if (m_running.size() > 1) {
    for (Running& running : m_running) running.had_company = true;
  }
} catch (const std::exception& error) {
  Running none{std::move(run), kind, threads, nullptr};
  none.run.job().give_up(error.what());
  if (can_be_tried_again(none.run, !m_running.empty())) return;
  finish(none.run.job());
  try_others(none, false);
}

/// Alone a picture is begun in any case.
bool Scheduler::has_room_for(const PictureRun& run) const {
  if (m_running.empty()) return true;
  std::error_code error;
  const auto disk = std::filesystem::space(m_plan.arguments.out, error);
  if (error) return true;
  double needed = run.room();
  for (const Running& running : m_running) needed += running.run.room();
  return needed <= static_cast<double>(disk.available);
}

/// True if the run waits for another one, because it found too little room on the disk.
bool Scheduler::can_be_tried_again(PictureRun& run, bool had_company) {
  constexpr int kMostTimes = 3;
  Job& job = run.job();
  if (!job.lacked_room() || m_lacked_room[&job] >= kMostTimes) return false;
  if (!had_company && !make_room_for(job)) return false;
  ++m_lacked_room[&job];
  job.try_again();
  had_company ? m_alone.push_back(run) : m_alone.push_front(run);
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
  const auto is_large = [](const Running& running) { return running.kind == Kind::large; };
  if (std::ranges::any_of(m_running, is_large)) return;
  const auto take = [](auto& queue) {
    auto first = std::move(queue.front());
    queue.pop_front();
    return first;
  };
  while (free_slots() > 0 && !m_after.empty()) {
    Job* const job = take(m_after);
    start(PictureRun(*job, m_plan.turn), job->needs_views() ? Kind::views : Kind::comparison);
  }
  while (free_slots() > 0 && !m_small.empty() && has_room_for(m_small.front())) {
    const int share = free_slots() / static_cast<int>(m_small.size());
    const int threads = std::clamp(share, 1, m_plan.processors);
    // What has the machine to itself need not be stopped for it.
    const bool is_alone = m_running.empty() && (slots() == 1 || m_small.size() == 1);
    start(take(m_small), is_alone ? Kind::large : Kind::small, threads);
    if (is_alone) return;
  }
  while (m_running.empty() && !m_large.empty()) start(take(m_large), Kind::large);
  while (m_running.empty() && !m_alone.empty()) start(take(m_alone), Kind::large);
}

/// A turn ends for others. A small picture's does in any case: alone it gets all processors.
bool Scheduler::is_waited_for(const Running& running) const {
  return running.kind == Kind::small ||
         (running.kind == Kind::large &&
          !(m_small.empty() && m_large.empty() && m_alone.empty() && m_after.empty()));
}

void Scheduler::set_back(Running& running) {
  running.is_set_back = true;
  running.is_asked = true;
  running.asked_at = running.child->seconds();
  running.child->ask_to_stop();
}

void Scheduler::watch_time(Running& running) {
  const double limit = m_plan.arguments.time_limit;
  const double seconds = running.child->seconds();
  if (running.is_asked) {
    if (seconds > running.asked_at + kGrace) running.child->kill();
    return;
  }
  const bool renders = is_of_pictures(running.kind);
  const double of_picture = renders ? running.run.seconds_of_picture(seconds) : seconds;
  const double taken = of_picture + (renders ? running.run.job().seconds() : 0.0);
  // What is left of a scene's views has others' processors once these are idle.
  const bool others_are_idle = m_small.empty() && free_slots() > 0;
  if (limit > 0.0 && taken > (renders ? limit : kStockTime * limit)) {
    running.over = "longer than " + tool::duration_text(renders ? limit : kStockTime * limit) +
                   " (--time-limit)";
    running.is_asked = true;
    running.asked_at = seconds;
    running.child->ask_to_stop();
  } else if (is_waited_for(running) &&
             (of_picture > running.run.turn() ||
              (running.kind == Kind::small && seconds > running.run.turn() && others_are_idle &&
               running.run.is_worth_stopping()))) {
    set_back(running);
  }
}

void Scheduler::watch_log(Running& running) {
  if (!is_of_pictures(running.kind) || !running.run.job().says_too_much()) return;
  running.over = "its scene says too much: a picture may have 25 MB of messages";
  running.is_asked = true;
  running.child->kill();
}

/// Lentray keeps to its share itself; stock does not, and libraries may not.
void Scheduler::watch_memory() {
  double all = 0.0;
  Running* largest = nullptr;
  double most = 0.0;
  for (Running& running : m_running) {
    const auto bytes = static_cast<double>(running.child->resident_bytes());
    all += bytes;
    if (running.is_asked || bytes <= most) continue;
    most = bytes;
    largest = &running;
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
  for (Running& running : m_running) watch_time(running);
  if (Clock::now() - m_watched < kOften) return;
  m_watched = Clock::now();
  for (Running& running : m_running) watch_log(running);
  watch_memory();
}

/// Views that are done while their run goes on, or was.
void Scheduler::collect(Running& running) {
  if (!is_of_pictures(running.kind)) return;
  while (Job* const job = running.run.made()) next(*job);
}

void Scheduler::ended(Running& running, tool::Ended how) {
  Job& job = running.run.job();
  switch (running.kind) {
    case Kind::views: job.views_split(how); break;
    case Kind::comparison:
      if (!running.over.empty()) how.status = 137;
      job.compared(how);
      break;
    case Kind::small:
    case Kind::large: picture_ended(running, how); return;
  }
  next(job);
}

/// It was at its last picture, or ended early.
void Scheduler::picture_ended(Running& running, const tool::Ended& how) {
  PictureRun& run = running.run;
  Job& job = run.job();
  const bool is_set_back = running.is_set_back && how.status != 0 && running.over.empty();
  if (how.status == 0 && run.jobs().size() > 1) {
    job.give_up("lentray ended before this view");
  } else {
    job.rendered(run.rest(how), is_set_back);
  }
  if (!running.over.empty() && how.status != 0) job.give_up(running.over);
  if (is_set_back || (running.kind == Kind::small && job.lacked_memory())) {
    job.try_again();
    run.lengthen_turn();
    m_large.push_back(run);
    return;
  }
  if (can_be_tried_again(run, running.had_company)) return;
  next(job);
  try_others(running, how.status > 128 || !running.over.empty());
}

/// The first of a run's pictures has ended it.
void Scheduler::try_others(Running& running, bool was_ended) {
  PictureRun& run = running.run;
  const Row first = run.job().row();
  const bool is_lost = first.state == State::failed && run.is_of_scene(was_ended, first.reason);
  run.drop_first();
  if (run.jobs().empty()) return;
  if (!is_lost) {
    (running.kind == Kind::small ? m_small : m_large).push_front(run);
    return;
  }
  for (Job* job : run.jobs()) {
    job->fail_as(first);
    next(*job);
  }
}

void Scheduler::reap() {
  for (std::size_t i = 0; i < m_running.size();) {
    const auto how = m_running[i].child->ended();
    collect(m_running[i]);
    if (!how) {
      ++i;
      continue;
    }
    Running running = std::move(m_running[i]);
    m_running.erase(m_running.begin() + static_cast<std::ptrdiff_t>(i));
    ended(running, *how);
  }
}

/// What runs is asked to stop, and keeps what it has: the next batch continues it.
void Scheduler::stop_all() {
  for (Running& running : m_running) running.child->ask_to_stop();
  const auto until = Clock::now() + std::chrono::milliseconds(1500);
  while (!m_running.empty() && Clock::now() < until) {
    if (tool::wait_for_news(std::chrono::milliseconds(50)) != 0) break;  // a second signal
    std::erase_if(m_running, [this](Running& running) {
      const auto how = running.child->ended();
      collect(running);
      if (!how) return false;
      if (is_of_pictures(running.kind) && how->status == 0) {
        Job& job = running.run.job();
        job.rendered(running.run.rest(*how), false);
        if (!job.needs_views() && !job.needs_comparison()) finish(job);
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
