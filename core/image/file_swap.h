// A file that appears whole or not at all: written under a temporary name in the folder of its
// place, then renamed. What stood there before stays until that moment.
// Errors: ImageError. Threads: one object a thread.
#pragma once

#include <filesystem>

namespace lentray::core {

class FileSwap {
 public:
  /// Symbolic links are followed. A device such as /dev/null is written through a temporary
  /// file elsewhere. Throws ImageError if the place cannot be written.
  explicit FileSwap(const std::filesystem::path& place);
  ~FileSwap();  ///< removes the temporary file unless committed
  FileSwap(const FileSwap&) = delete;
  FileSwap& operator=(const FileSwap&) = delete;

  const std::filesystem::path& temporary() const { return m_temporary; }
  void commit();

 private:
  std::filesystem::path m_place, m_temporary;
  bool m_device = false, m_committed = false;
};

}  // namespace lentray::core
