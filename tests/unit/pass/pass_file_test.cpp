// The file by which passes are gone on with: what comes back, what a killed run leaves, what is
// refused.
#include "tools/session/pass_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/damaged_record.h"
#include "core/pass/pass_list.h"
#include "parser/options/options.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kAtOnce{0};

class UnitPassFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
  std::string picture() const { return (folder / "a.png").string(); }
  fs::path whole() const { return folder / "a.png.lentray-passes"; }
  fs::path part() const { return folder / "a.png.lentray-passes.part"; }

  /// The records of an earlier run, by pass.
  std::vector<std::vector<std::string>> earlier(const Identity& of) {
    PassFile file(picture(), of);
    file.go_on();
    std::vector<std::vector<std::string>> out(2);
    for (std::size_t pass = 0; pass < out.size(); ++pass) {
      file.begin(pass);
      for (std::string record; file.recall(record);) out[pass].push_back(record);
    }
    return out;
  }
  /// As a run that was cut off.
  void write_some() {
    PassFile file(picture(), identity, kAtOnce);
    file.begin(0);
    file.keep("one");
    file.keep(std::string(10000, 'x'));
    file.begin(1);
    file.keep("");
    file.keep(std::string("t\0wo", 4));
  }

  const fs::path folder =
      fs::temp_directory_path() / ("lentray-" + std::to_string(::getpid()) +
                                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
  const Identity identity{"program 1", "option\n", {{{"", {17}}, {"a.inc", {4}}}}};
  const std::vector<std::vector<std::string>> kept{{"one", std::string(10000, 'x')},
                                                   {"", std::string("t\0wo", 4)}};
};

