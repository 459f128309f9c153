#include "core/photon/rings.h"

#include <cmath>
#include <numbers>
#include <random>

#include "core/base/tiny.h"

namespace lentray::core {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kCycle = 32768;

}  // namespace

PhotonCycle::PhotonCycle() {
  std::mt19937 random;  // its standard seed
  m_numbers.reserve(kCycle);
  for (std::size_t i = 0; i < kCycle; ++i) {
    m_numbers.push_back(static_cast<double>(random()) * 0x1.0p-32);
  }
}

void RingCutter::begin_ring() {
  const double radius = m_parallel ? m_out : std::sin(m_out);
  m_turn_step = m_out < kTiny ? 2.0 * kPi : m_unit.step / radius;
  m_turn = -kPi + m_turn_step * m_cycle.at(m_draw++) * 0.5;
  m_last_turn = kPi - m_turn_step / 2.0 + (m_turn + kPi);
  m_in_ring = true;
}

std::optional<RingPart> RingCutter::next() {
  if (!m_in_ring) {
    if (!(m_out < m_unit.end)) return std::nullopt;
    begin_ring();
  }
  RingPart part{m_out, m_turn, m_turn_step, 0, false, m_draw};
  // Summed up as the photons' turns are: how many there are may depend on the roundings.
  while (m_turn < m_last_turn && part.size < kMost) {
    m_turn += m_turn_step;
    ++part.size;
  }
  m_draw = part.next_draw();
  if (!(m_turn < m_last_turn)) {
    part.ends_ring = true;
    m_in_ring = false;
    m_out += m_unit.step;
  }
  return part;
}

RingPlace jittered(const RingPart& part, double turn, double out_step, double jitter,
                   const PhotonCycle& cycle, std::uint64_t draw) {
  return {part.out + out_step * (cycle.at(draw + 1) - 0.5) * jitter,
          turn + part.turn_step * (cycle.at(draw) - 0.5) * jitter};
}

}  // namespace lentray::core
