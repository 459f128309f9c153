// What the processor can do: asked here alone. Functions marked LENTRAY_AVX2 are called only where
// has_avx2() is true, and beside a portable one with the same results. On other processors than x86 they
// are plain code (core/base/simd.h) that tests alone call.
#pragma once

#if defined(__x86_64__)
#define LENTRAY_AVX2 __attribute__((target("avx2,fma")))
#else
#define LENTRAY_AVX2
#endif

namespace lentray::core {

inline bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}

/// Whether functions marked LENTRAY_AVX2 can run, be it as plain code.
inline bool can_run_avx2() {
#if defined(__x86_64__)
  return has_avx2();
#else
  return true;
#endif
}

}  // namespace lentray::core
