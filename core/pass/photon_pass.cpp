#include "core/pass/photon_pass.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/light/area_light.h"
#include "core/light/light_ray.h"
#include "core/photon/photon_map.h"
#include "core/photon/rings.h"
#include "core/photon/units.h"
#include "core/scene/scene.h"
#include "core/trace/photon_path.h"

namespace lentray::core {
namespace {

constexpr double kDark = 1e-5;  ///< a share of a light's power that is not worth a photon

/// What a part of a ring gives: photons, then how many were shot and whether any hit the target. Plain, as
/// records of a pass are.
struct Told {
  enum Kind : std::uint32_t { kSurface, kMedia, kShot, kMet };
  Photon photon{};
  Kind kind = kSurface;
  std::uint32_t number = 0;  ///< of those shot
};

/// How far a light's projector keeps photons: they begin behind it. Empty: they miss it.
std::optional<double> behind_projector(const Light& light, const Ray& ray, HitLists& lists) {
  if (!light.projector) return 0.0;
  std::vector<Hit> hits;
  light.projector->all(ray, kTiny, Bounds::kInf, hits, {lists, RayKind::kShadow});
  if (hits.empty()) return std::nullopt;
  double farthest = 0.0;
  for (const Hit& hit : hits) farthest = std::max(farthest, hit.t);
  return farthest + kTiny;
}

/// Where on its area a light sends the photons of a point from.
Vec3 start_of(const Light& light, int u, int v) {
  if (photons_at_once(light) == 1) return light.position;
  const auto part = [](const Vec3& axis, int at, int size) {
    return size > 1 ? axis * (at / static_cast<double>(size - 1) - 0.5) : Vec3();
  };
  return light.position + part(light.area.axis1, u, light.area.size1) +
         part(light.area.axis2, v, light.area.size2);
}

}  // namespace

class PhotonPass::Shooting {
 public:
  Shooting(const Scene& scene, std::uint64_t most, PhotonReport& report, PhotonMaps& photons,
           PassRun& run)
      : m_scene(scene), m_settings(*scene.settings().photons), m_most(most), m_report(report),
        m_photons(photons), m_run(run), m_threads(run.threads()),
        m_units(photon_units(scene.lights(), scene.photon_targets(),
                             photon_spacing(scene.lights(), scene.photon_targets(), m_settings))),
        m_expected(expected_photons(scene.lights(), m_units)) {}

  void run() {
    m_report.units = m_units.size();
    for (const PhotonUnit& unit : m_units) {
      if (!m_report.is_full) shoot(unit);
    }
  }

 private:
  struct Thread {
    explicit Thread(const Scene& scene) : context(scene, false), path(context) {}
    ThreadContext context;
    PhotonPath path;
    PhotonMaps caught;
  };
  Thread& thread(unsigned number) {
    std::unique_ptr<Thread>& thread = m_threads[number];
    if (!thread) thread = std::make_unique<Thread>(m_scene);
    return *thread;
  }
  const Light& light_of(const PhotonUnit& unit) const { return m_scene.lights()[unit.light]; }

  void shoot(const PhotonUnit& unit) {
    std::vector<RingPart> parts;
    RingCutter cutter(unit, light_of(unit).parallel, m_cycle, m_draw);
    while (auto part = cutter.next()) parts.push_back(*part);
    const std::vector<std::uint64_t> media_draws = media_draws_of(unit, parts);
    bool met = false, met_in_ring = false;
    const auto commit = [&](std::size_t number, const std::vector<Told>& told) {
      const RingPart& part = parts[number];
      m_draw = part.next_draw();
      m_media_draw = media_draws[number + 1];
      if (!take(told, met_in_ring)) return false;
      if (!part.ends_ring) return true;
      met = met || met_in_ring;
      const bool stops = met && !met_in_ring && part.out > m_settings.autostop * unit.end;
      met_in_ring = false;
      return !stops;
    };
    m_run.in_order_kept<Told>(
        parts.size(),
        [&](unsigned number, std::size_t part) {
          MediaDraws draws{m_cycle, media_draws[part]};
          return told_of(unit, parts[part], draws, thread(number));
        },
        commit);
  }

