// The manifest of a batch: DIR/manifest.jsonl, a row a line (tools/lentray-batch/row.h). Of a name that stands there
// twice the last row holds. A row is appended whole when its picture is in its place; tidy() leaves one a name.
// A line that was cut off is passed over.
// Errors: std::runtime_error. One thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "tools/lentray-batch/row.h"
#include "tools/lentray-batch/state_folder.h"

namespace lentray::batch {

class Manifest {
 public:
  /// Reads what there is.
  Manifest(const std::filesystem::path& out, StateFolder& state);

  const std::map<std::string, Row>& rows() const { return m_rows; }
  /// What is known of a picture; one that waits does so.
  const Row* find(const std::string& name) const;
  /// Names by source, frames apart.
  std::map<std::string, std::string> names() const;
  /// Asks the disk for the room of so many rows to come, where it can give it: pictures of a disk that
  /// fills cannot take it then.
  void reserve(std::size_t rows) const;
  void put(Row row);
  /// The row that is known, with what saves looking at its files again; it is written by tidy().
  void renew(const Row& row) { m_rows[row.name] = row; }
  /// That picture is to be made: until put() has its row, it waits.
  void await(Row row);
  void drop(const std::string& name) { m_rows.erase(name); }
  /// Rewrites the file, sorted by name, with pictures that wait. Throws where that cannot be done.
  void tidy();
  /// Why rows could not be written so far; empty: all are.
  const std::string& trouble() const { return m_trouble; }

 private:
  bool append(const std::string& lines);

  const std::filesystem::path m_path;
  StateFolder& m_state;
  bool m_is_cut = false;  ///< the file does not end in a line's end
  std::map<std::string, Row> m_rows, m_waiting;
  std::string m_pending;  ///< lines that found no room
  std::string m_trouble;
};

}  // namespace lentray::batch
