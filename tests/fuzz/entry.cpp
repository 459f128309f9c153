// What libFuzzer calls, for all fuzzers: LENTRAY_FUZZ_USE is the function of one kind that gets the inputs.
// Time is processor time, so that what else the machine does decides nothing. An input that takes more than kMostSeconds is a
// fault. After LENTRAY_FUZZ_SECONDS of its process the fuzzer ends in order. The file of LENTRAY_FUZZ_NOTES says what was
// done, for tests/fuzz/fuzz.py.
#include <sys/resource.h>
#include <sys/time.h>
#include <time.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace lentray::test {

std::string LENTRAY_FUZZ_USE(const std::uint8_t* data, std::size_t size);

namespace {

constexpr int kMostSeconds = 10;

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The signal that its end sends is libFuzzer's for a crash.
void limit_input(int seconds) {
  itimerval limit{};
  limit.it_value.tv_sec = seconds;
  ::setitimer(ITIMER_PROF, &limit, nullptr);
}

class Notes {
 public:
  Notes() {
    std::signal(SIGPROF, [](int) { std::abort(); });
  }
  void add(double began, double ended) {
    ++m_inputs;
    m_longest = std::max(m_longest, ended - began);
    if (ended < m_written + 1.0 && ended < m_end) return;
    m_written = ended;
    write(ended);
    if (ended >= m_end) std::raise(SIGUSR1);  // libFuzzer ends in order
  }

 private:
  void write(double now) const {
    std::FILE* const file = m_path != nullptr ? std::fopen(m_path, "w") : nullptr;
    if (file == nullptr) return;
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    std::fprintf(file,
                 "{\"inputs\": %llu, \"seconds\": %.1f, \"longest\": %.3f, \"memory\": %ld}\n",
                 m_inputs, now, m_longest, usage.ru_maxrss * 1024);
    std::fclose(file);
  }

  const char* const m_path = std::getenv("LENTRAY_FUZZ_NOTES");
  const char* const m_seconds = std::getenv("LENTRAY_FUZZ_SECONDS");
  const double m_end =
      m_seconds != nullptr ? std::atof(m_seconds) : std::numeric_limits<double>::infinity();
  unsigned long long m_inputs = 0;
  double m_longest = 0.0, m_written = -1.0;
};

}  // namespace
}  // namespace lentray::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lentray::test;
  static Notes notes;
  const double began = processor_seconds();
  limit_input(kMostSeconds);
  LENTRAY_FUZZ_USE(data, size);
  limit_input(0);
  notes.add(began, processor_seconds());
  return 0;
}
