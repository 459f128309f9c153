// Whom a batch lets wait for whom: pictures that take long, or never end, beside small ones. The program that renders
// is a script, so that seconds are tenths.
#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>

#include <algorithm>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include "tools/common/process.h"
#include "tools/lentray-batch/scheduler.h"

namespace lentray::batch {
namespace {

namespace fs = std::filesystem;

/// Asks this thread to stop by the signal that a user sends, after so long, unless it goes before.
class Watchdog {
 public:
  explicit Watchdog(std::chrono::seconds patience) : m_who(pthread_self()) {
    sigset_t stops;
    sigemptyset(&stops);
    sigaddset(&stops, SIGTERM);
    pthread_sigmask(SIG_SETMASK, nullptr, &m_before);
    pthread_sigmask(SIG_BLOCK, &stops, nullptr);
    tool::hold_signals();
    m_thread = std::thread([this, patience] {
      std::unique_lock lock(m_mutex);
      if (!m_gone.wait_for(lock, patience, [this] { return m_is_gone; })) stop();
    });
  }
  ~Watchdog() {
    {
      const std::lock_guard lock(m_mutex);
      m_is_gone = true;
    }
    m_gone.notify_all();
    m_thread.join();
    timespec none{};
    sigset_t stops;
    sigemptyset(&stops);
    sigaddset(&stops, SIGTERM);
    while (sigtimedwait(&stops, nullptr, &none) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
  }
  void stop() const { pthread_kill(m_who, SIGTERM); }

 private:
  const pthread_t m_who;
  sigset_t m_before{};
  std::mutex m_mutex;
  std::condition_variable m_gone;
  bool m_is_gone = false;
  std::thread m_thread;
};

class UnitBatchScheduler : public testing::Test {
 protected:
  /// `long.pov` takes 0.7 s, of all its runs together; `never*.pov` does not end. Others fail at once, which is an end.
  UnitBatchScheduler() {
    const std::string work = (m_folder / "done").string();
    tool::write_text(m_folder / "lentray",
                     "#!/bin/sh\ntrap 'exit 2' TERM\ncase \"$*\" in\n"
                     "*+Inever*) while :; do sleep 0.02; done;;\n"
                     "*+Ilong.pov*) while [ \"$(wc -c < '" +
                         work + "')\" -lt 14 ]; do sleep 0.05; printf x >> '" + work +
                         "'; done;;\nesac\necho 'lentray: ended'\nexit 1\n");
    tool::write_text(m_folder / "done", "");
    fs::permissions(m_folder / "lentray", fs::perms::owner_all);
    fs::create_directories(m_folder / "in");
  }

  /// The names in the order in which they ended, until all but `endless` have, or 20 s are over.
  std::vector<std::string> order(const std::vector<std::string>& names, std::size_t endless,
                                 int jobs) const {
    std::vector<std::string> words{(m_folder / "in").string(), "--out", (m_folder / "out").string(),
                                   "--lentray", (m_folder / "lentray").string()};
    const StateFolder state(m_folder / "out");
    Plan plan;
    plan.arguments = parse_arguments(words);
    plan.arguments.jobs = jobs;
    plan.processors = 2;
    plan.memory = 4e9;
    plan.turn = 0.3;
    plan.state = &state;
    Watchdog watchdog(std::chrono::seconds(20));
    std::vector<std::string> ended;
    BatchProgress progress(names.size(), 0, 0, true);
    Scheduler scheduler(
        plan,
        [&](const Row& row) {
          ended.push_back(row.name);
          if (ended.size() + endless == names.size()) watchdog.stop();
        },
        progress);
    for (const std::string& name : names) {
      const Scene scene{m_folder / "in" / (name + ".pov"), name, "", {}};
      tool::write_text(scene.source, "camera { location -5*z }\n");
      scheduler.add(std::make_unique<Job>(plan, scene, options_of(plan, scene), std::nullopt));
    }
    EXPECT_EQ(scheduler.run(), endless == 0);
    return ended;
  }

  const tool::TemporaryFolder m_folder;
};

using Order = std::vector<std::string>;

TEST_F(UnitBatchScheduler, WhatNeverEndsHoldsUpNoSmallOnesOfASingleJob) {
  EXPECT_EQ(order({"never", "a", "b", "c"}, 1, 1), (Order{"a", "b", "c"}));
}

TEST_F(UnitBatchScheduler, LongOnesTakeTurns) {
  EXPECT_EQ(order({"never", "never2", "a", "long"}, 2, 1), (Order{"a", "long"}));
}

TEST_F(UnitBatchScheduler, LongOnesTakeTurnsOnAllProcessors) {
  EXPECT_EQ(order({"never", "never2", "a", "long"}, 2, 2), (Order{"a", "long"}));
}

TEST_F(UnitBatchScheduler, ALongOneThatNoneWaitsForIsNotStopped) {
  tool::write_text(m_folder / "lentray",
                   "#!/bin/sh\ntrap 'echo stopped >> \"$0.log\"; exit 2' TERM\n"
                   "case \"$*\" in *+Ilong.pov*) sleep 0.9;; esac\nexit 1\n");
  EXPECT_EQ(order({"a", "b", "long"}, 0, 1), (Order{"a", "b", "long"}));
  EXPECT_FALSE(fs::exists(m_folder / "lentray.log"));
}

}  // namespace
}  // namespace lentray::batch
