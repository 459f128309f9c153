#include "core/trace/media_attenuation.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

/// A ray's own random numbers: the answer must not depend on what was asked before.
std::uint64_t key_of(const Ray& ray) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = mixed(key ^ std::bit_cast<std::uint64_t>(ray.origin[axis]));
    key = mixed(key ^ std::bit_cast<std::uint64_t>(ray.direction[axis]));
  }
  return key;
}

class Probe final : public MediaProbe {
 public:
  Probe(const MediaList& media, const Ray& ray) : m_media(media), m_ray(ray) {}
  MediaPoint at(double distance, bool) override {
    MediaPoint point;
    const Vec3 place = m_ray.at(distance);
    for (const Medium* medium : m_media) {
      point.extinction += medium->density(place) * medium->extinction();
    }
    return point;
  }
  double random() override {
    if (!m_random) m_random.emplace(key_of(m_ray), RandomSequence::Use::kShadowMedia);
    return m_random->next();
  }

 private:
  const MediaList& m_media;
  const Ray& m_ray;
  std::optional<RandomSequence> m_random;
};

}  // namespace

void find_media(const InteriorTable& table, InteriorsId inside, MediaList& list) {
  list.clear();
  if (!table.is_hollow(inside)) return;
  for (; inside != InteriorsId::kOpen; inside = table.around(inside)) {
    const Interior* interior = table.back(inside).interior;
    if (!interior) continue;
    for (auto medium = interior->media.rbegin(); medium != interior->media.rend(); ++medium) {
      list.push_back(medium->get());
    }
  }
  std::reverse(list.begin(), list.end());
}

const Medium& leading(const MediaList& list) {
  return **std::max_element(list.begin(), list.end(), [](const Medium* a, const Medium* b) {
    return a->sampling.intervals < b->sampling.intervals;
  });
}

double least_aa_threshold(const MediaList& list) {
  double least = list.front()->sampling.aa_threshold;
  for (const Medium* medium : list) least = std::min(least, medium->sampling.aa_threshold);
  return least;
}

Rgb MediaAttenuation::left(const MediaList& media, const Segment& way) {
  if (std::none_of(media.begin(), media.end(), [](const Medium* m) { return m->dims(); })) {
    return Rgb(1.0f);
  }
  Probe probe(media, way.ray);
  if (std::all_of(media.begin(), media.end(), [](const Medium* m) { return m->is_even(); })) {
    return transmittance(probe.at(0.0, false).extinction * static_cast<float>(way.length));
  }
  const Medium& first = leading(media);
  m_cutter.cut(first.sampling, first.densities.empty(), way.length, m_lit, m_intervals);
  const SamplingPlan plan{first.sampling, least_aa_threshold(media), {}};
  sample_media(plan, probe, m_intervals);
  return sum_of(m_intervals).left;
}

}  // namespace lentray::core
