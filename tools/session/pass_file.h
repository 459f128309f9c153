// What the passes of a picture have committed (core/pass/pass_ledger.h), in a WorkFile beside the
// picture's journal: a.png.lentray-passes. While passes run it is called a.png.lentray-passes.part;
// a file without that end is whole, and whoever continues it makes nothing anew.
//
// Passes that end within a second leave no file. Errors: parser::OptionError from go_on().
// Threads: one at a time; bytes() and give() once the passes are done.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/spare_room.h"
#include "core/pass/pass_ledger.h"
#include "tools/session/identity.h"
#include "tools/session/work_file.h"

namespace lentray::tool {

class PassFile final : public core::PassLedger, public core::SpareRoom {
 public:
  /// Nothing is written before `silence` has passed.
  PassFile(const std::string& picture, const Identity& identity,
           std::chrono::milliseconds silence = std::chrono::seconds(1));

  /// What the passes depend on that an earlier run began. Empty: there are none.
  static std::optional<Identity> earlier(const std::string& picture);
  /// Nothing is kept of the picture's passes any more.
  void forget();
  /// Continues what there is. Throws as WorkFile::go_on().
  void go_on();

  void begin(std::size_t pass) override;
  bool recall(std::string& record) override;
  void keep(std::string_view record) override;
  void finish() override;
  /// The run is cut off in order: writes what is not written yet. False: there is nothing to go on
  /// with.
  bool write() { return m_work.keep(); }
  /// The file's name; while passes run that of the part.
  const std::string& path() const { return m_work.path(); }
  /// As WorkFile has it.
  std::string trouble() const { return m_work.trouble(); }

  /// That the records take, or those that an earlier run left.
  std::uint64_t bytes() override;
  /// Nothing is kept any more on the disk.
  bool give() override;

 private:
  const std::string m_path;
  WorkFile m_work;
  bool m_is_whole = false;
  std::uint32_t m_pass = 0;
  std::vector<std::vector<std::string>> m_earlier;  ///< records by pass
  std::size_t m_recalled = 0;                       ///< of the pass
};

}  // namespace lentray::tool
