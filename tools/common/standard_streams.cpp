#include "tools/common/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

namespace lentray::tool {

void hold_standard_streams() {
  // open() takes the lowest number that is free. Reading what is only for writing fails, and the other way round.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    (void)!::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

int finish_standard_output(const char* program, int status) {
  std::cout.flush();
  errno = 0;
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
  if (!failed) return status;
  std::fprintf(stderr, "%s: cannot write to standard output: %s\n", program,
               errno != 0 ? std::strerror(errno) : "no space, or the disk failed");
  return status == 0 ? 1 : status;
}

}  // namespace lentray::tool
