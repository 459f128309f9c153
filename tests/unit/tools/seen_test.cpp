// What a scene saw outside, and what has changed of it since.
#include <gtest/gtest.h>

#include <filesystem>

#include "parser/files/watched_files.h"
#include "tools/common/process.h"
#include "tools/session/identity.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

class UnitSeen : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& text) const {
    write_text(m_folder / name, text);
    return (m_folder / name).string();
  }
  void make_old(const std::string& path) const {
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }
  const TemporaryFolder m_folder;
};

TEST_F(UnitSeen, NamesWhatHasChangedOnTheDisk) {
  const std::string a = put("a.pov", "one"), found = put("found.inc", "");
  const std::string vain = (m_folder / "vain.inc").string();
  const Seen seen{.files = {{a, *stamp_of(a)}}, .missing = {vain}, .there = {found}};
  EXPECT_EQ(change_in(seen), "");
  fs::create_directory(vain);
  EXPECT_EQ(change_in(seen), "") << "a folder is no file";
  fs::remove(vain);
  put("vain.inc", "");
  EXPECT_EQ(change_in(seen), vain + " has come to be");
  fs::remove(vain);
  fs::remove(found);
  EXPECT_EQ(change_in(seen), found + " is gone");
  put("found.inc", "what is in it does not count");
  EXPECT_EQ(change_in(seen), "");
  make_old(a);
  EXPECT_EQ(change_in(seen), "") << "touched, but the same";
  put("a.pov", "two");
  EXPECT_EQ(change_in(seen), a + " has changed");
  fs::remove(a);
  EXPECT_EQ(change_in(seen), a + " is gone");
}

TEST_F(UnitSeen, AFileThatIsYoungIsLookedAt) {
  const std::string a = put("a.inc", "one");
  const std::uint64_t sum = parser::checksum("one");
  const std::int64_t later = now() + 10'000'000'000;
  EXPECT_NE(stamp_read(a, sum, later).changed, 0) << "it had been there for long";
  EXPECT_EQ(stamp_read(a, sum, now()).changed, 0) << "it came just then";
  EXPECT_EQ(stamp_read(a, sum, 0).changed, 0) << "nobody knows when it was read";
  make_old(a);
  EXPECT_EQ(stamp_read(a, sum, now()).changed, 0) << "an old file that came just then";
}

/// As reproducible archives and `rsync -a` leave them.
TEST_F(UnitSeen, OtherContentsOfOneSizeAndTime) {
  const std::string a = put("a.inc", "one"), b = put("b.inc", "two");
  make_old(a);
  fs::last_write_time(b, fs::last_write_time(a));
  const FileStamp stamp = stamp_read(a, parser::checksum("one"), now() + 10'000'000'000);
  EXPECT_TRUE(is_as_it_was(a, stamp));
  fs::rename(b, a);
  EXPECT_FALSE(is_as_it_was(a, stamp));
}

TEST_F(UnitSeen, NamesWhatAnotherReadingSawOtherwise) {
  const Seen then{{{"", {1}}, {"a.inc", {2}}}, {"vain"}, {"found"}, "a.pov", 9000.5};
  EXPECT_EQ(change_of(then, then), "");
  const auto with = [&then](auto change) {
    Seen now = then;
    change(now);
    return change_of(then, now);
  };
  EXPECT_EQ(with([](Seen& s) { s.files[""].sum = 3; }), "the scene has changed");
  EXPECT_EQ(with([](Seen& s) { s.files.erase("a.inc"); }), "a.inc is not read any more");
  EXPECT_EQ(with([](Seen& s) { s.missing.clear(); }), "vain has come to be");
  EXPECT_EQ(with([](Seen& s) { s.there.clear(); }), "found is gone");
  EXPECT_EQ(with([](Seen& s) { s.there.insert("vain"); }), "vain has come to be");
  EXPECT_EQ(with([](Seen& s) { s.name = "b.pov"; }), "input_file_name was 'a.pov' and is 'b.pov'");
  EXPECT_EQ(with([](Seen& s) { s.now = 9001.0; }), "the scene asks for `now`, which is another");
}

TEST_F(UnitSeen, FramesNeedAgreeOnlyOfWhatBothAskedFor) {
  const Seen then{{{"", {1}}, {"a.inc", {2}}}, {"vain"}, {"found"}, "a.pov", 9000.5};
  EXPECT_EQ(change_in_common(then, {{{"", {1}}, {"b.inc", {3}}}, {"other"}, {"else"}, "", 9001.0}),
            "");
  EXPECT_EQ(change_in_common(then, {{{"a.inc", {3}}}}), "a.inc has changed");
  EXPECT_EQ(change_in_common(then, {{{"vain", {3}}}}), "vain has come to be");
  EXPECT_EQ(change_in_common(then, {{}, {}, {"vain"}}), "vain has come to be");
  EXPECT_EQ(change_in_common(then, {{}, {"found"}}), "found is gone");
  EXPECT_EQ(change_in_common(then, {{}, {"a.inc"}}), "a.inc is gone");
  EXPECT_EQ(change_in_common(then, {{{"found", {3}}}, {}, {"a.inc"}}), "");
}

TEST_F(UnitSeen, AnIdentityIsReadBackAndNamesWhatDiffers) {
  const Identity one{"1.0 abc",
                     "Width=1\nDeclare=\"A=\n\"\n",
                     {{{"", {1}}, {"a\n\xe9.inc", {0xffffffffffffffff}}},
                      {"vain"},
                      {"found"},
                      "a.pov",
                      9801.1234567890123}};
  const Identity back = Identity::of_text(one.text());
  EXPECT_EQ(back.text(), one.text());
  EXPECT_EQ(back.seen, one.seen);
  EXPECT_EQ(difference(one, back), "");
  EXPECT_THROW(Identity::of_text("program 1.0\n"), std::invalid_argument);
  EXPECT_THROW(Identity::of_text("{}"), std::invalid_argument);
  Identity other = one;
  other.options = "Width=2\n";
  EXPECT_EQ(difference(one, other), "it was begun with Width=1, and now there is Width=2");
}

}  // namespace
}  // namespace lentray::tool
