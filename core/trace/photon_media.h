// What media in interiors make of a photon on its way, and the photons that it leaves in them. World space;
// power linear. One a thread.
// Source: reference manual 3.7, "Photons and Media"; steps and weights are those that replay stock's files
// of photons.
#pragma once

#include <cstdint>
#include <vector>

#include "core/photon/photon.h"
#include "core/photon/rings.h"
#include "core/trace/media_attenuation.h"
#include "core/trace/photon_shot.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

/// The random numbers that place photons along a path through media. Every place takes one. They come from one
/// cycle for all photons and units. A medium that only attenuates takes one for each of its samples.
struct MediaDraws {
  const PhotonCycle& cycle;
  std::uint64_t next = 0;
  /// Only counts the numbers that a path takes, which depends on its geometry alone: no photon is stored, and
  /// none is attenuated.
  bool only_counted = false;
};

class PhotonMedia {
 public:
  explicit PhotonMedia(ThreadContext& context) : m_context(context) {}

  /// A piece of a photon's way.
  struct Piece {
    Ray ray;
    double length;
    double way;  ///< from the light to its start
    InteriorsId inside;
  };
  /// Dims what passes it.
  void pass(const Piece& piece, MediaDraws& draws, Rgb& power);
  /// The same, and leaves photons.
  void pass(const Piece& piece, const PhotonShot& shot, MediaDraws& draws, Rgb& power,
            std::vector<Photon>& out);

 private:
  void find_lit_parts(const Piece& piece);
  void find_intervals(const Piece& piece);
  /// Of an interval.
  struct Steps {
    int count;
    double factor;  ///< of the distance of photons: of their weight
  };
  Steps steps_in(const MediaInterval& interval, const Piece& piece, const PhotonShot& shot) const;

  ThreadContext& m_context;
  MediaAttenuation m_attenuation;
  MediaList m_media;
  std::vector<RayPart> m_lit;
  IntervalCutter m_cutter;
  std::vector<MediaInterval> m_intervals;
};

}  // namespace lentray::core
