// Scenes that try to read or write where Restrict_IO=On lets them not: none does, and each is told where it
// tried and why not. Also what never blocks, what must still work, and writes that fail.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "core/image/reader.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using tool::read_text;
using tool::write_text;

constexpr const char* kHead =
    "#version 3.7; global_settings { assumed_gamma 1 } camera { location -5*z look_at 0 }\n";
constexpr const char* kSecret = "SECRET";

/// Folders "work" (current, with the scene), "lib" (a library path), "home" and "outside", which the scenes are
/// after. The user's povray.conf permits no folder, so that the system's lends none either.
class World {
 public:
  World() : m_root(fs::canonical(m_folder.path())) {
    for (const char* folder : {"work/sub", "lib", "outside/sub", "home/.povray/3.7"})
      fs::create_directories(m_root / folder);
    write_text(m_root / "home/.povray/3.7/povray.conf", "[File I/O Security]\nrestricted\n");
    const std::string secret = std::string("#error \"") + kSecret + "\"\n";
    for (const char* name :
         {"secret.inc", "secret.png", "secret.ttf", "secret.df3", "secret.ini", "empty"}) {
      write_text(m_root / "outside" / name, secret);
    }
    write_text(m_root / "outside/text", std::string("\"") + kSecret + "\"");
    write_text(m_root / "lib/own.inc", "#declare Own = 1;\n");
    link("../outside/secret.inc", "work/link.inc");
    link("../outside/text", "work/text");
    link("link.inc", "work/chain.inc");
    link("../outside", "work/folder");
    link("../outside/secret.png", "work/link.png");
    link("../outside/secret.ttf", "work/link.ttf");
    link("../outside/secret.df3", "work/link.df3");
    link("../outside/made", "work/dangling");
    link("../outside/secret.inc", "lib/link.inc");
    fs::create_hard_link(m_root / "outside/empty", m_root / "work/hard");
    ::mkfifo((m_root / "work/pipe").c_str(), 0666);
    ::mkfifo((m_root / "work/pipe.png").c_str(), 0666);
    m_before = outside();
  }

  tool::RunResult run(const std::string& statement, std::vector<std::string> options) const {
    write_text(m_root / "work/scene.pov", kHead + statement + "\n");
    std::vector<std::string> command = {"env",         "HOME=" + (m_root / "home").string(),
                                        "POVINI=",     LENTRAY_BIN_DIR "/lentray",
                                        "+Iscene.pov", "+W4",
                                        "+H4",         "-F",
                                        "-V",          "+L../lib"};
    command.insert(command.end(), options.begin(), options.end());
    return tool::run_program(command, m_root / "work", 60.0);
  }

  /// With OUT for the folder outside.
  std::string with_names(std::string text) const {
    for (std::size_t at = 0; (at = text.find("OUT")) != std::string::npos;) {
      text.replace(at, 3, (m_root / "outside").string());
    }
    return text;
  }

  bool is_unharmed() const { return outside() == m_before; }
  fs::path operator/(const std::string& name) const { return m_root / name; }

 private:
  void link(const std::string& target, const std::string& name) const {
    fs::create_symlink(target, m_root / name);
  }

  std::map<std::string, std::string> outside() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(m_root / "outside")) {
      all[entry.path().string()] = entry.is_regular_file() ? read_text(entry.path()) : "";
    }
    for (const char* name : {"povray.ini", ".hidden", "~"}) {
      if (fs::exists(m_root / "work" / name)) all[name] = "made";
    }
    return all;
  }

  tool::TemporaryFolder m_folder;
  fs::path m_root;
  std::map<std::string, std::string> m_before;
};

struct Attempt {
  const char* statement;  ///< on line 2
  const char* says;       ///< what the message has in it
};

constexpr const char* kReads = "a scene reads only below";
constexpr const char* kWrites = "a scene writes only below";
constexpr const char* kPlain = "a scene opens plain files only";
constexpr const char* kOwn = "a scene does not write what later runs obey";

