#include "core/irradiance/irradiance_cache.h"

#include <algorithm>

namespace lentray::core {

IrradianceCache::IrradianceCache(const RadiositySettings& settings, const Vec3& eye)
    : m_settings(settings), m_eye(eye),
      m_directions(std::make_shared<const std::vector<Vec3>>(
          cosine_weighted_directions(static_cast<std::size_t>(settings.direction_pool)))) {
  for (int depth = 0; depth < settings.recursion_limit; ++depth) {
    m_stores.emplace_back(settings, depth);
  }
}

std::size_t IrradianceCache::bytes() const {
  std::size_t bytes = m_directions->size() * sizeof(Vec3) + m_seen.size() * sizeof(m_seen[0]);
  for (const SampleStore& store : m_stores) bytes += store.bytes();
  for (const auto& [pixel, gathered] : m_gathered) {
    bytes += sizeof(pixel) + sizeof(gathered) + gathered.size() * sizeof(GatheredLight);
  }
  bytes += m_answered.size() * sizeof(Range) + m_answers.capacity() * sizeof(KnownAnswer);
  return bytes;
}

bool IrradianceCache::is_dark() const {
  const std::vector<IrradianceSample>& samples = store(0).samples();
  return !samples.empty() &&
         std::all_of(samples.begin(), samples.end(),
                     [](const IrradianceSample& sample) { return sample.light.is_black(); });
}

void IrradianceCache::begin_sights(std::uint32_t width, std::uint32_t height) {
  m_width = width;
  m_height = height;
  m_seen.assign(std::size_t{width} * height, 0);
}

void IrradianceCache::see(Pixel pixel, std::size_t samples, std::vector<GatheredLight> gathered) {
  const std::size_t place = std::size_t{pixel.row} * m_width + pixel.column;
  m_seen[place] = static_cast<std::uint32_t>(samples);
  if (!gathered.empty()) m_gathered.emplace(place, std::move(gathered));
  m_seen_last = place;
}

void IrradianceCache::answer(std::span<const KnownAnswer> answers) {
  if (answers.empty()) return;
  m_answered.resize(m_seen.size());
  m_answered[m_seen_last] = {static_cast<std::uint32_t>(m_answers.size()),
                             static_cast<std::uint32_t>(answers.size())};
  m_answers.insert(m_answers.end(), answers.begin(), answers.end());
}

PixelSight IrradianceCache::sight(Pixel pixel) const {
  if (pixel.column >= m_width || pixel.row >= m_height) return {};
  const std::size_t place = std::size_t{pixel.row} * m_width + pixel.column;
  PixelSight sight{m_seen[place]};
  if (const auto found = m_gathered.find(place); found != m_gathered.end())
    sight.gathered = &found->second;
  if (!m_answered.empty()) {
    const Range& range = m_answered[place];
    sight.answers = {m_answers.data() + range.first, range.count};
  }
  return sight;
}

}  // namespace lentray::core
