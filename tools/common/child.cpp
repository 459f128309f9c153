#include "tools/common/child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "tools/common/process.h"

namespace lentray::tool {

namespace {

/// Those that ask to stop, and the one of a child's end.
sigset_t awaited_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&set, signal);
  return set;
}

/// In the child.
void prepare(const Launch& launch) {
  ::setpgid(0, 0);  // a terminal's Ctrl-C is for the parent, which asks its children itself
  const sigset_t set = awaited_signals();
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
  if (launch.cpu_limit > 0.0) {
    const auto seconds = static_cast<rlim_t>(std::ceil(launch.cpu_limit));
    const rlimit limit{seconds, seconds + 5};
    ::setrlimit(RLIMIT_CPU, &limit);
  }
  if (launch.work) ::_exit(launch.work());
}

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
}

std::uint64_t resident_of(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/statm");
  std::uint64_t whole = 0, resident = 0;
  file >> whole >> resident;
  std::uint64_t sum = resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  std::ifstream children("/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) +
                         "/children");
  for (pid_t child = 0; children >> child;) sum += resident_of(child);
  return sum;
}

}  // namespace

Child::Child(const Launch& launch) : m_start(std::chrono::steady_clock::now()) {
  const int log = ::open(launch.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (log < 0)
    throw std::runtime_error("cannot write '" + launch.log.string() + "': " + std::strerror(errno));
  m_pid = start_program(launch.command, launch.folder, log, [&launch] { prepare(launch); });
  const int error = errno;
  ::close(log);
  if (m_pid < 0)
    throw std::runtime_error(std::string("cannot start a program: ") + std::strerror(error));
  ::setpgid(m_pid, m_pid);  // whoever comes first
}

Child::~Child() {
  if (m_pid < 0) return;
  kill();
  end_of(m_pid);
}

void Child::ask_to_stop() const {
  if (m_pid > 0) ::kill(-m_pid, SIGTERM);
}

void Child::kill() const {
  if (m_pid > 0) ::kill(-m_pid, SIGKILL);
}

std::optional<Ended> Child::ended() {
  int status = 0;
  rusage usage{};
  if (m_pid < 0 || ::wait4(m_pid, &status, WNOHANG, &usage) != m_pid) return std::nullopt;
  m_pid = -1;
  return Ended{exit_status(status), seconds(),
               seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
               static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
}

double Child::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

std::uint64_t Child::resident_bytes() const { return m_pid < 0 ? 0 : resident_of(m_pid); }

void hold_signals() {
  const sigset_t set = awaited_signals();
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
  ::signal(SIGXFSZ, SIG_IGN);
  ::signal(SIGPIPE, SIG_IGN);
}

int wait_for_news(std::chrono::milliseconds most) {
  const sigset_t set = awaited_signals();
  const timespec time{most.count() / 1000, (most.count() % 1000) * 1'000'000};
  const int signal = ::sigtimedwait(&set, nullptr, &time);
  return signal == SIGINT || signal == SIGTERM || signal == SIGHUP ? signal : 0;
}

}  // namespace lentray::tool
