#include "tools/session/picture_journal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "tools/common/process.h"

namespace lentray::tool {
namespace {

using core::Pixel;
namespace fs = std::filesystem;

struct UnitPictureJournal : testing::Test {
  std::string picture() const { return (folder / "a.png").string(); }
  std::string file() const { return journal_path(picture()); }
  Identity identity() const { return identity_of(options, {}); }
  PictureJournal journal() const {
    return {picture(), 20, 10, identity(), std::chrono::milliseconds(0)};
  }

  void keep(PictureJournal& journal, std::size_t stage, std::vector<Pixel> pixels) {
    std::vector<float> values;
    for (const Pixel& p : pixels)
      values.insert(values.end(), {p.column + 0.25f, p.row + 0.5f, 1.0f * stage, 1.0f});
    journal.add(stage, pixels, values);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, float> all(PictureJournal& journal,
                                                               std::size_t stage,
                                                               std::uint32_t top = 0,
                                                               std::uint32_t bottom = 10) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, float> out;
    journal.recall(stage, top, bottom, [&](const Pixel& p, const float* v) {
      EXPECT_EQ(v[1], p.row + 0.5f);
      out[{p.column, p.row}] = v[0];
    });
    return out;
  }

  tool::TemporaryFolder folder;
  parser::RenderOptions options;
};

TEST_F(UnitPictureJournal, GoesOnWithWhatWasKept) {
  {
    PictureJournal first = journal();
    EXPECT_FALSE(fs::exists(file()));
    keep(first, 0, {{3, 4}, {4, 4}});
    keep(first, 1, {{3, 9}});
    EXPECT_TRUE(first.keep());
  }
  ASSERT_TRUE(fs::exists(file()));
  PictureJournal second = journal();
  second.go_on();
  ASSERT_TRUE(second.known(0));
  EXPECT_TRUE(second.known(0)->has({4, 4}));
  EXPECT_FALSE(second.known(0)->has({3, 9}));
  EXPECT_TRUE(second.known(1)->has({3, 9}));
  EXPECT_EQ(all(second, 0).size(), 2u);
  EXPECT_EQ((all(second, 0)[{4, 4}]), 4.25f);
  EXPECT_EQ(all(second, 0, 5, 10).size(), 0u);
  keep(second, 0, {{0, 0}});
  second.finish(false);
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(UnitPictureJournal, WhatIsHalfWrittenIsDropped) {
  {
    PictureJournal first = journal();
    keep(first, 0, {{3, 4}});
    first.keep();
  }
  const auto whole = fs::file_size(file());
  {
    PictureJournal second = journal();
    second.go_on();
    keep(second, 0, {{5, 5}, {6, 5}});
    second.keep();
  }
  const auto size = fs::file_size(file());
  for (const auto left : {size - 1, size - 40, whole + 10, whole}) {
    fs::resize_file(file(), left);
    PictureJournal third = journal();
    third.go_on();
    EXPECT_EQ(all(third, 0).size(), 1u) << left;
    EXPECT_EQ(fs::file_size(file()), whole);
  }
  // And a byte that is another.
  std::fstream bytes(file(), std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekp(static_cast<std::streamoff>(whole) - 2);
  bytes.put('?');
  bytes.close();
  PictureJournal last = journal();
  last.go_on();
  EXPECT_EQ(last.known(0), nullptr);
}

TEST_F(UnitPictureJournal, OtherPicturesAreRefused) {
  {
    PictureJournal first = journal();
    keep(first, 0, {{3, 4}});
  }
  options.antialias_depth = 5;
  PictureJournal second = journal();
  try {
    second.go_on();
    FAIL();
  } catch (const parser::OptionError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("begun with Antialias_Depth=3, and now there is Antialias_Depth=5"),
              std::string::npos)
        << error.what();
  }
  options.antialias_depth = 3;
  PictureJournal one = journal();
  one.go_on();
  PictureJournal other = journal();
  EXPECT_THROW(other.go_on(), parser::OptionError) << "another is at it";
}

TEST_F(UnitPictureJournal, FramesSayThatTheyAreFinished) {
  {
    PictureJournal first = journal();
    first.finish(true);
  }
  const auto earlier = PictureJournal::earlier(picture());
  ASSERT_TRUE(earlier);
  EXPECT_TRUE(earlier->is_finished);
  EXPECT_EQ(difference(earlier->identity, identity()), "");
  PictureJournal::forget(picture());
  EXPECT_FALSE(fs::exists(file()));
  EXPECT_FALSE(PictureJournal::earlier(picture()));
}

/// Cut to nothing, or to a part of its head, or written over; exchanged it is another's.
TEST_F(UnitPictureJournal, WhatSomebodyDidToItGoesWithIt) {
  for (const int change : {0, 1, 2, 3}) {
    PictureJournal first = journal();
    keep(first, 0, {{3, 4}, {4, 4}});
    ASSERT_TRUE(first.keep());
    if (change == 0) fs::resize_file(file(), 0);
    if (change == 1) fs::resize_file(file(), 10);
    if (change == 2) std::ofstream(file()) << "my notes";
    if (change == 3) {
      fs::remove(file());
      std::ofstream(file()) << "my notes";
    }
    first.finish(false);
    EXPECT_EQ(fs::exists(file()), change == 3) << change;
    fs::remove(file());
  }
}

TEST_F(UnitPictureJournal, FilesThatAreNoJournalsStay) {
  std::ofstream(file()) << "my notes";
  {
    PictureJournal first = journal();
    first.go_on();
    EXPECT_EQ(first.known(0), nullptr);
    first.finish(false);
  }
  PictureJournal::forget(picture());
  EXPECT_TRUE(fs::exists(file()));
}

TEST_F(UnitPictureJournal, SilentAtFirst) {
  PictureJournal slow(picture(), 20, 10, identity());
  EXPECT_FALSE(slow.listens());
  EXPECT_TRUE(journal().listens());
}

TEST_F(UnitPictureJournal, IdentitiesSayWhatIsDifferent) {
  Identity then = identity();
  then.seen.files = {{"", {1}}, {"a b.inc", {2}}};
  const Identity read = Identity::of_text(then.text());
  EXPECT_EQ(difference(then, read), "");
  Identity now = then;
  now.seen.files["a b.inc"].sum = 3;
  EXPECT_EQ(difference(then, now), "a b.inc has changed");
  now = then;
  now.seen.files.erase("");
  EXPECT_EQ(difference(then, now), "the scene is not read any more");
  now = then;
  now.program = "0.0";
  EXPECT_EQ(difference(then, now), "another version of the program began it");
  EXPECT_NE(then.program.find(' '), std::string::npos);
  EXPECT_EQ(then.program.substr(then.program.find(' ') + 1).size(), 16u) << "the linker's build id";
  EXPECT_NE(change_in(then.seen, "/dev/null"), "");
  options.threads = 3;
  options.pixel_order = "rows";
  EXPECT_EQ(difference(identity(), Identity::of_text(identity_of({}, {}).text())), "")
      << "no pixel depends on them";
}

}  // namespace
}  // namespace lentray::tool
