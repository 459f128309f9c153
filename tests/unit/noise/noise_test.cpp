// Noise remembers cells: what it gives must not depend on what was asked for before.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include "core/noise/noise.h"

namespace lentray::core {
namespace {

std::vector<Vec3> points() {
  std::mt19937_64 random(3);
  std::vector<Vec3> all{{0, 0, 0},    {-0.0, -0.0, -0.0},   {1, 2, 3},
                        {-1, -2, -3}, {-1e-11, 1e-11, 0.5}, {4096, -4096, 8192},
                        {1e9, 2, 3},  {-2.2e9, 1e12, 3},    {1e300, 0, 0}};
  all.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  all.push_back({0, std::numeric_limits<double>::infinity(), 0});
  for (const double size : {0.9, 7.0, 60.0, 3e4, 3e9}) {
    std::uniform_real_distribution<double> place(-size, size);
    for (int i = 0; i < 400; ++i) all.push_back({place(random), place(random), place(random)});
  }
  return all;
}

std::uint64_t noise_bits(double v) { return std::isnan(v) ? 0 : std::bit_cast<std::uint64_t>(v); }

/// Of a thread that has been asked for nothing yet.
std::vector<double> asked_afresh(const std::vector<Vec3>& all, int generator) {
  std::vector<double> values;
  for (const Vec3& p : all) {
    std::thread([&] { values.push_back(noise(p, generator)); }).join();
  }
  return values;
}

TEST(UnitCoreNoise, DoesNotDependOnWhatWasAskedBefore) {
  const std::vector<Vec3> all = points();
  for (const int generator : {1, 2, 3}) {
    const std::vector<double> fresh = asked_afresh(all, generator);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(noise_bits(fresh[i]), noise_bits(noise(all[i], generator)));
      EXPECT_EQ(noise_bits(fresh[i]), noise_bits(noise(all[i], generator))) << "asked for twice";
      EXPECT_EQ(noise_bits(fresh[i]), noise_bits(noise(all[i], generator))) << "known by now";
    }
    // Cells 8 apart share a place where cells are kept.
    for (int i = 0; i < 200; ++i) {
      const Vec3 p{0.25 + 8.0 * (i % 3), 0.5 - 8.0 * (i % 2), 0.75};
      double value = 0.0;
      std::thread([&] { value = noise(p, generator); }).join();
      EXPECT_EQ(noise_bits(value), noise_bits(noise(p, generator)));
    }
  }
}

TEST(UnitCoreNoise, TwoAtOnceAreLikeOneAfterTheOther) {
  const std::vector<Vec3> all = points();
  for (const int generator : {1, 2, 3}) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vec3 &p = all[i], &q = all[(i * 7 + 1) % all.size()];
      const NoisePair pair =
          noise(NoisePair{p.x, q.x}, NoisePair{p.y, q.y}, NoisePair{p.z, q.z}, generator);
      EXPECT_EQ(noise_bits(pair[0]), noise_bits(noise(p, generator)));
      EXPECT_EQ(noise_bits(pair[1]), noise_bits(noise(q, generator)));
    }
  }
}

TEST(UnitCoreNoise, OctavesTogetherAreLikeOneAfterTheOther) {
  const std::vector<Vec3> all = points();
  for (const double lambda : {2.0, 3.25, 0.3, 1e4}) {
    for (int octaves = 0; octaves <= 10; ++octaves) {
      const Turbulence turbulence{{1, 1, 1}, octaves, lambda, 0.65725};
      for (const Vec3& p : all) {
        Vec3 sum = vector_noise(p);
        double scale = lambda, weight = turbulence.omega;
        for (int octave = 2; octave <= octaves; ++octave) {
          sum += vector_noise(p * scale) * weight;
          scale *= lambda;
          weight *= turbulence.omega;
        }
        const Vec3 together = vector_turbulence(p, turbulence);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(noise_bits(together[axis]), noise_bits(sum[axis])) << octaves << ' ' << lambda;
        }
      }
    }
  }
}

TEST(UnitCoreNoise, InAPlaneItIsTheSame) {
  const std::vector<Vec3> all = points();
  for (const int generator : {1, 2, 3}) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto in_plane = [&](Vec3 p) {
        p[axis] = 0.0;
        return p;
      };
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Vec3 p = in_plane(all[i]), q = in_plane(all[(i * 7 + 1) % all.size()]);
        const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
        EXPECT_EQ(noise_bits(noise_in_plane(axis, p[u], p[v], generator)),
                  noise_bits(noise(p, generator)))
            << i;
        const NoisePair pair =
            noise_in_plane(axis, NoisePair{p[u], q[u]}, NoisePair{p[v], q[v]}, generator);
        EXPECT_EQ(noise_bits(pair[0]), noise_bits(noise(p, generator))) << i;
        EXPECT_EQ(noise_bits(pair[1]), noise_bits(noise(q, generator))) << i;
      }
    }
  }
  // Cells that share a place where cells are kept, at once and one after the other.
  for (int i = 0; i < 300; ++i) {
    const NoisePair u{0.25 + 16.0 * (i % 5), 0.25 - 16.0 * (i % 3)}, v{0.75 - i % 4, 0.75 + i % 2};
    const NoisePair pair = noise_in_plane(1, u, v, 2);
    for (int k : {0, 1}) EXPECT_EQ(noise_bits(pair[k]), noise_bits(noise(u[k], 0.0, v[k], 2)));
  }
}

}  // namespace
}  // namespace lentray::core
