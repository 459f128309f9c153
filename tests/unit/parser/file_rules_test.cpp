// Where scenes may read and write: povray.conf, the rules, files judged as they are opened, and writes that
// stay in memory.
#include "parser/restrictions/file_rules.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "parser/base/shown.h"
#include "parser/files/memory_writes.h"
#include "parser/restrictions/povray_conf.h"
#include "parser/restrictions/restricted_files.h"
#include "tools/common/process.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;
using tool::read_text;
using tool::write_text;

/// Folders "work" (the scene's, with "sub") and "outside", which has a file "secret".
class UnitFileRules : public ::testing::Test {
 protected:
  UnitFileRules()
      : root(fs::canonical(m_folder.path())), work(root / "work"), outside(root / "outside") {
    fs::create_directories(work / "sub");
    fs::create_directories(outside);
    write_text(outside / "secret", "secret");
    write_text(work / "plain", "plain");
  }
  FileRules rules(const std::string& conf_text = "") const {
    std::vector<PovrayConf> confs;
    if (!conf_text.empty()) confs.push_back(parse_povray_conf(conf_text, "conf", {}));
    return FileRules({work, work, {}, {}}, confs);
  }
  std::string conf_line(const std::string& kind, const fs::path& folder) const {
    return "[Permitted Paths]\n" + kind + " = \"" + folder.string() + "\"\n";
  }

 private:
  tool::TemporaryFolder m_folder;

 protected:
  const fs::path root, work, outside;
};

constexpr const char* kRestricted = "[File I/O Security]\nrestricted\n";

TEST(UnitPovrayConf, Sections) {
  const PovrayConf conf = parse_povray_conf(
      "; comment\n[File I/O Security]\n;none\nread-only ; words\n\n[Shellout Security]\nallowed\r\n"
      "[Permitted Paths]\nread = /\nread* = %INSTALLDIR%\nread+write=\"%HOME%\"\n read+write* = "
      "'/usr' ;x\n"
      "read = /no/such/folder\nwrite = /\n[Other]\nx = y\n",
      "c", {"/usr", "/var"});
  EXPECT_EQ(conf.files, PovrayConf::FileSecurity::kReadOnly);
  EXPECT_EQ(conf.shellout, PovrayConf::Shellout::kAllowed);
  ASSERT_EQ(conf.permitted.size(), 4u);
  EXPECT_EQ(conf.permitted[0].folder, "/");
  EXPECT_FALSE(conf.permitted[0].below);
  EXPECT_TRUE(conf.permitted[1].below);
  EXPECT_FALSE(conf.permitted[1].writing);
  EXPECT_EQ(conf.permitted[2].folder, "/var");
  EXPECT_TRUE(conf.permitted[2].writing);
  EXPECT_TRUE(conf.permitted[3].below && conf.permitted[3].writing);
  ASSERT_EQ(conf.warnings.size(), 1u);
  EXPECT_TRUE(conf.warnings[0].starts_with("c:14: ")) << conf.warnings[0];
}

TEST(UnitPovrayConf, WhatIsNotUnderstoodForbids) {
  const PovrayConf conf =
      parse_povray_conf("[File I/O Security]\nopen\n[Shellout Security]\nyes\n", "c", {});
  EXPECT_EQ(conf.files, PovrayConf::FileSecurity::kRestricted);
  EXPECT_EQ(conf.shellout, PovrayConf::Shellout::kForbidden);
  EXPECT_EQ(conf.warnings.size(), 2u);
}

TEST(UnitPovrayConf, ShelloutNeedsOneThatAllowsAndNoneThatForbids) {
  PovrayConf allows, forbids, silent;
  allows.shellout = PovrayConf::Shellout::kAllowed;
  forbids.shellout = PovrayConf::Shellout::kForbidden;
  EXPECT_FALSE(shellout_allowed({}));
  EXPECT_FALSE(shellout_allowed({silent}));
  EXPECT_TRUE(shellout_allowed({allows}));
  EXPECT_TRUE(shellout_allowed({allows, silent}));
  EXPECT_FALSE(shellout_allowed({allows, forbids}));
  EXPECT_FALSE(shellout_allowed({forbids, allows}));
}