TEST_F(UnitPassFile, WhatWasKeptComesBack) {
  write_some();
  EXPECT_TRUE(fs::exists(part()));
  EXPECT_EQ(earlier(identity), kept);
  {
    PassFile file(picture(), identity, kAtOnce);
    file.go_on();
    file.begin(1);
    file.keep("three");
    file.finish();
  }
  EXPECT_FALSE(fs::exists(part()));
  EXPECT_TRUE(fs::exists(whole()));
  auto more = kept;
  more[1].push_back("three");
  EXPECT_EQ(earlier(identity), more);
  PassFile(picture(), identity).forget();
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(UnitPassFile, WithoutGoingOnItIsBegunAnew) {
  write_some();
  {
    PassFile file(picture(), identity, kAtOnce);
    file.begin(0);
    file.keep("new");
  }
  EXPECT_EQ(earlier(identity), (std::vector<std::vector<std::string>>{{"new"}, {}}));
}

TEST_F(UnitPassFile, QuickPassesLeaveNoFile) {
  {
    PassFile file(picture(), identity);
    file.begin(0);
    file.keep("one");
    file.finish();
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(UnitPassFile, WhatIsHalfWrittenIsDropped) {
  write_some();
  const auto size = fs::file_size(part());
  for (const std::uintmax_t cut : {1, 5, 40}) {
    fs::resize_file(part(), size - cut);
    const auto found = earlier(identity);
    EXPECT_EQ(found[0], kept[0]) << cut;
    EXPECT_LT(found[1].size(), 2u) << cut;
    fs::remove(part());
    write_some();
  }
  {
    std::fstream damaged(part(), std::ios::in | std::ios::out | std::ios::binary);
    damaged.seekp(static_cast<std::streamoff>(size) - 1000);
    damaged.put('y');
  }
  EXPECT_EQ(earlier(identity), (std::vector<std::vector<std::string>>{{"one"}, {}}));
}

/// A finished file that lost its end, or has more behind it, is gone on with as a part: records of both runs are kept
/// in one file.
TEST_F(UnitPassFile, AFinishedFileThatIsNotWholeIsAPart) {
  for (const int change : {-1, -5, 3}) {
    write_some();
    fs::rename(part(), whole());
    if (change < 0)
      fs::resize_file(whole(), fs::file_size(whole()) - static_cast<std::uintmax_t>(-change));
    else
      std::ofstream(whole(), std::ios::binary | std::ios::app) << "abc";
    auto expected = kept;
    if (change < 0) expected[1].pop_back();
    EXPECT_EQ(earlier(identity), expected) << change;
    {
      PassFile file(picture(), identity, kAtOnce);
      file.go_on();
      file.begin(1);
      for (std::string record; file.recall(record);) {
      }
      file.keep("three");
    }
    expected[1].emplace_back("three");
    EXPECT_EQ(earlier(identity), expected) << change;
    PassFile(picture(), identity).forget();
    EXPECT_TRUE(fs::is_empty(folder)) << change;
  }
}

TEST_F(UnitPassFile, AFileThatIsNoneIsLeft) {
  std::ofstream(whole()) << "a text";
  EXPECT_EQ(earlier(identity), (std::vector<std::vector<std::string>>(2)));
  EXPECT_TRUE(fs::exists(whole()));
}

TEST_F(UnitPassFile, AnotherScenesFileIsRefused) {
  write_some();
  Identity other = identity;
  other.seen.files["a.inc"].sum = 5;
  PassFile file(picture(), other);
  try {
    file.go_on();
    FAIL() << "goes on with what is of another scene";
  } catch (const parser::OptionError& error) {
    EXPECT_NE(std::string(error.what()).find("a.inc has changed"), std::string::npos)
        << error.what();
  }
}

TEST_F(UnitPassFile, AnotherRunsFileIsRefused) {
  write_some();
  PassFile first(picture(), identity);
  first.go_on();
  PassFile second(picture(), identity);
  EXPECT_THROW(second.go_on(), parser::OptionError);
}

TEST_F(UnitPassFile, WhatSomebodyCutsIsRemovedAtTheEndToo) {
  PassFile file(picture(), identity, kAtOnce);
  file.begin(0);
  file.keep("one");
  ASSERT_TRUE(file.write());
  fs::resize_file(part(), 0);
  file.finish();
  file.forget();
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(UnitPassFile, OthersFilesStay) {
  std::ofstream(part()) << "a text";
  PassFile(picture(), identity).forget();
  EXPECT_TRUE(fs::exists(part()));
}

TEST_F(UnitPassFile, ThePictureMayHaveItsRoom) {
  for (const bool is_done : {false, true}) {
    PassFile file(picture(), identity, kAtOnce);
    file.begin(0);
    file.keep(std::string(10000, 'x'));
    if (is_done) file.finish();
    ASSERT_TRUE(file.write());
    EXPECT_EQ(fs::exists(whole()), is_done);
    EXPECT_GE(file.bytes(), 10000u);
    EXPECT_TRUE(file.give());
    EXPECT_FALSE(fs::exists(whole()) || fs::exists(part()));
    EXPECT_EQ(file.bytes(), 0u);
    EXPECT_FALSE(file.give());
    EXPECT_NE(file.trouble().find("was given up"), std::string::npos);
    file.keep("two");
    EXPECT_FALSE(file.write());
  }
}

TEST_F(UnitPassFile, PassesGoBeforeThePicturesOwnJournal) {
  PassFile passes(picture(), identity, kAtOnce);
  PassFile other((folder / "b.png").string(), identity, kAtOnce);
  for (PassFile* const file : {&passes, &other}) {
    file->begin(0);
    file->keep(std::string(10000, 'x'));
    ASSERT_TRUE(file->write());
  }
  core::SpareRooms rooms({&passes, &other});
  EXPECT_EQ(rooms.bytes(), passes.bytes() + other.bytes());
  EXPECT_TRUE(rooms.give());
  EXPECT_EQ(passes.bytes(), 0u);
  EXPECT_GT(other.bytes(), 0u);
  EXPECT_TRUE(rooms.give());
  EXPECT_FALSE(rooms.give());
}

TEST_F(UnitPassFile, ADiskThatTakesNothingIsNoFailure) {
  fs::create_directory(part());
  PassFile file(picture(), identity, kAtOnce);
  file.begin(0);
  file.keep("one");
  file.finish();
  EXPECT_NE(file.trouble(), "");
}

/// A pass whose run is cut off at many places and gone on with ends as one that was not.
class Sums final : public core::Pass {
 public:
  explicit Sums(std::atomic<bool>& cancel, std::size_t cut) : m_cancel(cancel), m_cut(cut) {}
  std::string name() const override { return "sums"; }
  double work() const override { return 1.0; }
  void run(core::PassRun& run) override {
    run.in_order_kept<double>(
        200,
        [this](unsigned, std::size_t job) {
          ++made;
          return std::vector<double>(3, 1.0 / static_cast<double>(job + 1));
        },
        [this](std::size_t job, const std::vector<double>& values) {
          for (const double value : values) sum = sum * 1.25 + value;
          if (job == m_cut) m_cancel = true;
          return true;
        });
  }
  double sum = 0.0;
  std::atomic<int> made{0};

 private:
  std::atomic<bool>& m_cancel;
  const std::size_t m_cut;
};

/// A record that came back whole, but is no row of the pass's numbers.
TEST_F(UnitPassFile, RecordsOfAnotherKindAreRefused) {
  {
    PassFile file(picture(), identity, kAtOnce);
    file.begin(0);
    file.keep(std::string(3 * sizeof(double) + 1, 'x'));
  }
  std::atomic<bool> never{false};
  Sums pass(never, 1000);
  core::PassList passes;
  passes.add(pass);
  PassFile file(picture(), identity, kAtOnce);
  file.go_on();
  EXPECT_THROW(passes.run({.threads = 1, .ledger = &file}), core::DamagedRecord);
}

TEST_F(UnitPassFile, KilledPassesGoOn) {
  std::atomic<bool> never{false};
  Sums straight(never, 1000);
  core::PassList list;
  list.add(straight);
  ASSERT_TRUE(list.run({.threads = 2}));
  int made = 0;
  for (std::size_t cut = 10; cut <= 210; cut += 10) {
    std::atomic<bool> cancel{false};
    Sums pass(cancel, cut - 1);
    core::PassList passes;
    passes.add(pass);
    PassFile file(picture(), identity, kAtOnce);
    file.go_on();
    const bool is_whole = passes.run({.threads = 3, .cancel = &cancel, .ledger = &file});
    made += pass.made;
    if (!is_whole) {
      EXPECT_TRUE(file.write());
      continue;
    }
    EXPECT_EQ(pass.sum, straight.sum);
    EXPECT_GE(cut, 190u);
  }
  EXPECT_LT(made, 200 + 21 * 24);  // what was made ahead of a commit is lost
  EXPECT_TRUE(fs::exists(whole()));
}

}  // namespace
}  // namespace lentray::tool
