// The numbers of the C library's rand() in a program that sets no seed. Pure; one sequence an object.
// Source: the additive feedback generator r[i] = r[i - 3] + r[i - 31] of random(3), of which the highest
// 31 bits count.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lentray::core {

class CRandom {
 public:
  CRandom() {
    constexpr std::uint64_t kFactor = 16807, kModulus = 2147483647;
    std::uint64_t word = 1;
    for (std::uint32_t& state : m_state) {
      state = static_cast<std::uint32_t>(word);
      word = word * kFactor % kModulus;
    }
    for (int i = 0; i < kUnused; ++i) next();
  }
  /// 0 .. 2^31 - 1
  std::uint32_t next() {
    m_state[m_place] += m_state[(m_place + kWords - kLag) % kWords];
    const std::uint32_t number = m_state[m_place] >> 1;
    m_place = (m_place + 1) % kWords;
    return number;
  }

 private:
  static constexpr std::size_t kWords = 31, kLag = 3;
  static constexpr int kUnused = 310;  ///< the first numbers, which show the seed
  std::array<std::uint32_t, kWords> m_state;
  std::size_t m_place = kLag;
};

}  // namespace lentray::core
