// One picture of a batch: what is to be run for it, and what became of that.
//
// A picture is made by a run of lentray, which may make views of the same scene besides
// (tools/lentray-batch/picture_run.h), or by several, where one is stopped to be continued. Then come its views, and
// stock's picture beside it. The row is complete when all has been done.
// Errors: parser::OptionError where the scene's own options cannot be. One thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parser/options/options.h"
#include "tools/common/child.h"
#include "tools/lentray-batch/arguments.h"
#include "tools/lentray-batch/row.h"
#include "tools/lentray-batch/scan.h"
#include "tools/lentray-batch/state_folder.h"

namespace lentray::batch {

/// What all jobs of a batch share.
struct Plan {
  Arguments arguments;
  int processors = 1;
  double memory = 0.0;        ///< bytes of the machine
  double turn = 20.0;         ///< seconds after which a picture is first put off for others
  std::uint64_t program = 0;  ///< checksum of lentray
  const StateFolder* state = nullptr;
  std::filesystem::path
      scratch;  ///< a worker's own: files are made there and moved to their places; empty: none

  double memory_limit() const {
    return arguments.memory_limit > 0.0 ? arguments.memory_limit : 0.5 * memory;
  }
};

/// How many times a scene's limit one picture of stock's may take.
inline constexpr double kStocksTimes = 5.0;

/// Rows of a picture that a job makes alone.
struct Band {
  int index = 0, count = 1;
  std::int64_t first_row = 1, last_row = 1;  ///< as +SR and +ER
};

class Job {
 public:
  /// `frame`: of an animation; none: a still. `band`: none: the whole picture.
  Job(const Plan& plan, Scene scene, const parser::RenderOptions& options,
      std::optional<parser::AnimationFrame> frame, std::optional<Band> band = std::nullopt);

  const std::string& name() const { return m_row.name; }
  const Row& row() const { return m_row; }
  const Scene& scene() const { return m_scene; }
  const parser::RenderOptions& options() const { return m_options; }
  const std::optional<parser::AnimationFrame>& frame() const { return m_frame; }
  /// The options of its runs: the batch's, scene.ini, and its frame, or those up to the one of `last`.
  std::vector<std::string> words(const Job* last = nullptr) const;
  /// One run may make this view after that picture, without reading the scene again.
  bool is_view_after(const Job& earlier) const;

  /// True if `known` (may be null) is a row of this very picture and nothing of it has changed. What --compare and
  /// --views ask for may still be missing.
  bool is_up_to_date(const Row* known) const;
  /// True if a row, perhaps of a band of it, is of this picture, and what it was made of is as it was.
  bool fits(const Row& row) const;
  /// Takes over what is known, or what a batch that was killed has left without a row.
  void adopt(const Row& known);
  bool adopt_left_over(const Row* known);

  bool needs_picture() const { return !m_has_picture && !m_is_over; }
  bool needs_views() const;
  bool needs_comparison() const;

  /// The run of this picture, and of the views up to `last`. `goes_on`: with what an earlier run kept of one of them.
  tool::Launch render(const Job& last, bool goes_on, int threads, double memory) const;
  bool can_go_on() const;
  /// That run is about to be started; it comes to this picture; is done with it, and continues with others.
  void prepare(const tool::Launch& launch);
  void begin(int threads);
  bool is_made() const;
  /// What the picture took of the run.
  tool::Ended part() const;
  /// Its run has written more messages than a picture may have.
  bool says_too_much() const;
  /// The run has read the scene.
  bool is_read() const;
  /// `stopped`: it was asked to, to be continued.
  void rendered(const tool::Ended& ended, bool stopped);
  /// The run took more memory than it was given, and may be given more.
  bool lacked_memory() const { return m_lacked_memory; }
  /// The run found too little room on the disk.
  bool lacked_room() const { return m_is_over && m_row.lacks_room; }
  /// The bytes that the picture may need, and its journal, at most about.
  double room(bool with_journal = true) const;
  /// What an earlier run kept of the picture goes. False: there is nothing.
  bool drop_journal() const;
  void drop_picture() const;
  tool::Launch split_views();
  void views_split(const tool::Ended& ended);
  tool::Launch compare(int processes);
  void compared(const tool::Ended& ended);
  /// Of a band: the comparison of the whole picture needs what it says of the lens.
  void publish_statistics(const Row& band) const;
  /// It is not to be run any more; or is, after all.
  void give_up(const std::string& reason);
  /// As that view of the same scene did.
  void fail_as(const Row& view);
  void try_again() { m_is_over = false; }
  /// Seconds that all runs for the picture took.
  double seconds() const { return m_row.wall; }

 private:
  std::vector<std::string> command(const Job& last, int threads) const;
  std::filesystem::path given_file(const char* kind) const;
  std::filesystem::path run_file(const char* kind) const;
  std::filesystem::path kept_file(const char* kind) const;
  std::filesystem::path root() const;
  void publish();
  void move_from_scratch(const std::string& picture) const;
  std::filesystem::path picture_path() const;
  std::filesystem::path made_picture() const;
  std::string limits() const;
  /// Remembers what a file is that the row was made of, unless its name leads out of a restricted batch.
  void stamp(const std::filesystem::path& path);
  /// Of a file written then or later. `since`: when the scene was read at the earliest; 0: not known, and checksums
  /// decide.
  void read_dependencies(std::int64_t written, std::int64_t since);
  void read_statistics();
  void read_log();
  void fail(const tool::Ended& ended);
  bool files_are_current() const;
  bool is_view() const { return m_frame && m_options.animation.views.count > 0; }

  const Plan& m_plan;
  const Scene m_scene;
  const parser::RenderOptions m_options;
  const std::optional<parser::AnimationFrame> m_frame;
  const std::optional<Band> m_band;
  std::string m_scene_key;  ///< of all frames or views
  Row m_row;
  std::filesystem::path m_log;  ///< of the run that makes it, or made it
  std::int64_t m_started = 0;   ///< of that run
  bool m_has_picture = false, m_is_over = false, m_lacked_memory = false;
  bool m_views_failed = false;
};

/// The pictures of a scene that has more than one: frames of an animation, or the views of `Views=`, whose frame number
/// is here that of the view. Throws parser::OptionError if there are too many.
std::vector<parser::AnimationFrame> pictures_of(const parser::RenderOptions& options);
struct PictureSize {
  double width = 0.0, height = 0.0;
  double pixels() const { return width * height; }
};
/// Of a view its own size, not that of the integral image.
PictureSize size_of(const parser::RenderOptions& options);
/// Of the file, in which an integral image whose lenses lie across is on its side.
double rows_of_file(const parser::RenderOptions& options);
/// For rows: ISO 8601.
std::string utc_now();
/// The word that names a scene in its own folder.
std::string word_of(const Scene& scene);
/// The scene's folder, held, becomes the program's current folder. Throws std::runtime_error if it leads out of a
/// restricted batch.
void enter_folder(tool::Launch& launch, const Plan& plan, const Scene& scene);
/// Where a band of a picture is kept until all are there, relative to the batch's folder.
std::string band_picture(const std::string& picture, int index);
/// The scene's options: the batch's, then those of scene.ini. Throws parser::OptionError.
parser::RenderOptions options_of(const Plan& plan, const Scene& scene);
/// A row without a picture: of a part, or of a scene whose options cannot be.
Row row_without_job(const Plan& plan, const Scene& scene, State state, const std::string& reason);

}  // namespace lentray::batch