const std::vector<Attempt> kAttempts = {
    // #include
    {"#include \"OUT/secret.inc\"", kReads},
    {"#include \"/OUT/secret.inc\"", kReads},
    {"#include \"OUT//sub/..//secret.inc\"", kReads},
    {"#include \"../outside/secret.inc\"", kReads},
    {"#include \"sub/../../outside/secret.inc\"", kReads},
    {"#include \"../lib/../outside/secret.inc\"", kReads},
    {"#include \"..\\outside\\secret.inc\"", kReads},
    {"#include \"../OUTSIDE/Secret.inc\"", kReads},
    {"#include \"link.inc\"", kReads},
    {"#include \"LINK.INC\"", kReads},
    {"#include \"chain.inc\"", kReads},
    {"#include \"../lib/link.inc\"", kReads},
    {"#include \"folder/secret.inc\"", kReads},
    {"#include \"/proc/self/cwd/../outside/secret.inc\"", kReads},
    {"#include \"/proc/self/rootOUT/secret.inc\"", kReads},
    {"#include \"/proc/self/environ\"", kReads},
    {"#include \"/proc/self/fd/0\"", kReads},
    {"#include \"/dev/stdin\"", kReads},
    {"#include \"/dev/zero\"", kReads},
    {"#include \"pipe\"", kPlain},
    {"#include \"~/secret.inc\"", "cannot find the include file"},
    {"#include \"~root/secret.inc\"", "cannot find the include file"},
    {"#include \"file://OUT/secret.inc\"", "cannot find the include file"},
    {"#include \"http://localhost/secret.inc\"", "cannot find the include file"},
    {"#include \"%HOME%/secret.inc\"", "cannot find the include file"},
    {"#include concat(\"OUT/secret.inc\", chr(0))", "a name with a NUL"},
    {"#include concat(\"OUT/secret.inc\", chr(10))", kReads},
    {"#include concat(\"a\", chr(10), \"../outside/secret.inc\")", "'a\\x0a../outside/secret.inc'"},
    // #fopen, file_exists
    {"#fopen F \"OUT/text\" read #read (F, A) #error A", kReads},
    {"#fopen F \"../outside/text\" read #read (F, A) #error A", kReads},
    {"#fopen F \"text\" read #read (F, A) #error A", kReads},
    {"#fopen F \"pipe\" read #read (F, A) #error A", kPlain},
    {"#fopen F \"/etc/passwd\" read", kReads},
    {"#if (file_exists(\"OUT/text\")) #end", kReads},
    {"#if (file_exists(\"OUT/no such file\")) #end", kReads},
    {"#if (file_exists(\"OUT\")) #end", kReads},
    {"#fopen F \"OUT/made\" write #write (F, 1)", kWrites},
    {"#fopen F \"OUT/text\" write #write (F, 1)", kWrites},
    {"#fopen F \"../outside/made\" write #write (F, 1)", kWrites},
    {"#fopen F \"folder/made\" write #write (F, 1)", kWrites},
    {"#fopen F \"folder/sub/made\" append #write (F, 1)", kWrites},
    {"#fopen F \"text\" write #write (F, 1)", kWrites},
    {"#fopen F \"text\" append #write (F, 1)", kWrites},
    {"#fopen F \"../lib/made\" write #write (F, 1)", kWrites},
    {"#fopen F \"OUT/text\" append #write (F, 1)", kWrites},
    {"#fopen F \"dangling\" write #write (F, 1)", "a link to a file that is not there"},
    {"#fopen F \"dangling\" append #write (F, 1)", "a link to a file that is not there"},
    {"#fopen F \"hard\" write #write (F, 1)", "another name (a hard link)"},
    {"#fopen F \"hard\" append #write (F, 1)", "another name (a hard link)"},
    {"#fopen F \"pipe\" write #write (F, 1)", kPlain},
    {"#fopen F \"/dev/full\" write #write (F, 1)", kWrites},
    {"#fopen F \"/dev/stdout\" write #write (F, 1)", kWrites},
    {"#fopen F \"/proc/self/fd/1\" append #write (F, 1)", kWrites},
    {"#fopen F \"/proc/self/cwd/../outside/made\" write #write (F, 1)", kWrites},
    {"#fopen F \"povray.ini\" write #write (F, \"Pre_Scene_Command=x\")", kOwn},
    {"#fopen F \"sub/../.hidden\" write #write (F, 1)", kOwn},
    {"#fopen F \"~/.profile\" append #write (F, 1)", kOwn},
    {"#fopen F \"~/profile\" append #write (F, 1)", "cannot open '~/profile' for writing"},
    {"#fopen F concat(\"OUT/made\", chr(0), \"x\") write #write (F, 1)", "a name with a NUL"},
    // Pictures, fonts, densities
    {"sphere { 0, 1 pigment { image_map { png \"OUT/secret.png\" } } }", kReads},
    {"sphere { 0, 1 pigment { image_map { png \"link.png\" } } }", kReads},
    {"sphere { 0, 1 pigment { image_map { \"link\" } } }", kReads},
    {"sphere { 0, 1 pigment { image_map { png \"pipe.png\" } } }", kPlain},
    {"sphere { 0, 1 normal { bump_map { png \"folder/secret.png\" } } }", kReads},
    {"sphere { 0, 1 texture { material_map { png \"OUT/secret.png\" texture { } } } }", kReads},
    {"sphere { 0, 1 pigment { image_pattern { png \"/dev/zero\" } } }", kReads},
    {"#declare F = function { pigment { image_map { png \"link.png\" } } }", kReads},
    {"height_field { png \"../outside/secret.png\" }", kReads},
    {"height_field { png \"pipe\" }", kPlain},
    {"text { ttf \"OUT/secret.ttf\" \"a\" 1, 0 }", kReads},
    {"text { ttf \"link\" \"a\" 1, 0 }", kReads},
    {"text { ttf \"pipe\" \"a\" 1, 0 }", kPlain},
    {"sphere { 0, 1 pigment { density_file df3 \"OUT/secret.df3\" } }", kReads},
    {"sphere { 0, 1 pigment { density_file df3 \"link.df3\" } }", kReads},
    // Photons
    {"global_settings { photons { count 9 load_file \"OUT/secret.inc\" } }", kReads},
    {"global_settings { photons { count 9 save_file \"OUT/made\" } }", kWrites},
};

