// Random numbers that depend on nothing but what they are for: a pixel, one of its samples, the
// place of a ray in the tree of rays, a use, a dimension. So a picture has the same bits for every
// order of work, be it depth first or breadth first. Pure functions.
// Source: splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
#pragma once

#include <cstdint>

namespace lentray::core {

/// A bijection of 64 bits that leaves no pattern.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// The key of one of the branches of what a key is for: a ray that goes on from a surface, a layer
/// there, a light. Keys of branches of branches are as different as those of branches. Cheap: what
/// uses a key mixes it.
constexpr std::uint64_t branch_key(std::uint64_t key, std::uint64_t branch) {
  return key * 0xd1342543de82ef95ull + (branch + 1) * 0x9e3779b97f4a7c15ull;
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
    kLightArea = 0x6c696768746172,  ///< where the shadow rays to an area light end
    kLightPoints = 0x6c6967687470,  ///< the points of an area light that shine each on its own
    kCrand = 0x6372616e64726179,    ///< a finish's crand
    kMedia = 0x6d6564696172,        ///< the samples of media along a ray
    kMediaLights = 0x6d65646c6967,  ///< the lights at these samples
    kRainbow = 0x7261696e626f77,    ///< a rainbow's jitter
    kFilm = 0x66696c6d,             ///< the place of a sample in its pixel
    kAperture = 0x61706572,         ///< the point of a camera's aperture a ray starts at
    kShadowMedia = 0x6d65646961,    ///< media in the way of a shadow ray
    kSubsurface = 0x73756273,       ///< where subsurface light enters and is scattered
    kPixelPlace = 0x706c616365,     ///< the places in a pixel of the rays of one blurred sample
  };
  /// The key of what has random numbers of its own in one use.
  static constexpr std::uint64_t use_key(std::uint64_t key, Use use) {
    return mixed(key ^ static_cast<std::uint64_t>(use));
  }
  RandomSequence(std::uint64_t key, Use use) : m_state(use_key(key, use)) {}
  double next() {
    m_state = mixed(m_state);
    return static_cast<double>(m_state >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t m_state;
};

}  // namespace lentray::core
