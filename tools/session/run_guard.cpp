#include "tools/session/run_guard.h"

#include <semaphore.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <system_error>
#include <utility>

#include "core/base/memory_limit.h"
#include "core/base/memory_stages.h"
#include "core/image/file_swap.h"

namespace lentray::tool {
namespace {

// A signal handler can reach nothing else.
std::atomic<bool> g_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);
sem_t g_news;  ///< posted when the watch is to look at once

extern "C" void on_signal(int signal) {
  g_asked = true;
  sem_post(&g_news);
  std::signal(signal, SIG_DFL);  // the second one ends the program at once
}

/// What threads hold for themselves and what the allocator keeps is not what a user means.
double most_memory() {
  constexpr double kShare = 1.1, kFixed = 64e6;
  return kShare * core::memory_limit() + kFixed;
}

constexpr int kUserError = 1, kAborted = 2;  ///< as POV-Ray has them

/// Until there is news, or for so long.
void wait(std::chrono::milliseconds most) {
  timespec until{};
  clock_gettime(CLOCK_MONOTONIC, &until);
  constexpr long kSecond = 1'000'000'000;
  until.tv_nsec += std::chrono::nanoseconds(most).count();
  until.tv_sec += until.tv_nsec / kSecond;
  until.tv_nsec %= kSecond;
  sem_clockwait(&g_news, CLOCK_MONOTONIC, &until);
}

}  // namespace

void RunGuard::end(int status) const {
  core::FileSwap::remove_temporaries();
  if (m_keep) m_keep();
  ::_exit(status);
}

void RunGuard::end_if_too_large() const {
  if (core::resident_bytes() <= most_memory()) return;
  std::fprintf(stderr,
               "lentray: the scene and the picture take more memory than is allowed (Max_Memory): "
               "%s, while %s\n",
               core::memory_text(core::memory_limit()).c_str(), core::current_stage());
  end(kUserError);
}

/// Memory grows by a few MB a millisecond at most.
void RunGuard::watch(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kLook{20}, kGrace{800};
  while (!g_asked) {
    wait(kLook);
    if (stop.stop_requested()) return;
    end_if_too_large();
    if (!g_asked && Clock::now() >= m_deadline.load()) {
      m_time_is_over = true;
      g_asked = true;
    }
  }
  // A file's tokens, building and a single pixel do not look whether they should stop.
  for (const auto late = Clock::now() + kGrace; Clock::now() < late;) {
    std::this_thread::sleep_for(kLook);
    if (stop.stop_requested()) return;
    end_if_too_large();
  }
  tell_stopped();
  end(kAborted);
}

RunGuard::RunGuard(std::function<void()> keep) : m_keep(std::move(keep)) {
  sem_init(&g_news, 0, 0);
  for (const int stop : {SIGINT, SIGTERM, SIGHUP}) {
    // Where a shell has a program ignore them, as nohup does, it stays so.
    if (std::signal(stop, on_signal) == SIG_IGN) std::signal(stop, SIG_IGN);
  }
  // A full disk, a limit on the size of files and a reader that went away fail the writing, with
  // a message, instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    m_watch = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  } catch (const std::system_error&) {
    // No thread to be had: then a stop takes as long as it takes, and only what asks for room is
    // refused.
  }
}

RunGuard::~RunGuard() {
  m_watch.request_stop();
  sem_post(&g_news);
}

void RunGuard::limit_time(double seconds) {
  constexpr double kLongest = 1e9;  // the clock's numbers hold it
  m_deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double>(std::min(seconds, kLongest)));
}

void RunGuard::limit_memory(double bytes) { core::limit_memory(bytes); }

const std::atomic<bool>& RunGuard::asked() const { return g_asked; }

void RunGuard::tell_stopped() const {
  std::fputs(m_time_is_over ? "lentray: the time is over (Max_Time); the picture was not written\n"
                            : "lentray: stopped; the picture was not written\n",
             stderr);
}

}  // namespace lentray::tool
