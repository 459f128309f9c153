// What a radiosity pass leaves to the picture: the samples of every depth, and which of them each pixel
// is to see. World space, colours linear. Constant once the pass is over: any number of threads reads it.
//
// The pass makes samples where none are found, pixel by pixel in a fixed order, and the picture repeats
// what it did: a pixel sees the samples there were then, and is answered by what was gathered for it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/pixel.h"
#include "core/irradiance/directions.h"
#include "core/irradiance/sample_store.h"
#include "core/irradiance/settings.h"

namespace lentray::core {

/// What was gathered for a surface: the answer to a query.
struct GatheredLight {
  Rgb light;
  double quality = 1.0;
  bool is_kept = false;  ///< as a sample
};

/// A query of a pixel's centre and what the pass answered.
struct KnownAnswer {
  std::uint64_t query;  ///< of its place: another ray's is another
  Rgb light;
  bool was_gathered;  ///< the next of what was gathered for the pixel is in it
};

/// What a pixel's centre found.
struct PixelSight {
  std::size_t samples = SampleStore::kAll;  ///< of the first depth it sees so many
  const std::vector<GatheredLight>* gathered =
      nullptr;                             ///< for its queries in order; null: nothing
  std::span<const KnownAnswer> answers{};  ///< in the order of its queries; none: not known
};

class IrradianceCache {
 public:
  IrradianceCache(const RadiositySettings& settings, const Vec3& eye);

  const RadiositySettings& settings() const { return m_settings; }
  const Vec3& eye() const { return m_eye; }
  int depths() const { return static_cast<int>(m_stores.size()); }
  const SampleStore& store(int depth) const { return m_stores[static_cast<std::size_t>(depth)]; }
  SampleStore& store(int depth) { return m_stores[static_cast<std::size_t>(depth)]; }
  /// A cycle at its beginning.
  DirectionCycle directions() const { return DirectionCycle(m_directions); }
  std::size_t bytes() const;
  /// Whether there are samples, and none brings light.
  bool is_dark() const;

  /// Of pictures of that size, whose pixels then are given in order of the pass.
  void begin_sights(std::uint32_t width, std::uint32_t height);
  void see(Pixel pixel, std::size_t samples, std::vector<GatheredLight> gathered);
  /// Of the pixel seen last.
  void answer(std::span<const KnownAnswer> answers);
  PixelSight sight(Pixel pixel) const;
  /// Of the pictures whose pixels were given; 0: none were.
  std::uint32_t seen_width() const { return m_width; }
  std::uint32_t seen_height() const { return m_height; }

 private:
  const RadiositySettings m_settings;
  const Vec3 m_eye;
  std::shared_ptr<const std::vector<Vec3>> m_directions;
  std::vector<SampleStore> m_stores;  ///< one a depth
  std::uint32_t m_width = 0, m_height = 0;
  std::vector<std::uint32_t> m_seen;  ///< samples, of each pixel
  std::unordered_map<std::size_t, std::vector<GatheredLight>> m_gathered;  ///< by pixel
  struct Range {
    std::uint32_t first = 0, count = 0;
  };
  std::size_t m_seen_last = 0;    ///< pixel
  std::vector<Range> m_answered;  ///< of m_answers, of each pixel; empty: none are known
  std::vector<KnownAnswer> m_answers;
};

}  // namespace lentray::core
