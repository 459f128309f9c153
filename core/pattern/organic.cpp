#include "core/pattern/organic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/thread_table.h"
#include "core/base/tiny.h"

namespace lentray::core {
namespace {

constexpr double kPi = std::numbers::pi;

/// The cells around one whose random points can be among the three nearest: up to two away along
/// one axis, up to one along the others. Near ones first.
constexpr auto kNeighbours = [] {
  std::array<std::array<int, 3>, 81> cells{};
  std::size_t count = 0;
  for (int square = 0; square <= 6; ++square) {
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          const int far = (x * x == 4) + (y * y == 4) + (z * z == 4);
          if (far <= 1 && x * x + y * y + z * z == square) cells[count++] = {x, y, z};
        }
      }
    }
  }
  return cells;
}();

/// The three least distances from a point, as powers of the metric, and the nearest point.
struct NearestThree {
  std::array<double, 3> d{1e300, 1e300, 1e300};
  std::size_t first = 0;

  void take(double distance, std::size_t neighbour) {
    if (distance < d[0]) {
      d = {distance, d[0], d[1]};
      first = neighbour;
    } else if (distance < d[1]) {
      d = {d[0], distance, d[1]};
    } else {
      d[2] = distance;
    }
  }
};

/// The random points of a cell's neighbours, in their order. The first question about a cell makes those
/// that it needs, the next one all: a ray's samples in a medium, and neighbouring pixels, ask for the
/// same cells again.
class CellPoints {
 public:
  /// Of the thread.
  static CellPoints& of(int x, int y, int z) {
    constexpr unsigned kCells = 16;
    auto& cells = table_of_thread<std::array<CellPoints, kCells>>();
    const auto spread =
        static_cast<unsigned>(x) + 5u * static_cast<unsigned>(y) + 11u * static_cast<unsigned>(z);
    CellPoints& points = cells[spread % kCells];
    if (points.m_state != State::kUnused && points.m_x == x && points.m_y == y && points.m_z == z) {
      if (points.m_state == State::kNew) points.fill();
    } else {
      points.m_state = State::kNew;
      points.m_x = x;
      points.m_y = y;
      points.m_z = z;
    }
    return points;
  }

  bool is_full() const { return m_state == State::kFull; }
  Vec3 at(std::size_t neighbour) const {
    const auto& step = kNeighbours[neighbour];
    const int x = m_x + step[0], y = m_y + step[1], z = m_z + step[2];
    const std::size_t seed = lattice_hash(x, y, z);
    return {x + lattice_random(seed), y + lattice_random(seed + 1), z + lattice_random(seed + 2)};
  }
  /// Of all points, by squares. Only if is_full().
  NearestThree nearest(const Vec3& p) const {
    std::array<double, kNeighbours.size()> squares;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const double x = m_xs[i] - p.x, y = m_ys[i] - p.y, z = m_zs[i] - p.z;
      squares[i] = x * x + y * y + z * z;
    }
    NearestThree nearest;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      if (squares[i] < nearest.d[2]) nearest.take(squares[i], i);
    }
    return nearest;
  }

 private:
  enum class State { kUnused, kNew, kFull };
  void fill() {
    for (std::size_t i = 0; i < kNeighbours.size(); ++i) {
      const Vec3 point = at(i);
      m_xs[i] = point.x;
      m_ys[i] = point.y;
      m_zs[i] = point.z;
    }
    m_state = State::kFull;
  }

  int m_x = 0, m_y = 0, m_z = 0;
  State m_state = State::kUnused;
  std::array<double, kNeighbours.size()> m_xs, m_ys, m_zs;
};

class CracklePattern final : public Pattern {
 public:
  CracklePattern(const Crackle& crackle, int generator)
      : m_crackle(crackle), m_generator(generator) {}

  double value(const Vec3& p) const override {
    const CellPoints& points = CellPoints::of(cell(p.x), cell(p.y), cell(p.z));
    const NearestThree nearest =
        m_crackle.metric == 2.0 && points.is_full() ? points.nearest(p) : search(points, p);
    if (m_crackle.solid) return std::clamp(noise(points.at(nearest.first), m_generator), 0.0, 1.0);
    const double offset = m_crackle.metric == 1.0 ? m_crackle.offset : powered(m_crackle.offset);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += m_crackle.form[static_cast<int>(i)] * rooted(nearest.d[i] + offset);
    }
    return std::clamp(sum, 0.0, 1.0);
  }

 private:
  /// The metric's power of the least distance along one axis to the cells -2 .. 2 away.
  class Reach {
   public:
    Reach(const CracklePattern& pattern, double place) {
      for (int step = -2; step <= 2; ++step) {
        const double distance = step > 0 ? step - place : step < 0 ? place - step - 1.0 : 0.0;
        m_powers[static_cast<std::size_t>(step + 2)] = pattern.powered(std::max(distance, 0.0));
      }
    }
    double operator[](int step) const { return m_powers[static_cast<std::size_t>(step + 2)]; }

   private:
    std::array<double, 5> m_powers;
  };

  /// Leaves out cells none of whose points can be near enough.
  NearestThree search(const CellPoints& points, const Vec3& p) const {
    constexpr double kSlack = 1.0 + 1e-12;  // of rounding: points.nearest() must give the same
    const Reach reach_x(*this, p.x - cell(p.x)), reach_y(*this, p.y - cell(p.y)),
        reach_z(*this, p.z - cell(p.z));
    NearestThree nearest;
    for (std::size_t i = 0; i < kNeighbours.size(); ++i) {
      const auto& step = kNeighbours[i];
      const double reach = reach_x[step[0]] + reach_y[step[1]] + reach_z[step[2]];
      if (reach >= nearest.d[2] * kSlack) continue;
      const Vec3 away = points.at(i) - p;
      const double d = powered(away.x) + powered(away.y) + powered(away.z);
      if (d < nearest.d[2]) nearest.take(d, i);
    }
    return nearest;
  }

  static int cell(double v) { return static_cast<int>(whole_below(v - kTiny)); }
  /// Distances are compared as their metric's power: no roots until the end.
  double powered(double d) const {
    if (m_crackle.metric == 2.0) return d * d;
    return m_crackle.metric == 1.0 ? std::fabs(d) : std::pow(std::fabs(d), m_crackle.metric);
  }
  double rooted(double sum) const {
    if (m_crackle.metric == 2.0) return std::sqrt(sum);
    return m_crackle.metric == 1.0 ? sum : std::pow(sum, 1.0 / m_crackle.metric);
  }
  Crackle m_crackle;
  int m_generator;
};

}  // namespace

