#include "core/material/pigments.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

bool opaque(const Colour& c) {
  constexpr float kEpsilon = 1e-10f;
  return std::fabs(c.filter) <= kEpsilon && std::fabs(c.transmit) <= kEpsilon;
}

Colour blend(const Colour& a, const Colour& b, double fraction) {
  const auto mix = [f = static_cast<float>(fraction)](float x, float y) { return x + f * (y - x); };
  return {{mix(a.rgb.r, b.rgb.r), mix(a.rgb.g, b.rgb.g), mix(a.rgb.b, b.rgb.b)},
          mix(a.filter, b.filter),
          mix(a.transmit, b.transmit)};
}

class PlainPigment final : public Pigment {
 public:
  explicit PlainPigment(const Colour& colour) : m_colour(colour) {}
  Colour colour(const Vec3&, const SurfaceContext&) const override { return m_colour; }
  bool is_opaque() const override { return opaque(m_colour); }
  const Colour* constant() const override { return &m_colour; }

 private:
  Colour m_colour;
};

}  // namespace

PigmentPtr make_plain_pigment(const Colour& colour) {
  return std::make_shared<PlainPigment>(colour);
}
PigmentPtr make_colour_map_pigment(PlacedPattern pattern, BlendMap<Colour> map) {
  const bool is_opaque = std::ranges::all_of(map.items(), opaque);
  return pigment_of(is_opaque, [pattern = std::move(pattern), map = std::move(map)](
                                   const Vec3& point, const SurfaceContext& surface) {
    const auto place = map.find(pattern.value(pattern.placement.inwards(point, surface), surface));
    if (place.before == place.after) return *place.after;
    return blend(*place.before, *place.after, place.fraction);
  });
}
PigmentPtr make_pigment_map_pigment(PlacedPattern pattern, BlendMap<PigmentPtr> map) {
  const bool is_opaque =
      std::ranges::all_of(map.items(), [](const PigmentPtr& p) { return p->is_opaque(); });
  return pigment_of(is_opaque, [pattern = std::move(pattern), map = std::move(map)](
                                   const Vec3& point, const SurfaceContext& surface) {
    const Vec3 local = pattern.placement.inwards(point, surface);
    const auto place = map.find(pattern.value(local, surface));
    const Colour after = (*place.after)->colour(local, surface);
    if (place.before == place.after) return after;
    return blend((*place.before)->colour(local, surface), after, place.fraction);
  });
}
PigmentPtr make_average_pigment(Placement placement, BlendMap<PigmentPtr> map) {
  float total = 0.0f;
  for (const double weight : map.values()) total += static_cast<float>(weight);
  const bool is_opaque =
      std::ranges::all_of(map.items(), [](const PigmentPtr& p) { return p->is_opaque(); });
  return pigment_of(is_opaque, [placement = std::move(placement), map = std::move(map), total](
                                   const Vec3& point, const SurfaceContext& surface) {
    const Vec3 local = placement.inwards(point, surface);
    Colour sum;
    for (std::size_t i = 0; i < map.items().size(); ++i) {
      const Colour one = map.items()[i]->colour(local, surface);
      const auto w = static_cast<float>(map.values()[i]);
      sum.rgb += one.rgb * w;
      sum.filter += one.filter * w;
      sum.transmit += one.transmit * w;
    }
    return Colour{{sum.rgb.r / total, sum.rgb.g / total, sum.rgb.b / total},
                  sum.filter / total,
                  sum.transmit / total};
  });
}
PigmentPtr make_placed_pigment(Placement placement, PigmentPtr pigment) {
  return pigment_of(pigment->is_opaque(), [placement = std::move(placement), pigment](
                                              const Vec3& point, const SurfaceContext& surface) {
    return pigment->colour(placement.inwards(point, surface), surface);
  });
}
PigmentPtr make_opaque_pigment(PigmentPtr pigment) {
  if (pigment->is_opaque()) return pigment;
  return pigment_of(
      true, [pigment = std::move(pigment)](const Vec3& point, const SurfaceContext& surface) {
        return Colour{pigment->colour(point, surface).rgb, 0.0f, 0.0f};
      });
}
PatternPtr make_pigment_pattern(PigmentPtr pigment) {
  return pattern_of(
      [pigment = std::move(pigment)](const Vec3& point, const SurfaceContext& surface) -> double {
        return grey(pigment->colour(point, surface).rgb);
      });
}

}  // namespace lentray::core
