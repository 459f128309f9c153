#include "tools/common/own_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "tools/common/process.h"

namespace lentray::tool {
namespace {

[[noreturn]] void fail_in(const std::filesystem::path& folder, int error) {
  throw std::runtime_error("cannot write into the folder '" + folder.string() +
                           "': " + std::strerror(error));
}

bool is_written_in_place(const std::filesystem::path& inside) {
  return inside.filename() == "manifest.jsonl" ||
         std::ranges::any_of(inside, [](const std::filesystem::path& part) {
           return part.string().starts_with(".lentray-");
         });
}

}  // namespace

void refuse_links(const std::filesystem::path& out) {
  std::error_code error, none;
  for (std::filesystem::recursive_directory_iterator at(out, error), end; !error && at != end;
       at.increment(error)) {
    const bool is_link = at->is_symlink(none);
    const bool is_hard = !is_link && at->is_regular_file(none) && at->hard_link_count(none) > 1 &&
                         is_written_in_place(at->path().lexically_relative(out));
    if (!is_link && !is_hard) continue;
    throw std::runtime_error("the folder '" + out.string() + "' holds a " +
                             (is_hard ? "hard link" : "link") + ", '" + at->path().string() +
                             "', that may have come with the scenes: take it away, name another "
                             "folder, or say Restrict_IO=Off");
  }
}

void refuse_foreign(const std::filesystem::path& file, const std::string& program,
                    const std::function<bool(const std::filesystem::path&)>& is_ours) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none) ||
      std::filesystem::file_size(file, none) == 0 || is_ours(file))
    return;
  throw std::runtime_error("'" + file.string() + "' is not of " + program +
                           " and would be overwritten: name another place for it, or move it "
                           "away");
}

void refuse_foreign_page(const std::filesystem::path& page, const std::string& program) {
  refuse_foreign(page, program, [&](const std::filesystem::path& file) {
    return file_bytes(file).find("name=\"generator\" content=\"" + program + "\"") !=
           std::string::npos;
  });
}

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
