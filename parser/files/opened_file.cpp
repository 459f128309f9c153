#include "parser/files/opened_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>

#include "core/image/written_bytes.h"

namespace lentray::parser {
namespace {

class StreamWriter final : public FileWriter {
 public:
  explicit StreamWriter(std::FILE* file) : m_file(file) {}
  ~StreamWriter() override { StreamWriter::close(); }
  StreamWriter(const StreamWriter&) = delete;
  StreamWriter& operator=(const StreamWriter&) = delete;

  std::string write(std::string_view bytes) override {
    if (std::string why = core::count_written(bytes.size()); !why.empty()) return why;
    if (std::fwrite(bytes.data(), 1, bytes.size(), m_file) == bytes.size()) return {};
    return std::strerror(errno);
  }

  std::string close() override {
    if (!m_file) return {};
    return std::fclose(std::exchange(m_file, nullptr)) == 0 ? std::string() : std::strerror(errno);
  }

 private:
  std::FILE* m_file;
};

}  // namespace

Descriptor::~Descriptor() {
  if (m_number >= 0) ::close(m_number);
}

Descriptor look_at(const std::string& path) {
  return Descriptor(::open(path.c_str(), O_PATH | O_CLOEXEC));
}

Descriptor reopen(const Descriptor& held, int flags) {
  return Descriptor(::open(handle_of(held).c_str(), flags | O_CLOEXEC | O_NOCTTY));
}

std::string handle_of(const Descriptor& held) {
  return "/proc/self/fd/" + std::to_string(held.number());
}

std::string real_path(const Descriptor& held) {
  if (status_of(held).st_nlink == 0) return {};
  std::array<char, PATH_MAX> text{};
  const ssize_t size = ::readlink(handle_of(held).c_str(), text.data(), text.size());
  if (size <= 0 || static_cast<std::size_t>(size) == text.size()) return {};
  return {text.data(), static_cast<std::size_t>(size)};
}

struct stat status_of(const Descriptor& held) {
  struct stat status {};
  if (::fstat(held.number(), &status) != 0) return {};
  return status;
}

std::string special_kind(const struct stat& status) {
  switch (status.st_mode & S_IFMT) {
    case S_IFREG: return {};
    case S_IFDIR: return "a folder";
    case S_IFIFO: return "a pipe";
    case S_IFSOCK: return "a socket";
    default: return "a device";
  }
}

std::optional<std::string> read_all(const Descriptor& file) {
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  // One byte more than there is, so that the first piece is the last. Some files have no size.
  const auto size = static_cast<std::size_t>(status_of(file).st_size);
  std::string bytes(size > 0 ? size + 1 : kPiece, '\0');
  for (std::size_t end = 0;;) {
    const ssize_t got = ::read(file.number(), bytes.data() + end, bytes.size() - end);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    end += static_cast<std::size_t>(got);
    if (got == 0) {
      bytes.resize(end);
      return bytes;
    }
    if (end == bytes.size()) bytes.resize(end + kPiece);
  }
}

std::optional<std::string> read_held(const FoundFile& found) {
  const Descriptor file(::open(found.handle.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
  return file ? read_all(file) : std::nullopt;
}

std::unique_ptr<FileWriter> make_writer(Descriptor file) {
  std::FILE* stream = file ? ::fdopen(file.number(), "w") : nullptr;
  if (!stream) return nullptr;
  file.release();
  return std::make_unique<StreamWriter>(stream);
}

}  // namespace lentray::parser
