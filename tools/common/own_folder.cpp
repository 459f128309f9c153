#include "tools/common/own_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace lentray::tool {
namespace {

[[noreturn]] void fail_in(const std::filesystem::path& folder, int error) {
  throw std::runtime_error("cannot write into the folder '" + folder.string() +
                           "': " + std::strerror(error));
}

}  // namespace

void make_folder(const std::filesystem::path& folder, const std::filesystem::path& shown) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail_in(shown, error.value());
}

OwnFolder::OwnFolder(const std::filesystem::path& out, const std::string& program, bool is_alone)
    : m_path(out / ("." + program)) {
  make_folder(m_path, out);
  if (!is_alone) return;
  m_lock = ::open((m_path / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (m_lock < 0) fail_in(out, errno);
  if (::flock(m_lock, LOCK_EX | LOCK_NB) == 0) return;
  ::close(m_lock);
  throw std::runtime_error("another " + program + " works in '" + out.string() + "'");
}

OwnFolder::~OwnFolder() {
  if (m_lock >= 0) ::close(m_lock);
}

}  // namespace lentray::tool