PatternPtr make_bozo(int generator) {
  return pattern_of([generator](const Vec3& p) { return noise(p, generator); });
}
PatternPtr make_dents(int generator) {
  return pattern_of([generator](const Vec3& p) {
    const double n = noise(p, generator);
    return n * n * n;
  });
}
PatternPtr make_granite(int generator) {
  return pattern_of([generator](const Vec3& p) {
    const Vec3 fine = p * 4.0;
    double sum = 0.0, frequency = 1.0;
    for (int octave = 0; octave < 6; ++octave, frequency *= 2.0) {
      const double n = noise(fine * frequency, generator);
      const double ridge =
          generator == 1 ? std::fabs(0.5 - n) : std::min(std::fabs(1.0 - 2.0 * n), 0.5);
      sum += ridge / frequency;
    }
    return sum;
  });
}
PatternPtr make_wrinkles(int generator) {
  return pattern_of([generator](const Vec3& p) {
    double sum = 0.0, scale = 1.0, weight = 1.0;
    for (int octave = 0; octave < 10; ++octave, scale *= 2.0, weight *= 0.5) {
      const double n = noise(p * scale, generator);
      sum += weight * (generator > 1 ? std::clamp(2.0 * n - 0.5, 0.0, 1.0) : n);
    }
    return sum / 2.0;
  });
}
PatternPtr make_marble(const std::optional<Turbulence>& turbulence, int generator) {
  return pattern_of([turbulence, generator](const Vec3& p) {
    if (!turbulence || turbulence->amount.x == 0.0) return p.x;
    return p.x + turbulence->amount.x * core::turbulence(p, *turbulence, generator);
  });
}
PatternPtr make_wood(const std::optional<Turbulence>& turbulence) {
  return pattern_of([turbulence](const Vec3& p) {
    double x = p.x, y = p.y;
    if (turbulence) {
      const Vec3 shift = vector_turbulence(p, *turbulence);
      x += cycloidal((p.x + shift.x) * turbulence->amount.x);
      y += cycloidal((p.y + shift.y) * turbulence->amount.y);
    }
    return std::sqrt(x * x + y * y);
  });
}
PatternPtr make_agate(const Turbulence& turbulence, double scale, int generator) {
  return pattern_of([turbulence, scale, generator](const Vec3& p) {
    const double bands = scale * core::turbulence(p, turbulence, generator);
    const double wave = 0.5 * (cycloidal(1.3 * bands + 1.1 * p.z) + 1.0);
    return wave < 0.0 ? 0.0 : std::pow(std::min(wave, 1.0), 0.77);
  });
}
PatternPtr make_spiral(int arms, const std::optional<Turbulence>& turbulence, int generator,
                       bool second) {
  return pattern_of([arms, turbulence, generator, second](const Vec3& p) {
    double shift = 0.0;
    if (turbulence && turbulence->amount.x != 0.0)
      shift = turbulence->amount.x * core::turbulence(p, *turbulence, generator);
    const double radius = std::sqrt(p.x * p.x + p.y * p.y);
    double angle = 0.0;
    if (radius != 0.0) {
      const double lift = std::asin(p.y / radius);
      angle = p.x < 0.0 ? 1.5 * kPi - lift : 0.5 * kPi + lift;
    }
    const double turns = p.z + radius + arms * angle / (2.0 * kPi) + shift;
    return second ? triangle_wave(radius) + triangle_wave(turns) : turns;
  });
}
PatternPtr make_ripples(int sources, double frequency, double phase) {
  return pattern_of([all = wave_sources(sources), frequency, phase](const Vec3& p) {
    double sum = 0.0;
    for (const WaveSource& source : all) {
      const double distance = length(p - source.position);
      sum += cycloidal((distance == 0.0 ? 1.0 : distance) * frequency + phase);
    }
    return 0.5 * (1.0 + sum / static_cast<double>(all.size()));
  });
}
PatternPtr make_waves(int sources, double frequency, double phase) {
  return pattern_of([all = wave_sources(sources), frequency, phase](const Vec3& p) {
    double sum = 0.0;
    for (const WaveSource& source : all) {
      const double distance = length(p - source.position);
      const double way = (distance == 0.0 ? 1.0 : distance) * frequency * source.frequency;
      sum += cycloidal(way + phase) / source.frequency;
    }
    return 0.2 * (2.5 + sum / static_cast<double>(all.size()));
  });
}
PatternPtr make_crackle(const Crackle& crackle, int generator) {
  return std::make_unique<CracklePattern>(crackle, generator);
}

}  // namespace lentray::core
