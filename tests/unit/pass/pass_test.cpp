// Passes: jobs on many threads with commits in order, progress over passes and film, cancelling, and
// records that a pass goes on with.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/pass/pass_list.h"

namespace lentray::core {
namespace {

using Run = std::function<void(PassRun&)>;

class FunctionPass final : public Pass {
 public:
  explicit FunctionPass(Run run, double work = 1.0) : m_run(std::move(run)), m_work(work) {}
  std::string name() const override { return "test"; }
  double work() const override { return m_work; }
  void run(PassRun& run) override { m_run(run); }

 private:
  Run m_run;
  double m_work;
};

bool run_alone(const Run& run, const PassOptions& options) {
  FunctionPass pass(run);
  PassList list;
  list.add(pass);
  return list.run(options);
}

/// Records in memory; those of `earlier` are recalled.
class Records final : public PassLedger {
 public:
  explicit Records(std::vector<std::string> earlier = {}) : m_earlier(std::move(earlier)) {}
  void begin(std::size_t) override {}
  bool recall(std::string& record) override {
    if (kept.size() == m_earlier.size()) return false;
    record = m_earlier[kept.size()];
    kept.push_back(record);
    return true;
  }
  void keep(std::string_view record) override { kept.emplace_back(record); }
  void finish() override { is_finished = true; }
  std::vector<std::string> kept;
  bool is_finished = false;