/// Whether a place on line 2 and a caret are in it.
bool has_place(const std::string& output) {
  return std::regex_search(output, std::regex("(^|\n)scene\\.pov:2:[0-9]+: error: ")) &&
         std::regex_search(output, std::regex("\n +\\^"));
}

/// But for the scene's own lines.
bool tells_secret(const std::string& output) {
  return std::regex_replace(output, std::regex("\n  .*"), "").find(kSecret) != std::string::npos;
}

void expect_refused(const World& world, const Attempt& attempt,
                    const std::vector<std::string>& options) {
  const std::string statement = world.with_names(attempt.statement);
  SCOPED_TRACE(statement);
  const tool::RunResult result = world.run(statement, options);
  EXPECT_EQ(result.status, 1);
  EXPECT_FALSE(result.timed_out);
  EXPECT_TRUE(has_place(result.output)) << result.output;
  EXPECT_NE(result.output.find(attempt.says), std::string::npos) << result.output;
  EXPECT_FALSE(tells_secret(result.output)) << result.output;
  EXPECT_TRUE(world.is_unharmed());
}

TEST(CompatRestrictIo, NoAttemptSucceeds) {
  const World world;
  EXPECT_GE(kAttempts.size(), 40u);
  for (const Attempt& attempt : kAttempts) expect_refused(world, attempt, {"Restrict_IO=On"});
}

