// Random numbers that depend on nothing but what they are for: a pixel, one of its samples, a
// dimension. So a picture has the same bits for every order of work. Pure functions.
// Source: splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
#pragma once

#include <cstdint>
#include <optional>

namespace lentray::core {

/// A bijection of 64 bits that leaves no pattern.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// Part `part` of what a key is for; part 0 keeps the key.
constexpr std::uint64_t part_key(std::uint64_t key, std::uint32_t part) {
  return part == 0 ? key : mixed(key ^ mixed(part));
}

/// A sample of a pixel. The pixel may lie outside the picture; sample 0 is the one it has always.
constexpr std::uint64_t sample_key(std::int32_t column, std::int32_t row, std::uint32_t sample) {
  const std::uint64_t pixel = static_cast<std::uint64_t>(static_cast<std::uint32_t>(row)) << 32 |
                              static_cast<std::uint32_t>(column);
  return part_key(pixel, sample);
}

/// A sequence of numbers in [0, 1), one a dimension. Sequences of different uses share no numbers.
class RandomSequence {
 public:
  enum class Use : std::uint64_t {
    kShading = 0x6c656e74726179,  ///< lights' areas, crand, rainbows: along the ray's path
    kFilm = 0x66696c6d,           ///< the place of a sample in its pixel
    kAperture = 0x61706572,       ///< the point of a camera's aperture a ray starts at
    kShadowMedia = 0x6d65646961,  ///< media in the way of a shadow ray
    kPixelPlace = 0x706c616365,   ///< the places in a pixel of the rays of one blurred sample
  };
  RandomSequence(std::uint64_t key, Use use)
      : m_state(mixed(key ^ static_cast<std::uint64_t>(use))) {}
  double next() {
    m_state = mixed(m_state);
    return static_cast<double>(m_state >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t m_state;
};

/// The numbers of one sample, of one use; the sequence begins when the first is asked for.
class SampleRandom {
 public:
  explicit SampleRandom(RandomSequence::Use use) : m_use(use) {}
  void begin(std::uint64_t key) {
    m_key = key;
    m_sequence.reset();
  }
  double next() {
    if (!m_sequence) m_sequence.emplace(m_key, m_use);
    return m_sequence->next();
  }

 private:
  RandomSequence::Use m_use;
  std::uint64_t m_key = 0;
  std::optional<RandomSequence> m_sequence;
};

}  // namespace lentray::core
