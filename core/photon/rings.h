// The rings of a unit's photons, and the random numbers by which they are strewn. A ring takes a number for
// itself and two a photon, from a cycle that goes on from ring to ring and from unit to unit, so where each
// ring begins in it is known before anything is shot. Angles in radians.
// Source: reference manual 3.7, "Photons"; replays stock's files of photons
// (tests/image/photon_file_test.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/photon/units.h"

namespace lentray::core {

/// Random numbers in [0, 1), again and again the same.
class PhotonCycle {
 public:
  PhotonCycle();
  double at(std::uint64_t draw) const { return m_numbers[(draw + 1) % m_numbers.size()]; }

 private:
  std::vector<double> m_numbers;
};

/// Photons beside each other on a ring.
struct RingPart {
  double out;          ///< of the ring, as PhotonUnit::step
  double turn;         ///< of the first photon
  double turn_step;    ///< from photon to photon
  std::uint32_t size;  ///< photons
  bool ends_ring;
  std::uint64_t draw;  ///< the first photon's first random number
  std::uint64_t next_draw() const { return draw + 2 * std::uint64_t{size}; }
};

/// Cuts a unit into parts of at most kMost photons, from the middle outwards.
class RingCutter {
 public:
  static constexpr std::uint32_t kMost = 256;

  /// `draw`: the unit's first random number. The cycle outlives it.
  RingCutter(const PhotonUnit& unit, bool parallel, const PhotonCycle& cycle, std::uint64_t draw)
      : m_unit(unit), m_parallel(parallel), m_cycle(cycle), m_draw(draw) {}
  /// Empty: that was all.
  std::optional<RingPart> next();

 private:
  void begin_ring();

  const PhotonUnit m_unit;
  const bool m_parallel;
  const PhotonCycle& m_cycle;
  std::uint64_t m_draw;
  double m_out = 0.0, m_turn = 0.0, m_turn_step = 0.0, m_last_turn = 0.0;
  bool m_in_ring = false;
};

/// A photon's place on its ring, moved at random by the share `jitter` of a step each way.
struct RingPlace {
  double out, turn;
};
RingPlace jittered(const RingPart& part, double turn, double out_step, double jitter,
                   const PhotonCycle& cycle, std::uint64_t draw);

}  // namespace lentray::core
