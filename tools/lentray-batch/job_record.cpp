// Whether a picture of a batch is what its row says, or what a batch that was killed has left.
#include <nlohmann/json.hpp>

#include "core/base/ignored_error.h"
#include "core/image/reader.h"
#include "tools/common/companion.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"
#include "tools/lentray-batch/job.h"

namespace lentray::batch {

namespace fs = std::filesystem;

namespace {

bool can_be_opened(const fs::path& picture) {
  try {
    return core::read_image(picture).width > 0;
  } catch (const core::ImageError&) {
    return false;
  }
}

}  // namespace

std::string Job::limits() const {
  return "time " + std::to_string(m_plan.arguments.time_limit) + ", memory " +
         std::to_string(m_plan.arguments.memory_limit);
}

bool Job::files_are_current() const {
  return !m_row.seen.files.empty() && tool::change_in(m_row.seen).empty();
}

bool Job::fits(const Row& row) const {
  if (row.key != m_row.key || row.source != m_row.source) return false;
  if (row.state == State::done &&
      !tool::is_as_it_was(m_plan.arguments.out / row.picture, row.picture_file))
    return false;
  Job then = *this;
  then.m_row = row;
  return then.files_are_current();
}

bool Job::is_up_to_date(const Row* known) const {
  if (known == nullptr || known->picture != m_row.picture) return false;
  if (known->state == State::failed &&
      (m_plan.arguments.retry || known->lacks_room || known->limits != limits()))
    return false;
  return fits(*known);
}

void Job::adopt(const Row& known) {
  m_row = known;
  m_has_picture = known.state == State::done;
  m_is_over = known.state == State::failed;
  if (!m_plan.arguments.compare) m_row.verdict.reset();
  tool::renew(picture_path(), m_row.picture_file);
  for (auto& [path, stamp] : m_row.seen.files) tool::renew(path, stamp);
}

/// The picture is there, younger than what its scene read, and that has not changed: only the row is missing.
bool Job::adopt_left_over(const Row* known) {
  // What a row says was made, and is not so any more, is no left-over.
  if (known != nullptr && known->state == State::done && known->key == m_row.key) return false;
  const std::int64_t read = tool::modified(run_file("read")),
                     picture = tool::modified(picture_path());
  if (read == 0 || picture < read) return false;
  // Statistics are younger than the picture. Journals of frames and views stay for a while.
  const bool has_statistics = tool::modified(run_file("statistics")) >= picture;
  if (!has_statistics && m_options.lenticular) return false;
  if (tool::modified(tool::journal_path(picture_path().string())) != 0 &&
      !(m_frame && has_statistics))
    return false;
  read_dependencies(read, 0);
  if (!files_are_current() || !can_be_opened(picture_path())) return false;
  drop_journal();
  m_row.state = State::done;
  m_has_picture = true;
  m_row.attempts = 1;
  read_log();
  read_statistics();
  m_row.finished = utc_now();
  return true;
}

bool Job::can_go_on() const {
  const std::int64_t read = tool::modified(run_file("read"));
  if (!m_plan.scratch.empty() || tool::modified(tool::journal_path(picture_path().string())) == 0 ||
      tool::modified(picture_path()) >= read)
    return false;
  Job then = *this;
  then.read_dependencies(read, 0);
  return then.files_are_current();
}

void Job::stamp(const fs::path& path) {
  const parser::Descriptor held = parser::look_at(path.string());
  if (!held ||
      (m_plan.arguments.restricts && !lies_in(m_plan.arguments.inputs, parser::real_path(held))))
    return;
  if (const auto stamp = tool::stamp_of(parser::handle_of(held)))
    m_row.seen.files[path.string()] = *stamp;
}

void Job::read_dependencies(std::int64_t written, std::int64_t since) {
  const nlohmann::json read = tool::json_if_any(tool::file_bytes(run_file("read")));
  m_row.seen = {};
  if (!read.is_object() || tool::modified(run_file("read")) < written) return;
  m_row.seen = tool::seen_in(read, m_scene.source.parent_path(), since);
  if (m_plan.arguments.scene_ini && !m_scene.ini.empty()) {
    stamp(m_scene.ini);
  }
}

}  // namespace lentray::batch