TEST_F(UnitFileRules, UsersFolders) {
  const FileRules r = rules();
  for (const char* name : {"a", "sub/a", "sub/deeper/a"}) {
    EXPECT_EQ(r.against_reading(work / name), "") << name;
    EXPECT_EQ(r.against_writing(work / name), "") << name;
  }
  EXPECT_NE(r.against_reading(root / "a"), "");
  EXPECT_NE(r.against_reading(root / "worker"), "") << "a name that only begins alike";
  EXPECT_NE(r.against_reading(outside / "secret"), "");
  EXPECT_NE(r.against_writing(outside / "a"), "");
  EXPECT_NE(r.against_reading("pipe:[123]"), "");
  EXPECT_NE(r.against_reading(""), "");
  for (const char* name :
       {".bashrc", "povray.ini", ".povray/3.7/povray.conf", "sub/povray.conf", "sub/.x/y", "a.ini",
        "A.INI", "lens_sheets.ini", "a.png.lentray-state", "a.png.lentray-passes.part",
        "x.lentray-light", "object.rca", "manifest.jsonl", "state.json", "sub/a.ini/b"}) {
    EXPECT_NE(r.against_writing(work / name), "") << name;
  }
}

/// A relative library path is no place to read where a link is on the way: it may have come with the scene.
TEST_F(UnitFileRules, LinksAreNoLibraries) {
  fs::create_directory_symlink(outside, work / "lib");
  fs::create_directory_symlink("sub", work / "inside");
  fs::create_directory(outside / "deep");
  const fs::path before = fs::current_path();
  fs::current_path(work);
  const auto reads = [this](const std::string& library) {
    return FileRules({work, work, {library}, {}}, {}).against_reading(outside / "secret").empty();
  };
  EXPECT_FALSE(reads("lib"));
  EXPECT_FALSE(reads("lib/"));
  EXPECT_FALSE(reads("lib/deep/.."));
  EXPECT_TRUE(reads("../outside"));
  EXPECT_TRUE(reads("./../outside/."));
  EXPECT_TRUE(reads(work / "lib")) << "a whole name is the user's";
  fs::current_path(before);
}

TEST_F(UnitFileRules, Conf) {
  EXPECT_NE(rules(kRestricted).against_reading(outside / "a"), "");
  EXPECT_NE(rules("[File I/O Security]\nnone\n").against_reading(outside / "a"), "")
      << "none permits nothing more";
  const FileRules reads_all = rules("[File I/O Security]\nread-only\n");
  EXPECT_EQ(reads_all.against_reading(outside / "a"), "");
  EXPECT_NE(reads_all.against_writing(outside / "a"), "");
  const FileRules flat = rules(kRestricted + conf_line("read", outside));
  EXPECT_EQ(flat.against_reading(outside / "a"), "");
  EXPECT_NE(flat.against_reading(outside / "b/a"), "");
  EXPECT_NE(flat.against_writing(outside / "a"), "");
  const FileRules deep = rules(kRestricted + conf_line("read+write*", outside));
  EXPECT_EQ(deep.against_reading(outside / "b/a"), "");
  EXPECT_EQ(deep.against_writing(outside / "b/a"), "");
  EXPECT_NE(deep.against_writing(outside / ".b/a"), "");
}

TEST_F(UnitFileRules, TheStrictestConfHolds) {
  const PovrayConf open = parse_povray_conf(kRestricted + conf_line("read*", outside), "a", {});
  const PovrayConf closed = parse_povray_conf(kRestricted, "b", {});
  const FileRules both({work, work, {}, {}}, {open, closed});
  EXPECT_NE(both.against_reading(outside / "a"), "");
  const FileRules one({work, work, {}, {}}, {open, parse_povray_conf("", "b", {})});
  EXPECT_EQ(one.against_reading(outside / "a"), "");
}

