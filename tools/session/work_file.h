// A file in which work is kept while it is done, so that a later run goes on with it: a mark of its kind, what the
// work depends on (tools/session/identity.h), then records with a number and a checksum each, which are only appended,
// twice a second or once many bytes wait. Quick work leaves no file. What a killed run left half written is dropped.
// Bytes are of this machine's kind.
//
// The picture comes first: a file that finds no room ends behind its last whole record and grows no more, and one
// whose room the picture needs is given up. Errors: parser::OptionError from go_on().
// Threads: one at a time; listens(): any.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "tools/session/identity.h"
#include "tools/session/summed_bytes.h"

namespace lentray::tool {

class WorkFile {
 public:
  using Clock = std::chrono::steady_clock;

  /// Nothing is written before `silence` has passed.
  WorkFile(std::string path, const FileMark& mark, const Identity& identity,
           std::chrono::milliseconds silence);
  /// Writes what waits.
  ~WorkFile();
  WorkFile(const WorkFile&) = delete;
  WorkFile& operator=(const WorkFile&) = delete;

  /// What an earlier run's work depends on. Empty: there is no file of that kind.
  static std::optional<Identity> earlier(const std::string& path, const FileMark& mark);
  /// Removes a file of that kind, unless a run is at it.
  static void forget(const std::string& path, const FileMark& mark);
  /// Bytes that the plain file there takes on the disk; 0: there is none.
  static std::uint64_t room_of(const std::string& path);

  enum class Earlier { none, cut, whole };
  /// Is told a record of an earlier run, and where in the file its bytes are; false: it is none of this kind.
  using Tell =
      std::function<bool(std::uint32_t number, std::uint64_t place, const std::string& bytes)>;
  /// Goes on with what there is at `path`, which is the file's from then on, up to the first record that is not whole; what follows is cut off. Throws if it is of
  /// something else, or if another run is at it.
  Earlier go_on(const std::string& path, const Tell& tell);
  /// Bytes of a record. Throws parser::OptionError.
  void read(std::uint64_t place, std::string& bytes) const;

  /// Whether a record is worth making.
  bool listens() const;
  void append(std::uint32_t number, std::string_view bytes);
  /// The run is cut off in order: writes what waits. False: there is nothing to go on with.
  bool keep();
  /// Drops what waits and all there is; the file then has that mark and says what the work depended on.
  void say(const FileMark& mark);
  /// Under another name; it is on the disk before.
  void rename(const std::string& path);
  /// Drops what waits. Nothing is kept any more; the file stays as it is.
  void close();
  /// The same, and there is no file, whatever somebody has made of it since, nor one of an earlier run.
  void remove();
  /// Removes it for its room. False: there was none.
  bool give();

  const std::string& path() const { return m_path; }
  bool is_open() const { return m_file >= 0; }
  /// Nothing was given up.
  bool is_good() const { return !m_is_off; }
  std::uint64_t room() const { return room_of(m_path); }
  /// What is to be said of a file that is not what it should be, as a sentence; empty: nothing.
  std::string trouble() const;

 private:
  void begin();
  void write(std::string_view bytes);
  void flush();
  void give_up(int error);

  std::string m_path;
  FileMark m_mark;
  const Identity m_identity;
  const Clock::time_point m_speaks;  ///< from then on
  Clock::time_point m_flushed{};
  int m_file = -1;
  std::uint64_t m_whole = 0;  ///< bytes of the file that are whole records
  bool m_goes_on = false, m_is_given = false;
  std::string m_pending, m_trouble;
  std::atomic<bool> m_is_off{false};
};

}  // namespace lentray::tool
