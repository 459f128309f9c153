// lentray-batch without running anything: its command line, which scenes a folder has and what they are called, rows
// and the manifest, the packing of tasks.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "parser/options/options.h"
#include "tools/common/json_text.h"
#include "tools/common/messages.h"
#include "tools/common/process.h"
#include "tools/lentray-batch/arguments.h"
#include "tools/lentray-batch/job.h"
#include "tools/lentray-batch/manifest.h"
#include "tools/lentray-batch/run_log.h"
#include "tools/lentray-batch/scan.h"
#include "tools/lentray-batch/state_folder.h"
#include "tools/lentray-batch/table.h"
#include "tools/lentray-batch/tasks.h"
#include "tools/lentray-batch/views.h"

namespace lentray::batch {
namespace {

namespace fs = std::filesystem;

class UnitBatch : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) const {
    fs::create_directories((m_folder / name).parent_path());
    tool::write_text(m_folder / name, text);
  }
  std::string place(const std::string& name) const { return (m_folder / name).string(); }

  /// What is said about a command line; empty: nothing.
  static std::string refused(const std::vector<std::string>& words) {
    try {
      parse_arguments(words);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  const tool::TemporaryFolder m_folder;
};

constexpr const char* kCamera = "camera { location -5*z }\n";

TEST_F(UnitBatch, OptionsAreItsOwnOrLentrays) {
  put("a.pov", kCamera);
  put("sheet.ini", "Lenticular=On\n");
  const Arguments a =
      parse_arguments({place("a.pov"), "--out", place("out"), "+W320", "Declare=A=2",
                       place("sheet.ini"), "--frames", "--time-limit=10m", "--memory-limit", "2G",
                       "--jobs=3", "--grade", "match", "+Lincludes"});
  EXPECT_EQ(a.inputs, std::vector<fs::path>{place("a.pov")});
  const std::vector<std::string> expected{"Restrict_IO=On", "+W320", "Declare=A=2",
                                          place("sheet.ini"),
                                          "+L" + fs::absolute("includes").string()};
  EXPECT_EQ(a.for_lentray, expected);
  EXPECT_TRUE(a.frames && a.compare && a.scene_ini);
  EXPECT_EQ(a.time_limit, 600.0);
  EXPECT_EQ(a.memory_limit, 2.0 * 1024 * 1024 * 1024);
  EXPECT_EQ(a.jobs, 3);
  EXPECT_EQ(a.asked, core::Grade::match);
}

TEST_F(UnitBatch, BadOptionsAreNamed) {
  put("a.pov", kCamera);
  const std::string scene = place("a.pov"), out = "--out=" + place("out");
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{out}, "no folder and no scene was named"},
      {{scene}, "--out DIR is missing"},
      {{scene, out, "nothing-there"}, "there is no folder or scene 'nothing-there'"},
      {{scene, out, "--colour"}, "unknown option '--colour'; there are"},
      {{scene, out, "--frames=3"}, "no value belongs to '--frames'"},
      {{scene, out, "--jobs"}, "--jobs needs a value"},
      {{scene, out, "--jobs", "1.5"}, "--jobs: '1.5': a whole number is expected"},
      {{scene, out, "--jobs", "-1"}, "--jobs: '-1': a number greater than 0 is expected"},
      {{scene, out, "--time-limit", "3d"}, "--time-limit: unknown unit 'd': there are s, m and h"},
      {{scene, out, "--memory-limit", "3X"},
       "--memory-limit: unknown unit 'X': there are K, M, G and T"},
      {{scene, out, "--grade", "perfect"},
       "--grade: 'perfect'; there are exact, match, noise, close"},
      {{scene, out, "--compare", "--noise", "loud"}, "--noise: 'loud'; there are auto, on, off"},
      {{scene, out, "--noise", "on"}, "--noise is stock's: it needs --compare"},
      {{scene, out, "--table", "t.md"}, "--table shows grades: it needs --compare"},
      {{scene, out, "--sbatch", "-p x"}, "--sbatch gives options to Slurm: it needs --slurm"},
      {{scene, out, "+Ox.png"},
       "'+Ox.png': the batch decides that of every scene itself (--out says where pictures go)"},
      {{scene, out, "Max_Time=3"},
       "'Max_Time=3': the batch decides that of every scene itself (--time-limit)"},
      {{scene, out, "+WT4"}, "'+WT4': the batch decides that of every scene itself (--jobs)"},
      {{scene, out, "Widht=3"}, "Widht"},
      {{scene, out, "+W0"}, "W0"},
      {{scene, out, "--dump"}, "unknown option '--dump'"}};
  for (const auto& [words, message] : cases) {
    EXPECT_NE(refused(words).find(message), std::string::npos) << message << "\n" << refused(words);
  }
  EXPECT_EQ(refused({scene, out}), "");
}