  /// The first random number in media of each part, and of what comes behind them. They depend on
  /// all photons before, so these are followed once more where media keep some.
  std::vector<std::uint64_t> media_draws_of(const PhotonUnit& unit,
                                            const std::vector<RingPart>& parts) {
    std::vector<std::uint64_t> first(parts.size() + 1, m_media_draw);
    if (m_settings.media_steps <= 0 || !m_scene.needs().media) return first;
    m_run.each(parts.size(), [&](unsigned number, std::size_t part) {
      MediaDraws draws{m_cycle, 0, true};
      shoot(unit, parts[part], draws, thread(number));
      first[part + 1] = draws.next;
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
  }

  /// False: there are enough.
  bool take(const std::vector<Told>& told, bool& met) {
    for (const Told& one : told) {
      switch (one.kind) {
        case Told::kSurface: m_photons.surface.push_back(one.photon); break;
        case Told::kMedia: m_photons.media.push_back(one.photon); break;
        case Told::kShot: m_report.shot += one.number; break;
        case Told::kMet: met = true; break;
      }
    }
    m_report.surface = m_photons.surface.size();
    m_report.media = m_photons.media.size();
    m_run.advance(std::min(1.0, static_cast<double>(m_report.shot) / m_expected));
    m_report.is_full = m_report.surface + m_report.media >= m_most;
    return !m_report.is_full;
  }

  std::vector<Told> told_of(const PhotonUnit& unit, const RingPart& part, MediaDraws& draws,
                            Thread& by) {
    const bool met = shoot(unit, part, draws, by);
    std::vector<Told> told;
    told.reserve(by.caught.surface.size() + by.caught.media.size() + 2);
    for (const Photon& photon : by.caught.surface) told.push_back({photon, Told::kSurface});
    for (const Photon& photon : by.caught.media) told.push_back({photon, Told::kMedia});
    const auto at_once = static_cast<unsigned>(photons_at_once(light_of(unit)));
    told.push_back({{}, Told::kShot, part.size * at_once});
    if (met) told.push_back({{}, Told::kMet});
    return told;
  }

  /// Fills what the thread has caught. True if any hit the target.
  bool shoot(const PhotonUnit& unit, const RingPart& part, MediaDraws& draws, Thread& by) {
    by.caught.surface.clear();
    by.caught.media.clear();
    bool met = false;
    std::uint64_t draw = part.draw;
    double turn = part.turn;
    for (std::uint32_t i = 0; i < part.size; ++i, turn += part.turn_step, draw += 2) {
      const RingPlace place = jittered(part, turn, unit.step, m_settings.jitter, m_cycle, draw);
      met = shoot_from_area(unit, place, draws, by) || met;
    }
    return met;
  }

  /// One photon, or one from each point of an area light.
  bool shoot_from_area(const PhotonUnit& unit, const RingPlace& place, MediaDraws& draws,
                       Thread& by) {
    const Light& light = light_of(unit);
    const bool is_area = photons_at_once(light) > 1;
    const int size1 = is_area ? light.area.size1 : 1, size2 = is_area ? light.area.size2 : 1;
    bool met = false;
    for (int u = 0; u < size1; ++u) {
      for (int v = 0; v < size2; ++v) {
        met = shoot_one(unit, light, start_of(light, u, v), place, draws, by) || met;
      }
    }
    return met;
  }

  bool shoot_one(const PhotonUnit& unit, const Light& light, const Vec3& from,
                 const RingPlace& place, MediaDraws& draws, Thread& by) {
    const PhotonTarget& target = m_scene.photon_targets()[unit.target];
    Ray ray = photon_ray(light, from, target.centre, place.out, place.turn);
    const double share =
        beam_factor(light, ray.at(1.0), {-ray.direction, 1.0}) / photons_at_once(light);
    if (share < kDark) return false;
    const auto before = behind_projector(light, ray, by.context.lists);
    if (!before) return false;
    ray.origin = ray.at(*before);
    return by.path.shoot(
        {ray, times(light.colour, share), *before, light, unit.target + 1, unit.spread}, draws,
        by.caught);
  }

  const Scene& m_scene;
  const PhotonSettings& m_settings;
  const std::uint64_t m_most;
  PhotonReport& m_report;
  PhotonMaps& m_photons;
  PassRun& m_run;
  std::vector<std::unique_ptr<Thread>> m_threads;
  const PhotonCycle m_cycle;
  std::uint64_t m_draw = 0, m_media_draw = 0;  ///< the cycle's next numbers
  const std::vector<PhotonUnit> m_units;
  const double m_expected;
};

double PhotonPass::work() const {
  const PhotonSettings& settings = *m_scene.settings().photons;
  const auto& lights = m_scene.lights();
  const auto& targets = m_scene.photon_targets();
  return expected_photons(lights,
                          photon_units(lights, targets, photon_spacing(lights, targets, settings)));
}

void PhotonPass::run(PassRun& run) {
  PhotonMaps photons;
  Shooting(m_scene, m_most, m_report, photons, run).run();
  m_result.photons = make_photon_light(std::move(photons), *m_scene.settings().photons);
  run.count("shot", static_cast<double>(m_report.shot));
  run.count("surface", static_cast<double>(m_report.surface));
  run.count("media", static_cast<double>(m_report.media));
}

}  // namespace lentray::core
