// Files of the disk by what was opened, not by name: a name can mean another file a moment later.
// POSIX, and Linux's /proc. Errors: an empty Descriptor, nullopt; errno says. Any thread.
#pragma once

#include <sys/stat.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "parser/files/files.h"

namespace lentray::parser {

/// Owns an open file.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : m_number(number) {}
  Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(m_number, other.m_number);
    return *this;
  }
  ~Descriptor();
  explicit operator bool() const { return m_number >= 0; }
  int number() const { return m_number; }
  int release() { return std::exchange(m_number, -1); }

 private:
  int m_number;
};

/// A hold on what a name means, which neither reads it nor waits for it.
Descriptor look_at(const std::string& path);
/// What is held opened with these flags of open(2).
Descriptor reopen(const Descriptor& held, int flags);
/// "/proc/self/fd/N".
std::string handle_of(const Descriptor& held);
/// Where what is held lies, without links and dots; empty if it lies nowhere any more.
std::string real_path(const Descriptor& held);
/// All zeros if there is none.
struct stat status_of(const Descriptor& held);
/// "a pipe", "a device", "a socket", "a folder"; empty for a plain file.
std::string special_kind(const struct stat& status);
std::optional<std::string> read_all(const Descriptor& file);
/// What a file holds that hold() of the scene's files gave.
std::optional<std::string> read_held(const FoundFile& found);
std::unique_ptr<FileWriter> make_writer(Descriptor file);

}  // namespace lentray::parser