// Without the rules many of the same scenes get what they are after.
TEST(CompatRestrictIo, TheAttemptsAreReal) {
  int successes = 0;
  for (const Attempt& attempt : kAttempts) {
    const World world;
    const tool::RunResult result = world.run(world.with_names(attempt.statement), {});
    successes += tells_secret(result.output) || !world.is_unharmed();
  }
  EXPECT_GE(successes, 30);
}

// Where nothing would be written anyway, the rules hold all the same.
TEST(CompatRestrictIo, NorWithoutRendering) {
  const World world;
  for (std::size_t i = 0; i < kAttempts.size(); i += 4) {
    expect_refused(world, kAttempts[i], {"Restrict_IO=On", i % 8 ? "--parse-only" : "--dump"});
  }
}

TEST(CompatRestrictIo, FolderIniLendsNoFolder) {
  const World world;
  write_text(world / "work/povray.ini",
             "Library_Path=../outside\nRestrict_IO=Off\nAll_File=../outside/made\n");
  const tool::RunResult result = world.run("#include \"secret.inc\"", {"Restrict_IO=On"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("cannot find the include file 'secret.inc'"), std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("povray.ini is not read"), std::string::npos) << result.output;
  EXPECT_FALSE(fs::exists(world / "outside/made"));
}

// An INI file that the user names is the user's own, but its scene is not.
TEST(CompatRestrictIo, NamedIni) {
  const World world;
  write_text(world / "work/users.ini", "Library_Path=../outside\n");
  write_text(world / "outside/plain.inc", "#warning \"READ\"\n");
  EXPECT_NE(
      world.run("#include \"plain.inc\"", {"users.ini", "Restrict_IO=On"}).output.find("READ"),
      std::string::npos);
  const tool::RunResult result =
      world.run("#include \"../home/.povray/3.7/povray.conf\"", {"users.ini", "Restrict_IO=On"});
  EXPECT_TRUE(has_place(result.output)) << result.output;
}

// A list of pictures is no picture, though the reader of films would follow it.
TEST(CompatRestrictIo, ListsOfFurtherFiles) {
  const World world;
  write_text(world / "work/list.png",
             "#EXTM3U\n#EXTINF:1,\nfile://" + (world / "outside/secret.png").string() + "\n");
  write_text(world / "work/list.jpg",
             "ffconcat version 1.0\nfile '" + (world / "outside/secret.png").string() + "'\n");
  fs::copy_file(world / "work/list.png", world / "work/list.m3u8");
  for (const char* name : {"list.png", "list.jpg", "list.m3u8"}) {
    const auto result =
        world.run(std::string("sphere { 0, 1 pigment { image_map { \"") + name + "\" } } }",
                  {"Restrict_IO=On"});
    EXPECT_NE(result.output.find("cannot read "), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find(kSecret), std::string::npos);
  }
}

TEST(CompatRestrictIo, WhatIsPermittedWorks) {
  const World world;
  write_text(world / "work/sub/a.inc", "#declare A = 1;\n");
  fs::create_symlink("sub/a.inc", world / "work/inside.inc");
  for (const char* statement :
       {"#include \"sub/a.inc\"", "#include \"sub/../sub/a.inc\"", "#include \"inside.inc\"",
        "#include \"own.inc\"", "#include \"SUB\\A.INC\"", "#include \"colors.inc\"",
        "text { internal 1 \"a\" 1, 0 }", "text { ttf \"timrom.ttf\" \"a\" 1, 0 }",
        "#if (file_exists(\"none\")) #error \"x\" #end",
        "#fopen F \"sub/new\" write #write (F, \"1,\") #fclose F #fopen F \"sub/new\" append "
        "#write (F, \"2\") #fclose F "
        "#fopen F \"sub/new\" read #read (F, A, B) #if (B != 2) #error \"x\" #end",
        "#fopen F \"p.pgm\" write #write (F, \"P2 2 2 255 0 255 255 0 \") #fclose F "
        "sphere { 0, 1 pigment { image_map { pgm \"p.pgm\" } } } height_field { pgm \"p.pgm\" }",
        "#fopen F \"d.df3\" write #write (F, uint16be 1, 1, 1, uint8 9) #fclose F "
        "sphere { 0, 1 pigment { density_file df3 \"d.df3\" } }"}) {
    for (const char* mode : {"Restrict_IO=On", "Restrict_IO=Off", "--parse-only"}) {
      const tool::RunResult result = world.run(statement, {mode});
      EXPECT_EQ(result.status, 0) << mode << ' ' << statement << '\n' << result.output;
      EXPECT_EQ(result.output.find("cannot"), std::string::npos) << mode << ' ' << statement << '\n'
                                                                 << result.output;
    }
  }
}

// Pictures are opened by what was judged, not by name: their names still tell the format, or are wrong about it.
TEST(CompatRestrictIo, PicturesAreTheSame) {
  const World world;
  core::StoredImage picture;
  picture.width = 5;
  picture.height = 4;
  picture.channels = 3;
  picture.bits = 8;
  picture.samples.assign(60, 0.0f);
  for (std::size_t i = 0; i < 60; ++i) picture.samples[i] = static_cast<float>(4 * i);
  core::write_stored(picture, world / "work/a.png");
  core::write_stored(picture, world / "work/a.tif");
  fs::copy_file(world / "work/a.png", world / "work/wrong.tga");
  fs::copy_file(world / "work/a.tif", world / "work/wrong.jpg");
  write_text(world / "work/a.ppm", "P3 2 2 255 255 0 0 0 255 0 0 0 255 9 9 9\n");
  for (const char* name : {"a.png", "a.tif", "a.ppm", "wrong.tga", "wrong.jpg"}) {
    const std::string statement = std::string("plane { z, 0 pigment { image_map { \"") + name +
                                  "\" } } finish { ambient 1 diffuse 0 } }";
    EXPECT_EQ(world.run(statement, {"+F", "+Ofree.png"}).output, "");
    EXPECT_EQ(world.run(statement, {"+F", "+Orestricted.png", "Restrict_IO=On"}).output, "");
    EXPECT_EQ(read_text(world / "work/free.png"), read_text(world / "work/restricted.png")) << name;
  }
}

// More uses of a file than there may be open files.
TEST(CompatRestrictIo, OneFileIsHeldOnce) {
  const World world;
  const std::string many =
      "#fopen F \"p.pgm\" write #write (F, \"P2 2 2 255 0 255 255 0 \") #fclose F #for (I, 1, "
      "1500) "
      "sphere { I, 1 pigment { image_map { pgm \"p.pgm\" } } } text { ttf \"timrom.ttf\" \"a\" 1, "
      "0 } #end";
  for (const char* mode : {"Restrict_IO=On", "--parse-only"}) {
    const tool::RunResult result = world.run(many, {mode, "+W1", "+H1"});
    EXPECT_EQ(result.status, 0) << result.output;
  }
}

// As stock permits what povray.conf does; that of the system is asked too, so only folders of both count.
TEST(CompatRestrictIo, ConfPermits) {
  const std::string system = "/etc/povray/3.7/povray.conf";
  if (!fs::exists(system) || read_text(system).find("\nread+write* = /tmp") == std::string::npos) {
    GTEST_SKIP() << "the system's povray.conf does not permit /tmp";
  }
  const World world;
  if (!(world / "outside").string().starts_with("/tmp/"))
    GTEST_SKIP() << "this test is not in /tmp";
  const std::string conf = "[File I/O Security]\nrestricted\n[Permitted Paths]\n";
  write_text(world / "home/.povray/3.7/povray.conf",
             conf + "read=" + (world / "outside").string() + "\n");
  write_text(world / "outside/plain.inc", "\n");
  write_text(world / "outside/sub/plain.inc", "\n");
  EXPECT_EQ(world.run("#include \"../outside/plain.inc\"", {"Restrict_IO=On"}).status, 0);
  EXPECT_EQ(world.run("#include \"../outside/sub/plain.inc\"", {"Restrict_IO=On"}).status, 1);
  EXPECT_EQ(world.run("#fopen F \"../outside/made\" write", {"Restrict_IO=On"}).status, 1);
  write_text(world / "home/.povray/3.7/povray.conf",
             conf + "read+write*=" + (world / "outside").string() + "\n");
  EXPECT_EQ(world.run("#fopen F \"../outside/sub/made\" write", {"Restrict_IO=On"}).status, 0);
  EXPECT_TRUE(fs::exists(world / "outside/sub/made"));
}

TEST(CompatFiles, PipesAndDevicesNeverBlock) {
  const World world;
  for (const char* statement :
       {"#include \"pipe\"", "#include \"/dev/zero\"", "#fopen F \"pipe\" read",
        "#fopen F \"pipe\" write", "#fopen F \"/dev/zero\" read",
        "#if (file_exists(\"pipe\")) #end", "text { ttf \"pipe\" \"a\" 1, 0 }",
        "sphere { 0, 1 pigment { image_map { png \"pipe.png\" } } }",
        "height_field { png \"/dev/zero\" }",
        "sphere { 0, 1 pigment { density_file df3 \"pipe\" } }"}) {
    const tool::RunResult result = world.run(statement, {});
    EXPECT_EQ(result.status, 1) << statement;
    EXPECT_FALSE(result.timed_out) << statement;
    EXPECT_TRUE(has_place(result.output)) << statement << '\n' << result.output;
  }
}

TEST(CompatFiles, LostWritesAreErrors) {
  const World world;
  struct Case {
    const char* statement;
    int column;
  };
  for (const Case& c : {Case{"#fopen F \"/dev/full\" write #write (F, 1) #fclose F", 50},
                        {"#fopen F \"/dev/full\" write #for (I, 1, 99999) #write (F, I) #end", 55},
                        {"#fopen F \"/dev/full\" append #write (F, 1)", 10},
                        {"#fopen F \"/dev/full\" write #write (F, 1) #undef F", 10},
                        {"#fopen F \"/dev/full\" write #write (F, 1) #fopen F \"a\" write", 10}}) {
    const tool::RunResult result = world.run(std::string(c.statement) + " sphere { 0, 1 }", {});
    EXPECT_EQ(result.status, 1) << c.statement;
    EXPECT_NE(result.output.find("scene.pov:2:" + std::to_string(c.column) + ": error: "),
              std::string::npos)
        << c.statement << '\n'
        << result.output;
    EXPECT_NE(result.output.find("No space left on device"), std::string::npos) << result.output;
  }
}

TEST(CompatFiles, RunsWithoutRenderingLeaveNothing) {
  const World world;
  write_text(world / "work/old.txt", "\"old\",");
  const std::string statement =
      "#fopen F \"new.inc\" write #write (F, \"#declare New = 7;\") #fclose F #include \"new.inc\" "
      "#fopen F \"old.txt\" append #write (F, \"\\\"added\\\"\") #fclose F "
      "#fopen F \"old.txt\" read #read (F, A, B) #warning concat(A, B, str(New, 0, 0), "
      "str(file_exists(\"new.inc\"), 0, 0))";
  for (const char* mode : {"--parse-only", "--dump"}) {
    const tool::RunResult result = world.run(statement, {mode});
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_NE(result.output.find("oldadded71"), std::string::npos) << result.output;
    EXPECT_FALSE(fs::exists(world / "work/new.inc"));
    EXPECT_EQ(read_text(world / "work/old.txt"), "\"old\",");
  }
  EXPECT_NE(world.run(statement, {}).output.find("oldadded71"), std::string::npos);
  EXPECT_TRUE(fs::exists(world / "work/new.inc"));
}

}  // namespace
}  // namespace lentray::test
