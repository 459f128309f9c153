#include "tools/lentray/stop_signals.h"

#include <semaphore.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <thread>

#include "core/image/file_swap.h"
#include "tools/lentray/run.h"

namespace lentray::tool {
namespace {

// A signal handler can reach nothing else.
std::atomic<bool> g_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);
sem_t g_came;

extern "C" void on_signal(int signal) {
  g_asked = true;
  sem_post(&g_came);
  std::signal(signal, SIG_DFL);  // the second one ends the program at once
}

/// Reading, building and a single pixel are not asked whether they should stop.
void end_late_runs() {
  while (sem_wait(&g_came) != 0 && errno == EINTR) {
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  core::FileSwap::remove_temporaries();
  tell_stopped();
  ::_exit(kAborted);
}

}  // namespace

StopSignals::StopSignals() {
  sem_init(&g_came, 0, 0);
  for (const int stop : {SIGINT, SIGTERM, SIGHUP}) {
    // Where a shell has a program ignore them, as nohup does, it stays so.
    if (std::signal(stop, on_signal) == SIG_IGN) std::signal(stop, SIG_IGN);
  }
  // A full disk, a limit on the size of files and a reader that went away fail the writing, with
  // a message, instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    std::thread(end_late_runs).detach();
  } catch (const std::system_error&) {
    // No thread to be had: then a stop takes as long as it takes.
  }
}

const std::atomic<bool>& StopSignals::asked() const { return g_asked; }

void tell_stopped() { std::fputs("lentray: stopped; no picture was written\n", stderr); }

}  // namespace lentray::tool
