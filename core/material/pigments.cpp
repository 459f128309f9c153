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

class ColourMapPigment final : public Pigment {
 public:
  ColourMapPigment(PlacedPattern pattern, BlendMap<Colour> map)
      : m_pattern(std::move(pattern)), m_map(std::move(map)),
        m_opaque(std::all_of(m_map.items().begin(), m_map.items().end(), opaque)) {}
  Colour colour(const Vec3& point, const SurfaceContext& surface) const override {
    const auto place =
        m_map.find(m_pattern.value(m_pattern.placement.inwards(point, surface), surface));
    if (place.before == place.after) return *place.after;
    return blend(*place.before, *place.after, place.fraction);
  }
  bool is_opaque() const override { return m_opaque; }

 private:
  PlacedPattern m_pattern;
  BlendMap<Colour> m_map;
  bool m_opaque;
};

class PigmentMapPigment final : public Pigment {
 public:
  PigmentMapPigment(PlacedPattern pattern, BlendMap<PigmentPtr> map)
      : m_pattern(std::move(pattern)), m_map(std::move(map)),
        m_opaque(std::all_of(m_map.items().begin(), m_map.items().end(),
                             [](const PigmentPtr& p) { return p->is_opaque(); })) {}
  Colour colour(const Vec3& point, const SurfaceContext& surface) const override {
    const Vec3 local = m_pattern.placement.inwards(point, surface);
    const auto place = m_map.find(m_pattern.value(local, surface));
    const Colour after = (*place.after)->colour(local, surface);
    if (place.before == place.after) return after;
    return blend((*place.before)->colour(local, surface), after, place.fraction);
  }
  bool is_opaque() const override { return m_opaque; }

 private:
  PlacedPattern m_pattern;
  BlendMap<PigmentPtr> m_map;
  bool m_opaque;
};

class AveragePigment final : public Pigment {
 public:
  AveragePigment(Placement placement, std::vector<std::pair<double, PigmentPtr>> entries)
      : m_placement(std::move(placement)), m_entries(std::move(entries)) {
    for (auto& [weight, pigment] : m_entries) {
      m_total += static_cast<float>(weight);
      m_opaque = m_opaque && pigment->is_opaque();
    }
  }
  Colour colour(const Vec3& point, const SurfaceContext& surface) const override {
    const Vec3 local = m_placement.inwards(point, surface);
    Colour sum;
    for (const auto& [weight, pigment] : m_entries) {
      const Colour one = pigment->colour(local, surface);
      const auto w = static_cast<float>(weight);
      sum.rgb += one.rgb * w;
      sum.filter += one.filter * w;
      sum.transmit += one.transmit * w;
    }
    return {{sum.rgb.r / m_total, sum.rgb.g / m_total, sum.rgb.b / m_total},
            sum.filter / m_total,
            sum.transmit / m_total};
  }
  bool is_opaque() const override { return m_opaque; }

 private:
  Placement m_placement;
  std::vector<std::pair<double, PigmentPtr>> m_entries;
  float m_total = 0.0f;
  bool m_opaque = true;
};

class PlacedPigment final : public Pigment {
 public:
  PlacedPigment(Placement placement, PigmentPtr pigment)
      : m_placement(std::move(placement)), m_pigment(std::move(pigment)) {}
  Colour colour(const Vec3& point, const SurfaceContext& surface) const override {
    return m_pigment->colour(m_placement.inwards(point, surface), surface);
  }
  bool is_opaque() const override { return m_pigment->is_opaque(); }

 private:
  Placement m_placement;
  PigmentPtr m_pigment;
};

class OpaquePigment final : public Pigment {
 public:
  explicit OpaquePigment(PigmentPtr pigment) : m_pigment(std::move(pigment)) {}
  Colour colour(const Vec3& point, const SurfaceContext& surface) const override {
    return {m_pigment->colour(point, surface).rgb, 0.0f, 0.0f};
  }
  bool is_opaque() const override { return true; }

 private:
  PigmentPtr m_pigment;
};

class PigmentPattern final : public Pattern {
 public:
  explicit PigmentPattern(PigmentPtr pigment) : m_pigment(std::move(pigment)) {}
  double value(const Vec3& point) const override { return grey(m_pigment->colour(point).rgb); }
  double value_on(const Vec3& point, const SurfaceContext& surface) const override {
    return grey(m_pigment->colour(point, surface).rgb);
  }

 private:
  PigmentPtr m_pigment;
};

}  // namespace

PigmentPtr make_plain_pigment(const Colour& colour) {
  return std::make_shared<PlainPigment>(colour);
}
PigmentPtr make_colour_map_pigment(PlacedPattern pattern, BlendMap<Colour> map) {
  return std::make_shared<ColourMapPigment>(std::move(pattern), std::move(map));
}
PigmentPtr make_pigment_map_pigment(PlacedPattern pattern, BlendMap<PigmentPtr> map) {
  return std::make_shared<PigmentMapPigment>(std::move(pattern), std::move(map));
}
PigmentPtr make_average_pigment(Placement placement,
                                std::vector<std::pair<double, PigmentPtr>> entries) {
  return std::make_shared<AveragePigment>(std::move(placement), std::move(entries));
}
PigmentPtr make_placed_pigment(Placement placement, PigmentPtr pigment) {
  return std::make_shared<PlacedPigment>(std::move(placement), std::move(pigment));
}
PigmentPtr make_opaque_pigment(PigmentPtr pigment) {
  if (pigment->is_opaque()) return pigment;
  return std::make_shared<OpaquePigment>(std::move(pigment));
}
PatternPtr make_pigment_pattern(PigmentPtr pigment) {
  return std::make_unique<PigmentPattern>(std::move(pigment));
}

}  // namespace lentray::core
