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

namespace fs = std::filesystem;

namespace {

/// Those that ask to stop, and the one of a child's end.
sigset_t awaited_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&set, signal);
  return set;
}

/// In the child. Async-signal-safe calls, but for `work`.
[[noreturn]] void become(char* const* command, const char* folder, int log,
                         const std::function<int()>& work, double cpu_limit, pid_t parent) {
  end_with(parent);
  ::setpgid(0, 0);  // a terminal's Ctrl-C is for the parent, which asks its children itself
  const sigset_t set = awaited_signals();
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
  if (cpu_limit > 0.0) {
    const auto seconds = static_cast<rlim_t>(std::ceil(cpu_limit));
    const rlimit limit{seconds, seconds + 5};
    ::setrlimit(RLIMIT_CPU, &limit);
  }
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  if (work) ::_exit(work());
  if (*folder != '\0' && ::chdir(folder) != 0) ::_exit(126);
  ::execvp(command[0], command);
  ::_exit(127);
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
  std::vector<std::string> words = launch.command;
  std::vector<char*> command;
  for (std::string& word : words) command.push_back(word.data());
  command.push_back(nullptr);
  const std::string folder = launch.folder.string();
  const int log = ::open(launch.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (log < 0)
    throw std::runtime_error("cannot write '" + launch.log.string() + "': " + std::strerror(errno));
  const pid_t parent = ::getpid();
  m_pid = ::fork();
  if (m_pid == 0)
    become(command.data(), folder.c_str(), log, launch.work, launch.cpu_limit, parent);
  const int error = errno;
  ::close(log);
  if (m_pid < 0)
    throw std::runtime_error(std::string("cannot start a program: ") + std::strerror(error));
  ::setpgid(m_pid, m_pid);  // whoever comes first
}

Child::~Child() {
  if (m_pid < 0) return;
  kill();
  int status = 0;
  while (::waitpid(m_pid, &status, 0) < 0 && errno == EINTR) {
  }
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
  return Ended{WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), seconds(),
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