TEST_F(UnitBatch, TextsOfScenesAreLookedThrough) {
  const SceneText text = look_at(R"(// #include "a.pov"
    /* camera { /* nested */ #include "b.pov" */ #include "c.pov" # include "d.inc"
    #declare S = "camera #include \"e.pov\" "; include "f.inc" my_camera)");
  EXPECT_EQ(text.includes, (std::vector<std::string>{"c.pov", "d.inc", "f.inc"}));
  EXPECT_FALSE(text.has_camera);
  EXPECT_TRUE(look_at("#if (1) camera{}").has_camera);
  EXPECT_FALSE(look_at("\"unfinished").has_camera);
  EXPECT_FALSE(look_at("/* unfinished").has_camera);
}

TEST_F(UnitBatch, FindsScenesAndLeavesOutPartsAndItsOwnFolder) {
  put("in/a.pov", std::string(kCamera) + "#include \"sub/part.pov\" #include \"full.pov\"\n");
  put("in/full.pov", kCamera);
  put("in/sub/part.pov", "sphere { 0, 1 }\n");
  put("in/sub/alone.POV", "sphere { 0, 1 }\n");
  put("in/sub/alone.ini", "+W8\n");
  put("in/.hidden/b.pov", kCamera);
  put("in/out/old.pov", kCamera);
  put("in/c.inc", "camera {}");
  const Scan scan = find_scenes({m_folder / "in"}, {m_folder / "in/out"}, {});
  std::vector<std::string> names;
  for (const Scene& scene : scan.scenes)
    names.push_back(scene.name + (scene.part_of.empty() ? "" : " of " + scene.part_of));
  EXPECT_EQ(names, (std::vector<std::string>{"a", "full", "sub/alone", "sub/part of a.pov"}));
  EXPECT_EQ(scan.scenes[2].ini, m_folder / "in/sub/alone.ini");
  EXPECT_THROW(find_scenes({m_folder / "in"}, {m_folder.path()}, {}), std::exception);
}

TEST_F(UnitBatch, LinksOfStrangersStayInTheirFolder) {
  put("in/sub/a.pov", kCamera);
  put("mine/b.pov", kCamera);
  fs::create_symlink("sub/a.pov", m_folder / "in/inside.pov");
  fs::create_symlink("../mine/b.pov", m_folder / "in/outside.pov");
  fs::create_symlink("../mine", m_folder / "in/folder");
  const auto names = [this](bool follows_links, std::size_t warnings) {
    const Scan scan = find_scenes({m_folder / "in"}, {m_folder / "out", follows_links}, {});
    EXPECT_EQ(scan.warnings.size(), warnings);
    std::vector<std::string> out;
    for (const Scene& scene : scan.scenes) out.push_back(scene.name);
    return out;
  };
  EXPECT_EQ(names(false, 1), (std::vector<std::string>{"inside", "sub/a"}));
  EXPECT_EQ(names(true, 0), (std::vector<std::string>{"inside", "outside", "sub/a"}));
}

TEST_F(UnitBatch, FoldersOfAScene) {
  const fs::path scene = m_folder / "in/sub/a.pov";
  EXPECT_EQ(folders_of({m_folder / "in/", m_folder / "other", scene}, scene),
            (std::vector<fs::path>{m_folder / "in", m_folder / "in/sub"}));
  EXPECT_TRUE(folders_of({m_folder / "i", m_folder / "in/sub/b.pov"}, scene).empty());
}

/// Links on the way to an input are the user's; what lies below it may be a stranger's.
TEST_F(UnitBatch, WhatLiesInTheInputs) {
  put("in/sub/a.pov", kCamera);
  put("out/b.pov", kCamera);
  fs::create_directory_symlink(m_folder / "in", m_folder / "link");
  fs::create_directory_symlink(m_folder / "out", m_folder / "in/away");
  const fs::path sub = fs::canonical(m_folder / "in/sub");
  EXPECT_TRUE(lies_in({m_folder / "in/"}, sub));
  EXPECT_TRUE(lies_in({m_folder / "link"}, sub));
  EXPECT_TRUE(lies_in({m_folder / "in/sub/a.pov"}, sub));
  EXPECT_FALSE(lies_in({m_folder / "in/sub"}, fs::canonical(m_folder / "in")));
  EXPECT_FALSE(lies_in({m_folder / "in"}, fs::canonical(m_folder / "in/away")));
  EXPECT_FALSE(lies_in({m_folder / "gone"}, sub));
}

/// Scenes are strangers' unless the command line says that they are not.
TEST_F(UnitBatch, RestrictsUntilTheCommandLineSaysOff) {
  put("in/a.pov", kCamera);
  put("off.ini", "Restrict_IO=Off\n");
  const auto restricts = [this](std::vector<std::string> words) {
    words.insert(words.end(), {place("in"), "--out", place("out")});
    return parse_arguments(words).restricts;
  };
  EXPECT_TRUE(restricts({}));
  EXPECT_TRUE(restricts({"restrict_io=on"}));
  EXPECT_TRUE(restricts({place("off.ini")}));
  EXPECT_TRUE(restricts({"Restrict_IO=Off", "Restrict_IO=On"}));
  EXPECT_FALSE(restricts({"restrict_io=Off"}));
}

/// Rows that came with scenes name no files elsewhere.
TEST_F(UnitBatch, RowsNameFilesBelowTheirManifest) {
  Row row;
  row.source = "/s";
  const auto is_taken = [&] {
    put("manifest.jsonl", tool::json_text(json_of(row)) + "\n");
    return rows_in(m_folder / "manifest.jsonl").contains(row.name);
  };
  row.name = "a";
  row.picture = "sub/a.png";
  row.views = {"sub/a-views/view00.png"};
  EXPECT_TRUE(is_taken());
  row.views.push_back("../b.png");
  EXPECT_FALSE(is_taken());
  row.views.clear();
  row.picture = "/etc/passwd";
  EXPECT_FALSE(is_taken());
  row.picture = "sub/../../a.png";
  EXPECT_FALSE(is_taken());
  row.picture = "a.png";
  for (const char* name : {"../a", "/tmp/a", "sub/../../a"}) {
    row.name = name;
    EXPECT_FALSE(is_taken()) << "the scene's pictures would keep that name";
  }
}

TEST_F(UnitBatch, NamesAreUniqueAndStay) {
  for (const char* name : {"x/s.pov", "y/s.pov", "y/s.POV", "z/s.pov"}) put(name, kCamera);
  const auto names = [this](const std::vector<fs::path>& inputs,
                            const std::map<std::string, std::string>& known) {
    std::map<std::string, std::string> out;
    for (const Scene& scene : find_scenes(inputs, {m_folder / "out"}, known).scenes) {
      out[scene.source.lexically_relative(m_folder.path()).string()] = scene.name;
    }
    return out;
  };
  using Names = std::map<std::string, std::string>;
  EXPECT_EQ(names({m_folder / "x", m_folder / "y"}, {}),
            (Names{{"x/s.pov", "s"}, {"y/s.POV", "y/s"}, {"y/s.pov", "s-2"}}));
  const Names known{{place("z/s.pov"), "s"}, {place("gone.pov"), "y/s"}};
  EXPECT_EQ(names({m_folder / "y/s.pov", m_folder / "z"}, known),
            (Names{{"y/s.pov", "s-2"}, {"z/s.pov", "s"}}));
}

TEST_F(UnitBatch, ALogIsTakenApartByViews) {
  const std::string log =
      "a.pov:3:1: warning: old\nLens sheet\nView 3 of 12, 4 x 4 pixels\nits own\n"
      "View 4 of 12, 4 x 4 pixels\nViewed\n";
  const auto lines = [&log](std::optional<int> view) {
    std::istringstream text(log);
    return log_lines(text, view);
  };
  using Lines = std::vector<std::string>;
  const Lines all{"a.pov:3:1: warning: old", "Lens sheet"};
  EXPECT_EQ(lines(3), (Lines{all[0], all[1], "View 3 of 12, 4 x 4 pixels", "its own"}));
  EXPECT_EQ(lines(4), (Lines{all[0], all[1], "View 4 of 12, 4 x 4 pixels", "Viewed"}));
  EXPECT_EQ(lines(5), (Lines{all[0], all[1], "Viewed"}));
  EXPECT_EQ(lines(std::nullopt).size(), 6u);
}

/// Only files of another key, whether of a picture or of views, and not those of scenes of like names.
TEST_F(UnitBatch, FilesOfEarlierRunsAreForgotten) {
  const StateFolder state(m_folder / "out");
  const std::string key(16, 'a'), other(16, 'b');
  std::vector<fs::path> stay{state.file("s#", key, "log"), state.file("s#", key + "07", "log"),
                             state.file("s#.ccccccccccccccccc-", other, "log"),
                             state.file("s", other, "log")};
  std::vector<fs::path> go{state.file("s#", other, "log"), state.file("s#", other + "07", "read")};
  for (const auto* files : {&stay, &go}) {
    for (const fs::path& file : *files) tool::write_text(file, "");
  }
  state.forget_others("s#", key);
  for (const fs::path& file : stay) EXPECT_TRUE(fs::exists(file)) << file;
  for (const fs::path& file : go) EXPECT_FALSE(fs::exists(file)) << file;
}

Row full_row() {
  Row row;
  row.name = "a/b#07";
  row.source = "/x/a/b.pov";
  row.frame = 7;
  row.state = State::done;
  row.command = {"lentray", "+W3"};
  row.messages = {"a \"quoted\" line"};
  row.warnings = 1;
  row.kinds = {{"jumps", "the background moves"}};
  row.picture = "a/b07.png";
  row.width = 3;
  row.height = 2;
  row.bytes = 70;
  row.views = {"v0.png"};
  row.lens_pixels = 12.5;
  row.left_out = {"media"};
  row.wall = 1.5;
  row.rendering = 0.25;
  row.memory = 1000;
  row.attempts = 2;
  row.verdict = Verdict{};
  row.verdict->grade = "match";
  row.verdict->psnr = 41.5;
  row.verdict->view_grades = {{"exact", 3}};
  row.verdict->block_rms = 0.5;
  row.verdict->bias = -0.25;
  row.verdict->noise_rms = 0.375;
  row.verdict->noise_bias = 0.0;
  row.verdict->noise_cpu = 9.5;
  row.key = "0123456789abcdef";
  row.picture_file = {7};
  row.seen.files["/x/a/b.pov"] = {0xffffffffffffffff, 10, 20, 30, 40};
  row.seen.missing = {"/x/a/c.inc"};
  row.seen.there = {"/x/a/d.inc"};
  row.seen.name = "b.pov";
  row.seen.now = 9801.1234567890123;
  return row;
}

TEST_F(UnitBatch, RowsSurviveAsJson) {
  const nlohmann::json whole = json_of(full_row());
  EXPECT_EQ(json_of(row_of(whole)), whole);
  EXPECT_EQ(row_of(whole).kinds.at("jumps"), "the background moves");
  EXPECT_EQ(row_of(whole).seen, full_row().seen);
  EXPECT_EQ(row_of(whole).picture_file, full_row().picture_file);
  EXPECT_EQ(row_of(whole).verdict->psnr, 41.5);
  EXPECT_EQ(row_of(whole).verdict->noise_rms, 0.375);
  EXPECT_EQ(row_of(whole).verdict->noise_bias, 0.0);
  EXPECT_THROW(row_of({{"name", "x"}}), std::invalid_argument);
  EXPECT_THROW(row_of({{"name", "x"}, {"source", "y"}, {"state", "odd"}}), std::invalid_argument);
}

TEST_F(UnitBatch, ManifestPassesOverWhatWasCutOff) {
  StateFolder state(m_folder / "out");
  {
    Manifest manifest(m_folder / "out", state);
    Row row = full_row();
    manifest.put(row);
    row.name = "other";
    row.frame.reset();
    manifest.put(row);
  }
  std::ofstream(m_folder / "out/manifest.jsonl", std::ios::app) << "{\"name\": \"cut";
  {
    Manifest manifest(m_folder / "out", state);
    EXPECT_EQ(manifest.rows().size(), 2u);
    EXPECT_EQ(manifest.names().at("/x/a/b.pov"), "other");
    Row row = full_row();
    row.name = "after";
    manifest.put(row);  // begins a line of its own
    row.warnings = 9;
    manifest.put(row);
  }
  Manifest manifest(m_folder / "out", state);
  ASSERT_EQ(manifest.rows().size(), 3u);
  EXPECT_EQ(manifest.find("after")->warnings, 9);
  manifest.tidy();
  EXPECT_EQ(tool::read_text(m_folder / "out/manifest.jsonl").find("cut"), std::string::npos);
  EXPECT_EQ(Manifest(m_folder / "out", state).rows().size(), 3u);
}

TEST_F(UnitBatch, PicturesThatWereNotMadeWaitInTheManifest) {
  StateFolder state(m_folder / "out");
  {
    Manifest manifest(m_folder / "out", state);
    Row row = full_row();
    for (const char* name : {"made", "not made"}) {
      row.name = name;
      manifest.put(row);  // of an earlier run, and out of date
      manifest.await(row);
    }
    row.name = "made";
    manifest.put(row);
    EXPECT_EQ(manifest.find("not made")->state, State::waiting);
    EXPECT_EQ(manifest.rows().at("not made").state, State::done) << "known for estimates";
    manifest.tidy();
  }
  const Manifest manifest(m_folder / "out", state);
  EXPECT_EQ(manifest.find("made")->state, State::done);
  EXPECT_EQ(manifest.find("not made")->state, State::waiting);
  EXPECT_EQ(manifest.find("not made")->picture, "") << "the old one is not of these options";
}

TEST_F(UnitBatch, WarningsOfASheetHaveKinds) {
  KindsFound found;
  for (const char* line :
       {"warning: jumps: the background moves by 3.1 pixels a view; say Depth_Budget=1",
        "warning: flat: nothing moves", "warning: jumps: twice", "warning: jumpsuit: no kind",
        "warning: the lens sheet cuts an object", "a.pov:3:1: warning: cut: a scene's own words",
        "jumps: no warning", "warning: reversed"})
    note_kind(found, line);
  EXPECT_EQ(found,
            (KindsFound{{"flat", "nothing moves"},
                        {"jumps",
                         "the background moves by 3.1 pixels a view; say Depth_Budget=1\ntwice"}}));
  EXPECT_EQ(warnings_of(found), 3u);
  EXPECT_EQ(text_of({}, 10), "");
  EXPECT_EQ(text_of({{"jumps", 2}, {"flat", 1}}, 10), "2 of 10 sheets jump, 1 is flat");
  EXPECT_EQ(text_of({{"cut", 1}}, 1), "1 of 1 sheet is cut");
}

TEST_F(UnitBatch, OneBatchAtATime) {
  const StateFolder one(m_folder / "out");
  EXPECT_THROW(StateFolder(m_folder / "out"), std::runtime_error);
  EXPECT_NO_THROW(StateFolder(m_folder / "out", StateFolder::Access::shared));
}

TEST_F(UnitBatch, FilesOfOtherKeysAreForgotten) {
  const StateFolder state(m_folder / "out");
  const std::string old(16, 'a'), now(16, 'b');
  for (const auto& [name, key] : {std::pair{"x", old}, {"x", now}, {"x.y", old}})
    tool::write_text(state.file(name, key, "log"), "");
  state.forget_others("x", now);
  EXPECT_FALSE(fs::exists(state.file("x", old, "log")));
  EXPECT_TRUE(fs::exists(state.file("x", now, "log")));
  EXPECT_TRUE(fs::exists(state.file("x.y", old, "log")));
}

TEST_F(UnitBatch, KeysFollowWhatDecidesThePicture) {
  put("a.pov", kCamera);
  const StateFolder state(m_folder / "out");
  const auto key = [&](const std::vector<std::string>& more, const std::string& ini = "") {
    std::vector<std::string> words{place("a.pov"), "--out", place("out")};
    words.insert(words.end(), more.begin(), more.end());
    Plan plan;
    plan.arguments = parse_arguments(words);
    plan.state = &state;
    Scene scene{place("a.pov"), "a", "", {}};
    if (!ini.empty()) put("a.ini", ini);
    if (!ini.empty()) scene.ini = place("a.ini");
    return Job(plan, scene, options_of(plan, scene), std::nullopt).row().key;
  };
  const std::string plain = key({});
  EXPECT_EQ(key({"Shadow_Cache=off", "--jobs=2", "--quiet"}), plain);
  for (const char* word : {"+W99", "+A", "+FN16", "Lenticular=On", "Declare=X=1", "File_Gamma=1",
                           "+Q3", "+L/tmp", "+K0.5"}) {
    EXPECT_NE(key({word}), plain) << word;
  }
  EXPECT_NE(key({}, "Quality=2\n"), plain);
  EXPECT_EQ(key({"--no-scene-ini"}, "Quality=2\n"), plain);
}

TEST_F(UnitBatch, TasksAreOfOneSizeAndHoldEverythingOnce) {
  std::vector<Estimate> pictures;
  for (int i = 0; i < 100; ++i)
    pictures.push_back({"small" + std::to_string(i), 0.1, 0.9 + i % 7, 120});
  pictures.push_back({"large", 2.0, 400.0, 2400});
  pictures.push_back({"slow to read", 50.0, 400.0, 2400});
  pictures.push_back({"one piece", 1.0, 300.0, 0});
  const std::vector<Task> tasks = pack(pictures, 30.0);
  std::map<std::string, std::int64_t> rows;
  std::map<std::string, int> parts;
  double before = 1e9;
  for (const Task& task : tasks) {
    double seconds = 0.0;
    for (const Item& item : task) {
      seconds += item.seconds;
      ++parts[item.name];
      rows[item.name] += item.last_row - item.first_row + 1;
    }
    EXPECT_TRUE(task.size() == 1 || seconds <= 30.0 * 1.001);
    EXPECT_LE(seconds, before) << "the longest come first";
    before = seconds;
  }
  EXPECT_EQ(rows["large"], 2400);
  EXPECT_EQ(parts["large"], 15);
  for (const Task& task : pack({{"antialiased", 1.0, 400.0, 2400, 128}}, 30.0)) {
    EXPECT_EQ((task[0].first_row - 1) % 128, 0);
    EXPECT_GE(task[0].last_row, task[0].first_row);
  }
  EXPECT_EQ(parts["slow to read"], 8) << "what each band repeats is at most a half";
  EXPECT_EQ(parts["one piece"], 1);
  EXPECT_EQ(parts["small0"], 1);
  EXPECT_EQ(parts.size(), 103u);
  EXPECT_EQ(task_seconds(pictures, 1), 180.0);
  EXPECT_LT(task_seconds(pictures, 64), 10.0);
}

TEST_F(UnitBatch, ViewsAreColumnsOfTheSheet) {
  core::StoredImage image;
  image.width = 12;
  image.height = 1;
  image.channels = 1;
  image.samples.assign(12, 0.0f);
  for (std::uint32_t k = 0; k < 12; ++k) image.at(k, 0, 0) = static_cast<float>(k);
  const core::StoredImage view = view_of(image, 4.0, 1);
  ASSERT_EQ(view.width, 3u);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(view.at(i, 0, 0), static_cast<float>(4 * i + 1));
  EXPECT_EQ(view_of(image, 2.5, 1).width, 5u) << "no column is missing";
  EXPECT_EQ(view_of(image, 2.6, 1).width, 4u) << "whole lenses";
  EXPECT_EQ(view_names("a/b.png", 3.0),
            (std::vector<std::string>{"a/b-views/view00.png", "a/b-views/view01.png",
                                      "a/b-views/view02.png"}));
}

TEST_F(UnitBatch, MessagesAreOneLineEach) {
  EXPECT_EQ(tool::one_line("a\x1b[31mb  \r"), "a\\x1b[31mb");
  EXPECT_EQ(tool::one_line(std::string(500, 'x'), 10), "xxxxxxxxxx...");
  EXPECT_EQ(tool::one_line("\xc3\xa4\xc3\xa4", 3), "\xc3\xa4...");
  EXPECT_EQ(tool::last_error("banner\nParse Error: Expected '{'\nFatal error in parser\n"),
            "Expected '{'");
}

TEST_F(UnitBatch, TableCountsGrades) {
  Row row = full_row();
  std::vector<Row> rows{row};
  row.name = "c|d";
  row.verdict->grade = "fails";
  row.reason = "broken";
  row.left_out.clear();
  row.verdict->noise_rms.reset();
  rows.push_back(row);
  row.name = "part";
  row.verdict.reset();
  rows.push_back(row);
  const std::string text = table(rows, "lentray-batch x", "3.7");
  EXPECT_NE(text.find("| match | 1 |"), std::string::npos);
  EXPECT_NE(text.find("| a/b#07 | match | 41.5 | 0.00 % | 0.50, 0.38 | -0.25, 0.00 | media |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| c/d | fails |  |  |  |  | broken |"), std::string::npos) << text;
  EXPECT_NE(text.find("Not compared: part."), std::string::npos);
}

}  // namespace
}  // namespace lentray::batch
