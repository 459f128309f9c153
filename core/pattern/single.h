// Rounding to single precision and back. Many parameters are kept so, which shows in pictures.
#pragma once

namespace lentray::core {

/// GCC 12 drops the two conversions when it pairs neighbouring ones into a vector
/// (-O2 -fno-trapping-math; held by tests/image/patterns_test.cpp, "gradient x frequency 3 phase .2").
inline double single(double value) {
  const volatile float rounded = static_cast<float>(value);
  return rounded;
}

}  // namespace lentray::core
