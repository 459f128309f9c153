// f_noise3d, which programs know and call without a detour.
#pragma once

#include <memory>
#include <utility>

#include "core/function/function.h"
#include "core/noise/noise.h"

namespace lentray::core {

class NoiseFunction final : public Function {
 public:
  /// The scene's generator: it may still change while the scene is read.
  explicit NoiseFunction(std::shared_ptr<const int> generator)
      : m_generator(std::move(generator)) {}
  std::size_t parameters() const override { return 3; }
  double evaluate(std::span<const double> a) const override {
    return noise(a[0], a[1], a[2], *m_generator);
  }
  bool takes_pairs() const override { return true; }
  Pair evaluate_pair(std::span<const Pair> a) const override {
    return noise(a[0], a[1], a[2], *m_generator);
  }
  const int& generator() const { return *m_generator; }

 private:
  std::shared_ptr<const int> m_generator;
};

}  // namespace lentray::core