 private:
  std::vector<std::string> m_earlier;
};

/// A chain in which each commit depends on all before it.
double chain(unsigned threads, std::size_t jobs, PassLedger* ledger = nullptr,
             std::size_t cut_at = ~std::size_t{0}, std::size_t* made = nullptr) {
  double sum = 1.0;
  std::atomic<bool> cancel{false};
  std::atomic<std::size_t> makes{0};
  run_alone(
      [&](PassRun& run) {
        run.in_order_kept<double>(
            jobs,
            [&](unsigned, std::size_t job) {
              ++makes;
              if (job % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
              return std::vector<double>{std::sqrt(static_cast<double>(job)), 0.5};
            },
            [&](std::size_t job, const std::vector<double>& made_now) {
              sum = sum * 0.99 + made_now[0] + made_now[1] * static_cast<double>(job % 3);
              if (job == cut_at) cancel = true;
              return true;
            });
      },
      {.threads = threads, .cancel = &cancel, .ledger = ledger});
  if (made) *made = makes;
  return sum;
}

TEST(UnitPass, EachJobIsDoneOnce) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    std::vector<std::atomic<int>> done(1000);
    ASSERT_TRUE(run_alone(
        [&](PassRun& run) {
          EXPECT_EQ(run.threads(), threads);
          for (int round = 0; round < 50; ++round) {
            run.each(done.size(), [&](unsigned thread, std::size_t job) {
              EXPECT_LT(thread, threads);
              ++done[job];
            });
          }
        },
        {.threads = threads}));
    for (const auto& times : done) ASSERT_EQ(times, 50);
  }
}

TEST(UnitPass, ManyShortSharesEnd) {
  std::atomic<std::size_t> sum{0};
  ASSERT_TRUE(run_alone(
      [&](PassRun& run) {
        for (int i = 0; i < 70000; ++i) run.each(2, [&](unsigned, std::size_t job) { sum += job; });
      },
      {.threads = 3}));
  EXPECT_EQ(sum, 70000u);
}

TEST(UnitPass, ThreadsWorkAtOnce) {
  // Each of two jobs waits for the other.
  std::atomic<int> there{0};
  ASSERT_TRUE(run_alone(
      [&](PassRun& run) {
        run.each(2, [&](unsigned, std::size_t) {
          ++there;
          while (there < 2) std::this_thread::yield();
        });
      },
      {.threads = 2}));
}

TEST(UnitPass, CommitsComeInOrder) {
  const double one = chain(1, 3000);
  for (const unsigned threads : {2u, 3u, 5u}) EXPECT_EQ(chain(threads, 3000), one);
}

TEST(UnitPass, CommitsMayEndTheJobs) {
  for (const unsigned threads : {1u, 4u}) {
    std::vector<std::size_t> committed;
    std::size_t ended = 0;
    ASSERT_TRUE(run_alone(
        [&](PassRun& run) {
          ended = run.in_order(
              3, 1000, [](unsigned, std::size_t job) { return job; },
              [&](std::size_t job, std::size_t result) {
                EXPECT_EQ(job, result);
                committed.push_back(job);
                return job < 41;
              });
        },
        {.threads = threads}));
    EXPECT_EQ(ended, 42u);
    ASSERT_EQ(committed.size(), 39u);
    for (std::size_t i = 0; i < committed.size(); ++i) EXPECT_EQ(committed[i], i + 3);
  }
}

TEST(UnitPass, CutOffPassesGoOn) {
  const double whole = chain(2, 2000);
  for (const std::size_t cut : {0u, 1u, 500u, 1998u}) {
    Records first;
    chain(3, 2000, &first, cut);
    EXPECT_FALSE(first.is_finished);
    EXPECT_GE(first.kept.size(), cut + 1);
    Records second(first.kept);
    std::size_t made = 0;
    EXPECT_EQ(chain(2, 2000, &second, ~std::size_t{0}, &made), whole);
    EXPECT_TRUE(second.is_finished);
    EXPECT_EQ(made, 2000 - first.kept.size());
    // All of it is known: nothing is made.
    Records third(second.kept);
    EXPECT_EQ(chain(2, 2000, &third, ~std::size_t{0}, &made), whole);
    EXPECT_EQ(made, 0u);
  }
}

TEST(UnitPass, CancelEndsSoon) {
  std::atomic<bool> cancel{false};
  const auto start = std::chrono::steady_clock::now();
  std::atomic<std::size_t> done{0};
  const bool whole = run_alone(
      [&](PassRun& run) {
        run.each(1 << 30, [&](unsigned, std::size_t) {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
          if (++done == 20) cancel = true;
        });
        FAIL() << "goes on after a cancel";
      },
      {.threads = 2, .cancel = &cancel});
  EXPECT_FALSE(whole);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_LE(done, 25u);
}

TEST(UnitPass, FailuresReachTheCaller) {
  for (const unsigned threads : {1u, 3u}) {
    EXPECT_THROW(run_alone(
                     [](PassRun& run) {
                       run.each(100, [](unsigned, std::size_t job) {
                         if (job == 50) throw std::runtime_error("job");
                       });
                     },
                     {.threads = threads}),
                 std::runtime_error);
    EXPECT_THROW(run_alone(
                     [](PassRun& run) {
                       run.in_order(
                           0, 1000, [](unsigned, std::size_t job) { return job; },
                           [](std::size_t job, std::size_t) {
                             if (job == 50) throw std::logic_error("commit");
                             return true;
                           });
                     },
                     {.threads = threads}),
                 std::logic_error);
  }
}

TEST(UnitPass, ReportsHaveTheNumbersInOrder) {
  FunctionPass pass([](PassRun& run) {
    run.count("samples", 12.0);
    run.count("gathers", 3.0);
  });
  PassList list;
  list.add(pass);
  list.add(pass);
  ASSERT_TRUE(list.run({.threads = 2}));
  ASSERT_EQ(list.reports().size(), 2u);
  EXPECT_EQ(list.reports()[1].name, "test");
  EXPECT_EQ(list.reports()[1].numbers, (PassNumbers{{"samples", 12.0}, {"gathers", 3.0}}));
  EXPECT_GE(list.reports()[1].wall_s, 0.0);
}

struct SaidProgress final : Progress {
  void advance(double fraction_done, double seconds_left) override {
    fractions.push_back(fraction_done);
    left.push_back(seconds_left);
  }
  std::vector<double> fractions, left;
};

TEST(UnitPass, ProgressIsOfPassesAndFilmTogether) {
  const auto wait = [](PassRun& run) {
    for (int i = 1; i <= 10; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(70));
      run.advance(0.1 * i);
    }
  };
  FunctionPass first(wait, 30.0), second(wait, 20.0);
  PassList list;
  list.add(first);
  list.add(second);
  SaidProgress said;
  ASSERT_TRUE(list.run({.progress = &said, .film_work = 50.0}));
  ASSERT_GE(said.fractions.size(), 1u);  // of the second pass: the first second is silent
  EXPECT_LE(said.fractions.size(), 3u);
  for (std::size_t i = 0; i < said.fractions.size(); ++i) {
    EXPECT_GT(said.fractions[i], 0.3);
    EXPECT_LE(said.fractions[i], 0.5);
    EXPECT_GT(said.left[i], 0.5);  // the film's share is as long as both
  }
  list.film_progress()->advance(0.5, 7.0);
  EXPECT_DOUBLE_EQ(said.fractions.back(), 0.75);
  EXPECT_DOUBLE_EQ(said.left.back(), 7.0);
  list.film_progress()->advance(1.0, 0.0);
  EXPECT_DOUBLE_EQ(said.fractions.back(), 1.0);
}

TEST(UnitPass, WithoutPassesTheFilmSpeaksForItself) {
  PassList list;
  SaidProgress said;
  ASSERT_TRUE(list.run({.progress = &said, .film_work = 50.0}));
  EXPECT_EQ(list.film_progress(), &said);
  ASSERT_TRUE(list.run({}));
  EXPECT_EQ(list.film_progress(), nullptr);
}

}  // namespace
}  // namespace lentray::core
