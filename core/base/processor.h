// What the processor can do: asked here alone. Functions marked LENTRAY_AVX2 are called only where
// has_avx2() is true, and beside a portable one with the same results.
#pragma once

#define LENTRAY_AVX2 __attribute__((target("avx2,fma")))

namespace lentray::core {

inline bool has_avx2() {
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
}

}  // namespace lentray::core
