#include "tools/common/sandbox.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>

// Newer than some systems' headers.
#ifndef LANDLOCK_ACCESS_FS_REFER
#define LANDLOCK_ACCESS_FS_REFER (1ULL << 13)
#endif
#ifndef LANDLOCK_ACCESS_FS_TRUNCATE
#define LANDLOCK_ACCESS_FS_TRUNCATE (1ULL << 14)
#endif

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kReads = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kFileWrites = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_TRUNCATE;
constexpr std::uint64_t kWrites = kReads | kFileWrites | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                  LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                  LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REFER;
/// What no place permits.
constexpr std::uint64_t kNever = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                 LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                 LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

/// Those that a kernel of that version knows.
std::uint64_t known(std::uint64_t rights, long version) {
  if (version < 2) rights &= ~std::uint64_t{LANDLOCK_ACCESS_FS_REFER};
  if (version < 3) rights &= ~std::uint64_t{LANDLOCK_ACCESS_FS_TRUNCATE};
  return rights;
}

class Ruleset {
 public:
  explicit Ruleset(long version) : m_version(version) {
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = known(kWrites | kNever, version);
    m_file =
        static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
  }
  ~Ruleset() {
    if (m_file >= 0) ::close(m_file);
  }
  Ruleset(const Ruleset&) = delete;
  Ruleset& operator=(const Ruleset&) = delete;

  void permit(const fs::path& place, std::uint64_t rights) const {
    const int held = ::open(place.c_str(), O_PATH | O_CLOEXEC);
    if (held < 0) return;
    struct stat status {};
    if (::fstat(held, &status) == 0) {
      if (!S_ISDIR(status.st_mode)) rights &= LANDLOCK_ACCESS_FS_READ_FILE | kFileWrites;
      landlock_path_beneath_attr rule{};
      rule.allowed_access = known(rights, m_version);
      rule.parent_fd = held;
      ::syscall(SYS_landlock_add_rule, m_file, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    }
    ::close(held);
  }
  bool enter() const {
    return m_file >= 0 && ::syscall(SYS_landlock_restrict_self, m_file, 0) == 0;
  }

 private:
  const long m_version;
  int m_file = -1;
};

bool gain_no_rights() { return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0; }

std::string trouble(const char* what) {
  return std::string(what) + " (" + std::strerror(errno) + ")";
}

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0;
#endif

constexpr std::uint32_t kFchmodat2 = 452;  ///< newer than some systems' headers

/// Requests of ioctl(): what they put into a terminal, whose shell runs it, seems to have been typed.
constexpr std::array<std::uint32_t, 2> kRefusedRequests{TIOCSTI, TIOCLINUX};

/// No renderer makes them, and what takes one over would.
constexpr auto kRefusedCalls = std::to_array<std::uint32_t>({
  SYS_execve, SYS_execveat, SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_socket,
      SYS_socketpair, SYS_connect, SYS_bind, SYS_fchmodat, SYS_fchown, SYS_fchownat, SYS_setxattr,
      SYS_lsetxattr, SYS_fsetxattr, SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot, SYS_unshare,
      SYS_setns, SYS_bpf, SYS_perf_event_open, SYS_keyctl, SYS_add_key, SYS_request_key,
      SYS_kexec_load, SYS_init_module, SYS_finit_module, SYS_open_by_handle_at, SYS_userfaultfd,
      SYS_io_uring_setup, SYS_pidfd_getfd, SYS_linkat, SYS_symlinkat, SYS_mknodat, SYS_utimensat,
      SYS_removexattr, SYS_lremovexattr, SYS_mq_open, SYS_shmget, SYS_msgget, SYS_semget, kFchmodat2
#if defined(__x86_64__)
      ,
      SYS_chmod, SYS_chown, SYS_lchown, SYS_link, SYS_symlink, SYS_mknod, SYS_utime, SYS_utimes,
      SYS_futimesat
#endif
});

}  // namespace

std::string bound_files(const SandboxPlaces& places) {
  const long version =
      ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return trouble("this kernel has no Landlock");
  const Ruleset rules(version);
  for (const fs::path& place : places.reads) rules.permit(place, kReads);
  for (const fs::path& place : places.writes) rules.permit(place, kWrites);
  return gain_no_rights() && rules.enter() ? "" : trouble("Landlock does not take the rules");
}

std::string bound_calls() {
  if (kMachine == 0) return "there is no filter of system calls for this processor";
  constexpr std::uint32_t kRefused = SECCOMP_RET_ERRNO | EPERM;
  constexpr auto kCount = static_cast<std::uint8_t>(kRefusedCalls.size());
  constexpr std::uint8_t kIoctl = 5;  ///< statements about it
  std::vector<sock_filter> program{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kMachine, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, kRefused),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      // Numbers of x86-64's other way to call have this bit.
      BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, 0x40000000, kCount + kIoctl + 1, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_ioctl, 0, kIoctl - 1),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[1])),  // its lower half
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kRefusedRequests[0], kCount + 3, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kRefusedRequests[1], kCount + 2, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  for (std::size_t i = 0; i < kRefusedCalls.size(); ++i) {
    const auto to_end = static_cast<std::uint8_t>(kCount - i);
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kRefusedCalls[i], to_end, 0));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  program.push_back(BPF_STMT(BPF_RET | BPF_K, kRefused));
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (gain_no_rights() && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0) return "";
  return trouble("this kernel takes no filter of system calls");
}

}  // namespace lentray::tool
