// What the thread sanitizer is not to report: oneTBB comes without its instrumentation, so that it
// cannot see how parallel_for's threads wait for each other.
#if defined(__SANITIZE_THREAD__)
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
  return "race:/oneapi/tbb/\nrace:libtbb.so\n";
}
#endif
