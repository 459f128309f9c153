// Where the source opens, makes, renames and removes files, or runs programs. What a scene names is opened in
// parser/files and parser/restrictions alone; elsewhere a place is known by who chose it. A call in a file that is not
// listed here fails: it is to go through the gate, or its place is to be thought about first.
#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

namespace lentray {
namespace {

namespace fs = std::filesystem;

/// Who chose the places.
enum class Chosen {
  kScene,   ///< the scene: the gate itself
  kHeld,    ///< the scene, but by a name that the gate held, or a user
  kOutput,  ///< the user or the gate: outputs, written beside their places and renamed
  kUser,    ///< the command line
  kOwn,     ///< the program: files of its own in its output's folder, and temporary ones
  kSystem   ///< /proc, /dev/null and programs that the user's INI files name
};

const std::map<std::string, Chosen>& files_that_open() {
  using enum Chosen;
  static const std::map<std::string, Chosen> files{
      {"core/base/memory_limit.cpp", kSystem},
      {"core/image/byte_file.cpp", kOutput},
      {"core/image/file_swap.cpp", kOutput},
      {"core/image/jpeg_reader.cpp", kHeld},
      {"core/image/openimageio/encoder.cpp", kOutput},
      {"core/image/openimageio/module.cpp", kHeld},
      {"core/image/palette_size.cpp", kHeld},
      {"core/image/palette_tiff.cpp", kHeld},
      {"core/image/photo_tags.cpp", kUser},
      {"core/image/png_chunks.cpp", kHeld},
      {"core/image/reader.cpp", kHeld},
      {"parser/files/files.cpp", kScene},
      {"parser/files/opened_file.cpp", kScene},
      {"parser/files/watched_files.cpp", kHeld},
      {"parser/restrictions/restricted_files.cpp", kScene},
      {"parser/shapes/text_shape.cpp", kHeld},
      {"tools/common/child.cpp", kSystem},
      {"tools/common/machine.cpp", kSystem},
      {"tools/common/own_folder.cpp", kOwn},
      {"tools/common/process.cpp", kOwn},
      {"tools/common/sandbox.cpp", kSystem},
      {"tools/common/standard_streams.cpp", kSystem},
      {"tools/common/thumbnail_store.cpp", kOwn},
      {"tools/lentray/commands.cpp", kSystem},
      {"tools/lentray/frame_depths.cpp", kOwn},
      {"tools/lentray/run_sandbox.cpp", kSystem},
      {"tools/lentray/text_streams.cpp", kUser},
      {"tools/lentray-batch/cluster.cpp", kOwn},
      {"tools/lentray-batch/job.cpp", kOwn},
      {"tools/lentray-batch/manifest.cpp", kOwn},
      {"tools/lentray-batch/row.cpp", kOwn},
      {"tools/lentray-batch/run_folder.cpp", kOwn},
      {"tools/lentray-batch/scan.cpp", kUser},
      {"tools/lentray-batch/state_folder.cpp", kOwn},
      {"tools/lentray-batch/views.cpp", kOwn},
      {"tools/lentray-batch/worker.cpp", kOwn},
      {"tools/lentray-chart/compare.cpp", kOwn},
      {"tools/lentray-chart/measure.cpp", kOwn},
      {"tools/lentray-chart/session.cpp", kOwn},
      {"tools/lentray-chart/state.cpp", kOwn},
      {"tools/lentray-diff/workshop.cpp", kOwn},
      {"tools/lentray-merge/png_head.cpp", kUser},
      {"tools/lentray-merge/png_rows.cpp", kUser},
      {"tools/session/photon_run.cpp", kOutput},
      {"tools/session/radiosity_store.cpp", kUser},
      {"tools/session/ray_dump.cpp", kUser},
      {"tools/session/scene_file.cpp", kOwn},
      {"tools/session/summed_bytes.cpp", kOwn},
      {"tools/session/work_file.cpp", kOwn},
  };
  return files;
}

constexpr std::array<std::string_view, 41> kCalls{"ifstream",
                                                  "ofstream",
                                                  "std::fstream",
                                                  "fopen(",
                                                  "freopen(",
                                                  "::open(",
                                                  "::openat(",
                                                  "::creat(",
                                                  "mkstemp(",
                                                  "mkdtemp(",
                                                  "mkfifo(",
                                                  "popen(",
                                                  "std::system(",
                                                  "::execv",
                                                  "posix_spawn(",
                                                  "::unlink(",
                                                  "::rename(",
                                                  "std::rename(",
                                                  "fs::rename(",
                                                  "::truncate(",
                                                  "::ftruncate(",
                                                  "::chmod(",
                                                  "::mkdir(",
                                                  "::link(",
                                                  "::symlink(",
                                                  "std::remove(",
                                                  "FT_New_Face(",
                                                  "ImageInput::open(",
                                                  "ImageOutput::create(",
                                                  "ImageBuf(",
                                                  "fs::remove(",
                                                  "filesystem::remove(",
                                                  "fs::remove_all(",
                                                  "filesystem::remove_all(",
                                                  "copy_file(",
                                                  "create_director",
                                                  "create_symlink(",
                                                  "create_hard_link(",
                                                  "resize_file(",
                                                  "fs::permissions(",
                                                  "shm_open("};

bool is_part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The call on a line without its comment; empty: none. "Runs::open(" is no call of the system's.
std::string_view call_in(std::string_view line) {
  line = line.substr(0, line.find("//"));
  for (const std::string_view call : kCalls) {
    for (std::size_t at = 0; (at = line.find(call, at)) != line.npos; ++at) {
      if (at == 0 || !is_part_of_name(line[at - 1])) return call;
    }
  }
  return {};
}

TEST(UnitFileGate, CallsAreFound) {
  EXPECT_NE(call_in("  const int file = ::open(path.c_str(), O_RDONLY);"), "");
  EXPECT_NE(call_in("  std::ifstream file(path);"), "");
  EXPECT_NE(call_in("std::filesystem::create_directories(folder, error);"), "");
  EXPECT_NE(call_in("if (std::rename(a, b) != 0)"), "");
  EXPECT_NE(call_in("fs::rename(a, b);"), "");
  EXPECT_EQ(call_in("  sum += Runs::open(row.length);"), "");
  EXPECT_EQ(call_in("void Parser::open(const std::string& path) {"), "");
  EXPECT_EQ(call_in("  swap.commit();  // ::rename()"), "");
}

TEST(UnitFileGate, NoFileIsOpenedBesideIt) {
  const fs::path root = LENTRAY_SOURCE_DIR;
  std::map<std::string, int> found;
  for (const char* top : {"core", "camera", "shadow", "parser", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), root).generic_string();
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        const std::string_view call = call_in(line);
        if (call.empty() || line.find("#include") != line.npos) continue;
        ++found[file];
        EXPECT_TRUE(files_that_open().contains(file)) << file << " calls " << call << ": " << line;
      }
    }
  }
  for (const auto& [file, chosen] : files_that_open()) {
    EXPECT_TRUE(found.contains(file)) << file << " opens nothing any more";
    if (chosen != Chosen::kScene) continue;
    EXPECT_TRUE(file.starts_with("parser/files/") || file.starts_with("parser/restrictions/"))
        << file;
  }
}

}  // namespace
}  // namespace lentray
