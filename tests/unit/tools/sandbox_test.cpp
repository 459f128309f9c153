// The system's bounds for a process: what files it still opens, and which calls it no longer makes. Each in a process
// of its own, since bounds stay. On kernels without them nothing is tested.
#include "tools/common/sandbox.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <functional>
#include <string>

#include "tools/common/process.h"

namespace lentray::sandbox_test {
namespace {

namespace fs = std::filesystem;
using namespace tool;

constexpr int kLacking = 77;

/// The exit status of `work` in a process with those bounds; kLacking: the system has none.
int within(const std::function<std::string()>& bounds, const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(bounds().empty() ? work() : kLacking);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool opens(const fs::path& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  if (file >= 0) ::close(file);
  return file >= 0;
}

class UnitSandbox : public ::testing::Test {
 protected:
  UnitSandbox() {
    for (const char* name : {"reads", "writes", "outside"}) {
      fs::create_directory(m_folder / name);
      write_text(m_folder / name / "a", "text");
    }
    fs::create_symlink("../outside/a", m_folder / "writes/link");
  }
  /// The number of the first of these that is not as it should be; 0: all are.
  int first_fault(const std::function<bool(int)>& holds, int count) const {
    return within(
        [this] {
          return bound_files({{m_folder / "reads", m_folder / "none"}, {m_folder / "writes"}});
        },
        [&] {
          for (int i = 1; i <= count; ++i) {
            if (!holds(i)) return i;
          }
          return 0;
        });
  }

  const TemporaryFolder m_folder;
};

TEST_F(UnitSandbox, FilesElsewhereAreOutOfReach) {
  const fs::path in = m_folder / "writes", out = m_folder / "outside", reads = m_folder / "reads";
  const int fault = first_fault(
      [&](int i) {
        switch (i) {
          case 1: return !opens(out / "a", O_RDONLY);
          case 2: return !opens(out / "a", O_WRONLY);
          case 3: return !opens(out / "new", O_WRONLY | O_CREAT);
          case 4: return !opens(in / "link", O_RDONLY);
          case 5: return std::rename((in / "a").c_str(), (out / "b").c_str()) != 0;
          case 6: return std::rename((out / "a").c_str(), (in / "b").c_str()) != 0;
          case 7: return ::unlink((out / "a").c_str()) != 0;
          case 8: return ::truncate((out / "a").c_str(), 0) != 0;
          case 9: return !opens(reads / "a", O_WRONLY);
          case 10: return ::unlink((reads / "a").c_str()) != 0;
          case 11: return ::mkdir((out / "d").c_str(), 0777) != 0;
          case 12: return ::symlink("x", (in / "s").c_str()) != 0;
          case 13: return ::mkfifo((in / "f").c_str(), 0666) != 0;
          case 14: return !opens("/etc/passwd", O_RDONLY);
          default: return !opens(out, O_RDONLY | O_DIRECTORY);
        }
      },
      15);
  if (fault == kLacking) GTEST_SKIP() << "no Landlock";
  EXPECT_EQ(fault, 0);
  EXPECT_EQ(read_text(out / "a"), "text");
  EXPECT_EQ(read_text(reads / "a"), "text");
  EXPECT_FALSE(fs::exists(out / "b") || fs::exists(out / "new"));
}

TEST_F(UnitSandbox, FilesOfItsPlacesAreNot) {
  const fs::path in = m_folder / "writes", reads = m_folder / "reads";
  const int fault = first_fault(
      [&](int i) {
        switch (i) {
          case 1: return opens(reads / "a", O_RDONLY);
          case 2: return opens(reads, O_RDONLY | O_DIRECTORY);
          case 3: return opens(in / "new", O_RDWR | O_CREAT | O_EXCL);
          case 4: return opens(in / "a", O_RDWR | O_TRUNC);
          case 5: return ::mkdir((in / "d").c_str(), 0777) == 0;
          case 6: return std::rename((in / "new").c_str(), (in / "d/moved").c_str()) == 0;
          default: return ::unlink((in / "d/moved").c_str()) == 0;
        }
      },
      7);
  if (fault == kLacking) GTEST_SKIP() << "no Landlock";
  EXPECT_EQ(fault, 0);
}

TEST_F(UnitSandbox, CallsAreRefused) {
  const int fault = within(bound_calls, [this] {
    if (::socket(AF_INET, SOCK_STREAM, 0) >= 0) return 1;
    if (::socket(AF_UNIX, SOCK_STREAM, 0) >= 0) return 2;
    if (::chmod((m_folder / "writes/a").c_str(), 0777) == 0) return 3;
    if (::link((m_folder / "writes/a").c_str(), (m_folder / "writes/b").c_str()) == 0) return 4;
    ::execl("/bin/true", "true", nullptr);
    if (errno != EPERM) return 5;
    const pid_t child = ::fork();  // as threads are made
    if (child == 0) ::_exit(0);
    if (child < 0) return 6;
    return opens(m_folder / "writes/new", O_WRONLY | O_CREAT) ? 0 : 7;
  });
  if (fault == kLacking) GTEST_SKIP() << "no filter of system calls";
  EXPECT_EQ(fault, 0);
}

}  // namespace
}  // namespace lentray::sandbox_test
