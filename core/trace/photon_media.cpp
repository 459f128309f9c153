#include "core/trace/photon_media.h"

#include <algorithm>

namespace lentray::core {

void PhotonMedia::pass(const Piece& piece, MediaDraws& draws, Rgb& power) {
  find_media(m_context.interiors, piece.inside, m_media);
  if (m_media.empty()) return;
  find_intervals(piece);
  const MediumSampling& sampling = leading(m_media).sampling;
  const int places = sampling.method == SamplingMethod::kAdaptive
                         ? 2 * (sampling.min_samples / 2 + 1) + 1
                         : sampling.min_samples;
  draws.next += m_intervals.size() * static_cast<std::size_t>(places);
  if (!draws.only_counted) power *= m_attenuation.left(m_media, {piece.ray, piece.length});
}

void PhotonMedia::find_intervals(const Piece& piece) {
  find_lit_parts(piece);
  const Medium& first = leading(m_media);
  m_cutter.cut(first.sampling, first.densities.empty(), piece.length, m_lit, m_intervals);
}

void PhotonMedia::find_lit_parts(const Piece& piece) {
  m_lit.clear();
  for (const std::uint32_t i : m_context.scene.global_lights()) {
    const Light& light = m_context.scene.lights()[i];
    if (!light.lights_media) continue;
    if (const auto part = lit_part(light, piece.ray, piece.length)) m_lit.push_back(*part);
  }
}

PhotonMedia::Steps PhotonMedia::steps_in(const MediaInterval& interval, const Piece& piece,
                                         const PhotonShot& shot) const {
  const PhotonSettings& settings = *m_context.scene.settings().photons;
  const double apart = shot.spread * (shot.light.parallel ? 1.0 : piece.way);
  const double steps = interval.length / (apart * settings.media_factor);
  if (steps < settings.media_steps + 1.0) return {static_cast<int>(steps), settings.media_factor};
  return {settings.media_steps, interval.length / (apart * settings.media_steps)};
}

void PhotonMedia::pass(const Piece& piece, const PhotonShot& shot, MediaDraws& draws, Rgb& power,
                       std::vector<Photon>& out) {
  const auto any = [this](auto&& has) { return std::any_of(m_media.begin(), m_media.end(), has); };
  find_media(m_context.interiors, piece.inside, m_media);
  if (!any([](const Medium* m) { return m->dims(); })) return;
  const bool leaves = any([](const Medium* m) { return m->scatters(); }) &&
                      any([](const Medium* m) { return m->collects_photons; });
  find_intervals(piece);
  const double jitter = m_context.scene.settings().photons->jitter;
  Rgb depth;
  for (const MediaInterval& interval : m_intervals) {
    const Steps steps = steps_in(interval, piece, shot);
    if (draws.only_counted) {
      draws.next += static_cast<std::uint64_t>(steps.count);
      continue;
    }
    // An interval too short for a step dims light by what is in its middle; divided by
    // its steps, the photon's power would not be a number.
    const int places = std::max(steps.count, 1);
    Rgb sum;
    for (int i = 0; i < places; ++i) {
      double place = 0.5;
      if (steps.count > 0) {
        place = (i + 0.5 + draws.cycle.at(draws.next++) * jitter - 0.5 * jitter) / places;
      }
      const double along = interval.from + place * interval.length;
      const Vec3 at = piece.ray.at(along);
      for (const Medium* medium : m_media) {
        sum += times(medium->density(at) * medium->extinction(), interval.length);
      }
      if (!leaves || steps.count == 0) continue;
      const double way = piece.way + along;
      const double share = steps.factor * shot.spread * (shot.light.parallel ? 1.0 : way);
      out.push_back(make_photon(at, piece.ray.origin, weighed(times(power, share), way, shot)));
    }
    depth += times(sum, 1.0 / places);
  }
  power *= transmittance(depth);
}

}  // namespace lentray::core
