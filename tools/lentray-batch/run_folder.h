// What a run on a cluster shares with its workers: DIR/.lentray-batch/slurm/RUN, with the command line, the tasks, and
// the rows that workers add. Each worker writes a file of rows of its own, a line at a time, so that two that are at the
// same task do not meet. Errors: std::runtime_error. One thread.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/lentray-batch/job.h"
#include "tools/lentray-batch/row.h"
#include "tools/lentray-batch/tasks.h"

namespace lentray::batch {

/// An item, and all that a worker needs to know of its picture.
struct Work {
  Item item;
  Scene scene;
  std::optional<int> frame;
};

class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path path) : m_path(std::move(path)) {}
  const std::filesystem::path& path() const { return m_path; }

  /// `words`: the command line; a worker reads it in the same current folder.
  void write(const std::vector<std::string>& words,
             const std::vector<std::vector<Work>>& tasks) const;
  std::vector<std::string> words(std::filesystem::path& folder) const;
  std::vector<Work> task(std::size_t number) const;
  std::size_t tasks() const;

  /// All rows that workers wrote, by name; the last one of a name holds.
  std::map<std::string, Row> results() const;
  /// The file that a worker adds its rows to, and the folder where it makes its files.
  std::filesystem::path result_file(const std::string& worker) const {
    return m_path / "results" / (worker + ".jsonl");
  }
  std::filesystem::path scratch(const std::string& worker) const {
    return m_path / "scratch" / worker;
  }

 private:
  const std::filesystem::path m_path;
};

/// Whether an item's row is that of a whole picture or of a band: the name of its job.
std::string name_of(const Item& item);

}  // namespace lentray::batch
