// A file that appears whole or not at all: written under a temporary name in the folder of its
// place, then renamed. What stood there before stays until that moment. The file is on the disk, not only in the
// system's memory, before it gets its name: a power cut leaves the one or the other.
//
// The temporary file of a.png is called .a.png.lentray-<process>-<number>.part. It is locked while
// its maker lives; one that a killed process left behind is removed by the next that writes a.png:
// when it begins, for the room on the disk, and when it is done.
// Errors: ImageError. Threads: one object a thread.
#pragma once

#include <filesystem>
#include <string>

namespace lentray::core {

/// "'a.png'" or "to standard output", to follow "cannot write ".
std::string shown_place(const std::filesystem::path& place);

/// Opens a pipe or device for writing: -1 and errno if that fails. A pipe that nobody reads is waited for a
/// second at most; then ImageError.
int open_device(const std::filesystem::path& place);

class FileSwap {
 public:
  /// Makes an empty temporary file. Symbolic links are followed. A device such as /dev/null, and
  /// standard output, called "-", are written through a temporary file elsewhere. Throws
  /// ImageError if the place cannot be written.
  explicit FileSwap(const std::filesystem::path& place);
  ~FileSwap();  ///< removes the temporary file unless committed
  FileSwap(const FileSwap&) = delete;
  FileSwap& operator=(const FileSwap&) = delete;

  const std::filesystem::path& temporary() const { return m_temporary; }
  void commit();
  /// Of all objects: for a program that ends in the middle of its work. Any thread.
  static void remove_temporaries();

 private:
  void make_temporary();
  void copy_to_device();

  std::filesystem::path m_place, m_temporary;
  bool m_device = false, m_committed = false;
  int m_lock = -1;  ///< open file
  int m_to = -1;    ///< the device
};

}  // namespace lentray::core