/// A link that changes between a file inside and one outside is judged by what was opened.
TEST_F(UnitFileRules, ExchangedLink) {
  RestrictedFiles files(rules());
  fs::create_symlink(work / "plain", work / "in");
  fs::create_symlink(outside / "secret", work / "out");
  fs::copy_symlink(work / "in", work / "link");
  std::atomic<bool> stop{false};
  std::thread exchanger([&] {
    for (int i = 0; !stop; ++i) {
      fs::copy_symlink(work / (i % 2 ? "in" : "out"), work / "next");
      fs::rename(work / "next", work / "link");
    }
  });
  int read = 0, refused = 0;
  for (int i = 0; i < 20000 || ((read == 0 || refused == 0) && i < 2000000); ++i) {
    try {
      const auto text = i % 2 ? files.read(work / "link") : read_text(files.hold(work / "link"));
      EXPECT_EQ(text, "plain");
      if (i % 3 == 0) {
        const auto writer = files.open(work / "link", true);
        EXPECT_TRUE(!writer || writer->write("").empty());
      }
      ++read;
    } catch (const FileRefused&) {
      ++refused;
    }
    if (i % 500 == 499) files = RestrictedFiles(rules());  // lets go of what it holds
  }
  stop = true;
  exchanger.join();
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 0);
  EXPECT_EQ(read_text(outside / "secret"), "secret");
}

/// A folder that becomes a link while a file is made in it.
TEST_F(UnitFileRules, ExchangedFolder) {
  RestrictedFiles files(rules());
  fs::create_directory_symlink(work / "sub", work / "in");
  fs::create_directory_symlink(outside, work / "out");
  fs::copy_symlink(work / "in", work / "folder");
  std::atomic<bool> stop{false};
  std::thread exchanger([&] {
    for (int i = 0; !stop; ++i) {
      fs::copy_symlink(work / (i % 2 ? "in" : "out"), work / "next");
      fs::rename(work / "next", work / "folder");
    }
  });
  for (int i = 0; i < 5000; ++i) {
    try {
      files.open(work / "folder" / ("new" + std::to_string(i)), i % 2 == 0);
      (void)files.open(work / "folder" / "secret", false);
    } catch (const FileRefused&) {
    }
  }
  stop = true;
  exchanger.join();
  EXPECT_EQ(std::distance(fs::directory_iterator(outside), {}), 1);
  EXPECT_EQ(read_text(outside / "secret"), "secret");
}

TEST_F(UnitFileRules, WritesInside) {
  RestrictedFiles files(rules());
  const auto write = [&](const fs::path& path, bool append) {
    const auto file = files.open(path, append);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->write("x"), "");
    EXPECT_EQ(file->close(), "");
  };
  write(work / "new", false);
  write(work / "new", true);
  EXPECT_EQ(files.read(work / "new"), "xx");
  write(work / "sub/../new", false);
  EXPECT_EQ(read_text(work / "new"), "x");
  fs::create_symlink(work / "plain", work / "link");
  write(work / "link", true);
  EXPECT_EQ(read_text(work / "plain"), "plainx");
  EXPECT_FALSE(files.open(work / "missing/new", false));
  EXPECT_FALSE(files.open(work / "sub", false));
}

TEST_F(UnitFileRules, MemoryWrites) {
  MemoryWrites files(disk_files());
  const auto write = [&](const fs::path& path, bool append) {
    const auto file = files.open(path, append);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->write("x"), "");
  };
  write(work / "new", false);
  EXPECT_FALSE(fs::exists(work / "new"));
  EXPECT_TRUE(files.exists(work / "sub/../new"));
  EXPECT_EQ(files.read(work / "new"), "x");
  EXPECT_EQ(files.find_loosely(work, "NEW"), (work / "new").string());
  EXPECT_EQ(read_text(files.hold(work / "new")), "x");
  write(work / "plain", true);
  write(work / "plain", true);
  EXPECT_EQ(files.read(work / "plain"), "plainxx");
  write(work / "plain", false);
  EXPECT_EQ(files.read(work / "plain"), "x");
  EXPECT_EQ(read_text(work / "plain"), "plain");
  EXPECT_FALSE(files.open(work / "missing/new", false));
  EXPECT_FALSE(files.open(work / "sub", false));
  RestrictedFiles restricted{rules()};
  MemoryWrites strangers(restricted);
  EXPECT_THROW(strangers.open(outside / "new", false), FileRefused);
  EXPECT_TRUE(strangers.open(work / "new", false));
}

TEST(UnitFiles, ShownName) {
  EXPECT_EQ(shown_name(std::string("a\nb\0c\x7F", 6)), "a\\x0ab\\x00c\\x7f");
}

}  // namespace
}  // namespace lentray::parser
