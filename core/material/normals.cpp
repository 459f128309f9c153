#include "core/material/normals.h"

namespace lentray::core {
namespace {

/// Takes a normal into a pattern's space and back. Unless the scale is kept, its length is made 1
/// at each crossing, so that bumps look as deep in a scaled pattern.
class Frame {
 public:
  Frame(Placement placement, bool keep_scale)
      : m_placement(std::move(placement)), m_keep_scale(keep_scale) {}
  Vec3 inwards(const Vec3& point, const SurfaceContext& surface) const {
    return m_placement.inwards(point, surface);
  }
  Vec3 enter(const Vec3& normal) const {
    if (m_keep_scale) return m_placement.normal_inwards(normal);
    return normalized(m_placement.normal_inwards(normalized(normal)));
  }
  Vec3 leave(const Vec3& normal) const {
    if (m_keep_scale) return m_placement.normal_outwards(normal);
    return normalized(m_placement.normal_outwards(normalized(normal)));
  }

 private:
  Placement m_placement;
  bool m_keep_scale;
};

/// The perturbation that makes formula(point, normal, surface) of a normal.
template <class Formula>
NormalPtr normal_of(Formula formula) {
  class Made final : public NormalPerturbation {
   public:
    explicit Made(Formula f) : m_formula(std::move(f)) {}
    Vec3 perturb(const Vec3& point, const Vec3& normal,
                 const SurfaceContext& surface) const override {
      return m_formula(point, normal, surface);
    }

   private:
    Formula m_formula;
  };
  return std::make_shared<Made>(std::move(formula));
}

/// Cubic through both points of a slope map, with their slopes.
double hermite(double t, const SlopePoint& a, const SlopePoint& b) {
  const double rise = a.height - b.height;
  return t * t * t * (a.slope + b.slope + 2.0 * rise) -
         t * t * (2.0 * a.slope + b.slope + 3.0 * rise) + t * a.slope + a.height;
}

class SlopeNormal final : public NormalPerturbation {
 public:
  SlopeNormal(PlacedPattern pattern, double amount, double accuracy,
              std::optional<BlendMap<SlopePoint>> slopes, bool keep_scale)
      : m_frame(pattern.placement, keep_scale), m_pattern(std::move(pattern)),
        m_slopes(std::move(slopes)), m_factor(amount * -5.0 * (0.02 / accuracy)),
        m_accuracy(accuracy) {}

  Vec3 perturb(const Vec3& point, const Vec3& normal,
               const SurfaceContext& surface) const override {
    // Samples at the corners of a tetrahedron: its vectors, weighted by the heights there.
    static constexpr Vec3 kCorners[] = {{0.942809041, -0.333333333, 0.0},
                                        {-0.471404521, -0.333333333, 0.816496581},
                                        {-0.471404521, -0.333333333, -0.816496581},
                                        {0.0, 1.0, 0.0}};
    const Vec3 local = m_frame.inwards(point, surface);
    Vec3 inner = m_frame.enter(normal);
    for (const Vec3& corner : kCorners) {
      inner += corner * (height(local + corner * m_accuracy, surface) * m_factor);
    }
    return m_frame.leave(inner);
  }

 private:
  double height(const Vec3& local, const SurfaceContext& surface) const {
    const double value = m_pattern.value(local, surface);
    if (!m_slopes) return value;
    const auto place = m_slopes->find(value);
    if (place.before == place.after) return place.after->height;
    return hermite(place.fraction, *place.before, *place.after);
  }

  Frame m_frame;
  PlacedPattern m_pattern;
  std::optional<BlendMap<SlopePoint>> m_slopes;
  double m_factor, m_accuracy;
};

Vec3 perturbed(const NormalPtr& perturbation, const Vec3& point, const Vec3& normal,
               const SurfaceContext& surface) {
  return perturbation ? perturbation->perturb(point, normal, surface) : normal;
}

}  // namespace

NormalPtr make_displaced_normal(Placement placement, DisplacementPtr displacement,
                                bool keep_scale) {
  return normal_of([frame = Frame(std::move(placement), keep_scale),
                    displacement = std::move(displacement)](const Vec3& point, const Vec3& normal,
                                                            const SurfaceContext& surface) {
    return frame.leave(displacement->displaced(frame.inwards(point, surface), frame.enter(normal)));
  });
}
NormalPtr make_slope_normal(PlacedPattern pattern, double amount, double accuracy,
                            std::optional<BlendMap<SlopePoint>> slopes, bool keep_scale) {
  return std::make_shared<SlopeNormal>(std::move(pattern), amount, accuracy, std::move(slopes),
                                       keep_scale);
}
NormalPtr make_normal_map(PlacedPattern pattern, BlendMap<NormalPtr> map, bool keep_scale) {
  Frame frame(pattern.placement, keep_scale);
  return normal_of([frame = std::move(frame), pattern = std::move(pattern), map = std::move(map)](
                       const Vec3& point, const Vec3& normal, const SurfaceContext& surface) {
    const Vec3 local = frame.inwards(point, surface);
    const auto place = map.find(pattern.value(local, surface));
    const Vec3 entered = frame.enter(normal);
    Vec3 inner = perturbed(*place.after, local, entered, surface);
    if (place.before != place.after) {
      inner = perturbed(*place.before, local, entered, surface) * (1.0 - place.fraction) +
              inner * place.fraction;
    }
    return normalized(frame.leave(inner));
  });
}
NormalPtr make_average_normal(Placement placement, BlendMap<NormalPtr> map, bool keep_scale) {
  double total = 0.0;
  for (const double weight : map.values()) total += weight;
  return normal_of([frame = Frame(std::move(placement), keep_scale), map = std::move(map), total](
                       const Vec3& point, const Vec3& normal, const SurfaceContext& surface) {
    const Vec3 local = frame.inwards(point, surface);
    const Vec3 entered = frame.enter(normal);
    Vec3 sum;
    for (std::size_t i = 0; i < map.items().size(); ++i)
      sum += perturbed(map.items()[i], local, entered, surface) * map.values()[i];
    return frame.leave(sum / total);
  });
}
NormalPtr make_placed_normal(Placement placement, NormalPtr normal, bool keep_scale) {
  return normal_of([frame = Frame(std::move(placement), keep_scale), inner = std::move(normal)](
                       const Vec3& point, const Vec3& outer, const SurfaceContext& surface) {
    return frame.leave(inner->perturb(frame.inwards(point, surface), frame.enter(outer), surface));
  });
}

}  // namespace lentray::core
