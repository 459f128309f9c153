// What a batch knows of one picture: a line of the manifest.
//
// Paths: `source` is absolute; `picture`, `views` and those of the comparison are relative to the batch's
// folder. Times in seconds, memory in bytes. As JSON, members that say nothing are left out.
// Errors: std::invalid_argument where a line is no row. Threads: any number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/lentray-batch/warning_kinds.h"
#include "tools/session/seen.h"

namespace lentray::batch {

/// done: the picture is there. failed: there is none, and `reason` says why. skipped: none was asked for. waiting: the
/// batch was stopped before it was done.
enum class State { done, failed, skipped, waiting };
std::string_view name_of(State state);

/// Stock's picture beside ours.
struct Verdict {
  std::string
      grade;  ///< exact, match, noise, close, differs; fails: only stock has a picture; empty: stock has none
  std::string note;            ///< why there is no grade, or what to expect of it
  std::optional<double> psnr;  ///< dB; none: the pictures are equal, or were not compared
  double beyond_1 = 0.0,
         beyond_2 = 0.0;  ///< shares of the pixels that differ by more than 1/255, 2/255
  double largest = 0.0;   ///< difference, in 1/255
  double block_rms = 0.0, bias = 0.0;           ///< of 16 x 16 means, in 1/255
  std::optional<double> noise_rms, noise_bias;  ///< of stock's own pictures, where they count
  double stock_cpu = 0.0, stock_wall = 0.0;
  double noise_cpu = 0.0;  ///< of the pictures that give its noise, besides
  std::string stock,
      difference;  ///< pictures; the difference is scaled as tools/lentray-diff/report.h says
  /// Of an integral image: how many lenses and views have each grade.
  std::map<std::string, int> lens_grades, view_grades;
  bool operator==(const Verdict&) const = default;
};

struct Row {
  std::string
      name;  ///< unique in the batch: the scene's path below its folder, without ".pov"; "#12": frame; "~2": band
  std::string source;        ///< the scene
  std::optional<int> frame;  ///< of an animation
  std::string band;          ///< "2/16": rows of the picture alone, the third of 16 parts
  State state = State::failed;
  std::string reason;                 ///< one line
  bool lacks_room = false;            ///< it failed for want of room on the disk
  std::vector<std::string> command;   ///< as it was run, in the scene's folder
  int status = 0;                     ///< exit status; 128 + n: ended by signal n
  std::vector<std::string> messages;  ///< lines that the program wrote, progress apart
  int warnings = 0;                   ///< all, those of `kinds` too
  KindsFound kinds;                   ///< what will be wrong with a sheet
  std::string picture;
  std::uint32_t width = 0, height = 0;
  std::uint64_t bytes = 0;         ///< of the picture's file
  tool::FileStamp picture_file{};  ///< it as it was made
  std::vector<std::string>
      views;  ///< files of --views, as their pixels lie behind a lens: the first is the right eye's
  double lens_pixels = 0.0;           ///< pixels a lens of an integral image; 0: no integral image
  std::vector<std::string> left_out;  ///< what the scene has and the picture lacks
  double wall = 0.0, cpu = 0.0, reading = 0.0, building = 0.0, rendering = 0.0, writing = 0.0;
  std::uint64_t memory = 0;        ///< most that was held
  int attempts = 1;                ///< runs of the program that it took
  std::string limits;              ///< of time and memory, that a picture failed within
  std::string finished;            ///< UTC, ISO 8601
  std::optional<Verdict> verdict;  ///< of --compare

  // What it depends on.
  std::string key;    ///< of program and options
  tool::Seen seen{};  ///< by the scene, which is among the files; absolute paths
};

/// Whether a name leads to a place below a folder: one of a row or task that came with scenes may lead elsewhere.
bool is_below(const std::string& name);

nlohmann::json json_of(const Row& row);
Row row_of(const nlohmann::json& json);
/// All rows of a file that has one a line; the last one of a name holds. Lines that are cut off are passed over.
/// `is_cut`: the file does not end in a line's end.
std::map<std::string, Row> rows_in(const std::filesystem::path& file, bool* is_cut = nullptr);

}  // namespace lentray::batch
