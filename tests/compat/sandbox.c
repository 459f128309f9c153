// A reader of fonts that was taken over: tries to get out of the sandbox and says what it could do, a line each. Loaded
// before FreeType by tests/compat/sandbox.py. OUTSIDE names a folder that nothing may touch.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/openat2.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/ptrace.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

static char in_outside[4096];
static const char* outside(const char* name) {
  snprintf(in_outside, sizeof in_outside, "%s/%s", getenv("OUTSIDE"), name);
  return in_outside;
}

static int tried;
static void tell(const char* what, int is_done) {
  ++tried;
  if (is_done) dprintf(2, "ESCAPED %s\n", what);
}

static int opens(const char* path, int flags) {
  const int file = open(path, flags, 0666);
  if (file >= 0) close(file);
  return file >= 0;
}

static void read_outside(void) {
  char path[4200];
  tell("read", opens(outside("text"), O_RDONLY));
  snprintf(path, sizeof path, "/proc/self/root%s", outside("text"));
  tell("read by /proc/self/root", opens(path, O_RDONLY));
  tell("read by the current folder", opens("/proc/self/cwd/../outside/text", O_RDONLY));
  tell("read by dots", opens("../outside/text", O_RDONLY));
  tell("read by a link", opens("link", O_RDONLY));
  tell("list", opens(outside(""), O_RDONLY | O_DIRECTORY));
  tell("read a font of the user", opens(outside("font.ttf"), O_RDONLY));
  const int held = open(outside("text"), O_PATH);
  snprintf(path, sizeof path, "/proc/self/fd/%d", held);
  tell("reopen", held >= 0 && opens(path, O_RDONLY));
  const int folder = open(outside(""), O_PATH | O_DIRECTORY);
  tell("read beside a folder", folder >= 0 && openat(folder, "text", O_RDONLY) >= 0);
  struct open_how how = {.flags = O_RDONLY};
  tell("openat2", syscall(SYS_openat2, AT_FDCWD, outside("text"), &how, sizeof how) >= 0);
  tell("read /etc/passwd", opens("/etc/passwd", O_RDONLY));
  snprintf(path, sizeof path, "/proc/%d/environ", getppid());
  tell("read another's environment", opens(path, O_RDONLY));
  snprintf(path, sizeof path, "/proc/%d/mem", getppid());
  tell("read another's memory", opens(path, O_RDONLY));
  struct file_handle* handle = calloc(1, sizeof *handle + 128);
  handle->handle_bytes = 128;
  int mount = 0;
  tell("a handle", name_to_handle_at(AT_FDCWD, outside("text"), handle, &mount, 0) == 0 &&
                       open_by_handle_at(AT_FDCWD, handle, O_RDONLY) >= 0);
}

