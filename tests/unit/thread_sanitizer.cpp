// What the thread sanitizer is not to report: oneTBB comes without its instrumentation, so that it
// cannot see how parallel_for's threads wait for each other.
#if defined(__SANITIZE_THREAD__)
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
  return "race:/oneapi/tbb/\nrace:libtbb.so\n";
}
/// Reports whose older stack is forgotten cannot be told apart from others: remember as much as it can.
extern "C" const char* __tsan_default_options();
extern "C" const char* __tsan_default_options() { return "history_size=7"; }
#endif
