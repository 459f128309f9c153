// What the passes of a picture have committed (core/pass/pass_ledger.h), in a file beside the
// picture's journal: a.png.lentray-passes. While passes run it is called a.png.lentray-passes.part;
// a file without that end is whole, and whoever continues it makes nothing anew.
//
// The file begins with what the passes depend on (tools/session/identity.h). Then come records with
// a checksum each; what a killed run left half written is dropped. Passes that end within a second
// leave no file. Errors: parser::OptionError from go_on(). A file that cannot be written is given
// up.
// Threads: one at a time.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/pass/pass_ledger.h"
#include "tools/session/identity.h"

namespace lentray::tool {

class PassFile final : public core::PassLedger {
 public:
  /// Nothing is written before `silence` has passed.
  PassFile(const std::string& picture, const Identity& identity,
           std::chrono::milliseconds silence = std::chrono::seconds(1));
  /// Writes what is kept.
  ~PassFile() override;
  PassFile(const PassFile&) = delete;
  PassFile& operator=(const PassFile&) = delete;

  /// What the passes depend on that an earlier run began. Empty: there are none.
  static std::optional<Identity> earlier(const std::string& picture);
  /// Nothing is kept of the picture's passes any more.
  void forget() const;
  /// Continues what there is. Throws if that is of something else, or if another run is at it.
  void go_on();

  void begin(std::size_t pass) override;
  bool recall(std::string& record) override;
  void keep(std::string_view record) override;
  void finish() override;
  /// The run is cut off in order: writes what is not written yet. False: there is nothing to go on
  /// with.
  bool write();
  /// The file's name while passes run.
  const std::string& part() const { return m_part; }
  /// Why it could not be written; empty: it could, or there was nothing to write.
  const std::string& trouble() const { return m_trouble; }

 private:
  using Clock = std::chrono::steady_clock;

  /// False if there is no file, or none that says anything.
  bool read(const std::string& path, bool is_part);
  void flush();
  void give_up(const std::string& why);

  const std::string m_path, m_part;
  const std::string m_identity;  ///< as text
  const Clock::time_point m_speaks;
  Clock::time_point m_flushed{};
  int m_file = -1;
  bool m_is_whole = false, m_is_off = false;
  std::uint32_t m_pass = 0;
  std::vector<std::vector<std::string>> m_earlier;  ///< records by pass
  std::size_t m_recalled = 0;                       ///< of the pass
  std::string m_pending, m_trouble;
};

}  // namespace lentray::tool