static void write_outside(void) {
  char other[4200];
  snprintf(other, sizeof other, "%s", outside("moved"));
  tell("write", opens(outside("text"), O_WRONLY));
  tell("append", opens(outside("text"), O_WRONLY | O_APPEND));
  tell("truncate by open", opens(outside("text"), O_WRONLY | O_TRUNC));
  tell("truncate", truncate(outside("text"), 0) == 0);
  tell("make", opens(outside("made"), O_WRONLY | O_CREAT));
  tell("make without a name", opens(outside(""), O_WRONLY | O_TMPFILE));
  tell("rename", rename(outside("text"), other) == 0);
  tell("rename out", rename("own", other) == 0);
  tell("rename in", rename(outside("text"), "stolen") == 0);
  tell("remove", unlink(outside("text")) == 0);
  tell("make a folder", mkdir(outside("folder"), 0777) == 0);
  tell("remove a folder", rmdir(outside("empty")) == 0);
  tell("link", link(outside("text"), "hard") == 0);
  tell("link out", link("own", other) == 0);
  tell("symbolic link", symlink("x", outside("symbolic")) == 0);
  tell("mode", chmod(outside("text"), 0777) == 0);
  tell("owner", chown(outside("text"), 1, 1) == 0);
  tell("pipe", mkfifo(outside("pipe"), 0666) == 0);
  tell("node", mknod(outside("node"), S_IFCHR | 0666, 0x103) == 0);
  tell("time", utimensat(AT_FDCWD, outside("text"), 0, 0) == 0);
  tell("time through a link", utimensat(AT_FDCWD, "link", 0, 0) == 0);
  tell("mode by the new call", syscall(452, AT_FDCWD, outside("text"), 0777, 0) == 0);
  tell("an attribute", setxattr(outside("text"), "user.a", "b", 1, 0) == 0);
  tell("exchange", renameat2(AT_FDCWD, "own", AT_FDCWD, outside("text"), RENAME_EXCHANGE) == 0);
  tell("rename over", rename("own", outside("text")) == 0);
  tell("rename by dots", rename("own", "../outside/moved") == 0);
  const int folder = open(outside(""), O_PATH | O_DIRECTORY);
  tell("make beside a folder", openat(folder, "made", O_WRONLY | O_CREAT, 0666) >= 0);
  tell("remove beside a folder", unlinkat(folder, "text", 0) == 0);
  tell("write by the process's root", opens("/proc/self/cwd/../outside/text", O_WRONLY));
  tell("write the system's programs", opens("/usr/bin/lentray-escape", O_WRONLY | O_CREAT));
  tell("write below /tmp", opens("/tmp/lentray-escape", O_WRONLY | O_CREAT));
  tell("write below /dev/shm", opens("/dev/shm/lentray-escape", O_WRONLY | O_CREAT));
  tell("write through a link", opens("link", O_WRONLY));
  tell("make through a link", opens("dangling", O_WRONLY | O_CREAT));
}

static int ends_well(pid_t child) {
  int status = 1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static void reach_others(void) {
  pid_t child = fork();
  if (child == 0) {
    execl("/bin/true", "true", (char*)0);
    _exit(1);
  }
  tell("run a program", ends_well(child));
  child = fork();
  if (child == 0) {
    execl("./own.sh", "own.sh", (char*)0);
    _exit(1);
  }
  tell("run its own program", ends_well(child));
  char* const words[] = {"true", 0};
  child = fork();
  if (child == 0) {
    const int file = memfd_create("x", 0);
    const int from = open("/usr/bin/true", O_RDONLY);
    char bytes[4096];
    for (ssize_t n; (n = read(from, bytes, sizeof bytes)) > 0;)
      (void)!write(file, bytes, (size_t)n);
    fexecve(file, words, words + 1);
    _exit(1);
  }
  tell("run memory", ends_well(child));
  tell("a socket", socket(AF_INET, SOCK_STREAM, 0) >= 0);
  tell("a local socket", socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
  tell("a datagram", socket(AF_INET, SOCK_DGRAM, 0) >= 0);
  child = fork();
  if (child == 0) {
    pause();
    _exit(0);
  }
  tell("trace", ptrace(PTRACE_ATTACH, child, 0, 0) == 0);
  tell("unshare", unshare(CLONE_NEWUSER) == 0);
  kill(child, 9);
  waitpid(child, 0, 0);
  tell("type into the terminal", ioctl(0, TIOCSTI, "x") == 0);
  tell("a queue of messages", msgget(IPC_PRIVATE, 0600) >= 0);
  tell("shared memory", shmget(IPC_PRIVATE, 4096, 0600) >= 0);
  child = fork();
  if (child == 0) _exit(chroot(".") == 0 ? 0 : 1);
  tell("a root of its own", ends_well(child));
  tell("a pipe of this machine", open("/dev/ptmx", O_RDWR) >= 0);
  tell("another's memory by a call", process_vm_readv(getppid(), &(struct iovec){in_outside, 8}, 1,
                                                      &(struct iovec){in_outside, 8}, 1, 0) > 0);
  tell("a ring of calls", syscall(SYS_io_uring_setup, 1, calloc(1, 256)) >= 0);
}

int FT_Init_FreeType(void** library) {
  (void)library;
  dprintf(2, "TAKEN OVER\n");
  reach_others();
  read_outside();
  write_outside();
  dprintf(2, "TRIED %d\n", tried);
  return 1;
}
