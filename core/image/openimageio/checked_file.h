// A file for OpenImageIO to write, which remembers the first thing that went wrong: encoders
// lose the reason, and some do not notice that closing failed. One thread.
#pragma once

#include <OpenImageIO/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>

#include "core/image/byte_file.h"

namespace lentray::core {

class CheckedFile final : public OIIO::Filesystem::IOProxy {
 public:
  /// Empties the file; failing to open it is a complaint, too.
  CheckedFile(const std::filesystem::path& path, SpareRoom* spare, CountBytes count);
  ~CheckedFile() override;

  /// The system's word for the first failure, or empty. Final after close().
  const std::string& complaint() const { return m_complaint; }

  const char* proxytype() const override { return "checked file"; }
  void close() override;
  int64_t tell() override;
  bool seek(int64_t offset) override;
  std::size_t read(void* buffer, std::size_t size) override;
  std::size_t write(const void* buffer, std::size_t size) override;
  std::size_t pread(void* buffer, std::size_t size, int64_t offset) override;
  std::size_t pwrite(const void* buffer, std::size_t size, int64_t offset) override;
  std::size_t size() const override;
  void flush() const override;

 private:
  template <class Work>
  bool done(Work work) const;
  // Flushing is const to OpenImageIO.
  mutable std::optional<ByteFile> m_file;
  mutable std::string m_complaint;
};

}  // namespace lentray::core
