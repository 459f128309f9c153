// Light of photons beside truths that need no renderer: a pane of glass, and energy, focus and
// caustic of a ball of glass. Spacings and lights are powers of two, so that the eight bits of a
// photon hold its power.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr double kTruthIor = 1.5;

struct PhotonTruth {
  std::string glass = "sphere { 0, 1";
  double floor = -1.0;  ///< its height; the ball's radius is 1
  double width = 1.0;   ///< of the piece of floor that is seen
  std::uint32_t size = 60;
  double light = 0.5, beam = 1.0, spacing = 1.0 / 64.0, gathered = 0.1;
};

/// Light on the floor, in that of the beam, and squared distances from the axis.
struct LitFloor {
  struct Place {
    double light, squared;
  };
  std::vector<Place> places;
  double pixel;  ///< its side
};

LitFloor lit_floor(const PhotonTruth& truth) {
  const auto text = [](double number) { return std::to_string(number); };
  SceneText scene;
  scene.sdl = "#version 3.7;\nglobal_settings { assumed_gamma 1 photons { spacing " +
              text(truth.spacing) + " gather 0, 1000000 radius " + text(truth.gathered) +
              " } }\ncamera { orthographic location <0, " + text(truth.floor) +
              " + 0.01, 0> direction -0.01*y up z*" + text(truth.width) + " right x*" +
              text(truth.width) + " }\nlight_source { 20*y rgb " + text(truth.light) +
              " parallel point_at 0 cylinder tightness 0 radius " + text(truth.beam) + " falloff " +
              text(truth.beam) + " }\nplane { y, " + text(truth.floor) +
              " pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n" + truth.glass +
              " pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 }\n"
              "photons { target refraction on reflection off collect off } }\n";
  scene.width = scene.height = truth.size;
  scene.bits = 16;
  scene.arguments = {"File_Gamma=1.0"};
  const StoredImage picture = lentray_render(scene);
  LitFloor lit{{}, truth.width / truth.size};
  const auto off = [&](std::uint32_t place) {
    return (place + 0.5) * lit.pixel - truth.width / 2.0;
  };
  for (std::uint32_t row = 0; row < truth.size; ++row) {
    for (std::uint32_t column = 0; column < truth.size; ++column) {
      lit.places.push_back({picture.at(column, row, 0) / 65535.0 / truth.light,
                            off(row) * off(row) + off(column) * off(column)});
    }
  }
  return lit;
}

/// How far from the axis a ray of the beam comes down below the ball: Snell's law, twice.
std::optional<double> landing(double offset, double floor) {
  const double outer = std::asin(offset), inner = std::asin(offset / kTruthIor);
  const double bent = 2.0 * (outer - inner), exit = 2.0 * inner - outer;
  if (bent >= std::numbers::pi / 2.0) return std::nullopt;
  return std::fabs(std::sin(exit) - (-std::cos(exit) - floor) * std::tan(bent));
}

/// `see(area, landing)` for rings of the beam.
template <class See>
void each_ring(double floor, See&& see) {
  constexpr int kRings = 4000;
  for (int i = 0; i < kRings; ++i) {
    const double offset = (i + 0.5) / kRings;
    const auto place = landing(offset, floor);
    if (place) see(2.0 * std::numbers::pi * offset / kRings, *place);
  }
}

/// The mean over the gathered disc.
double caustic(double floor, double gathered, double distance) {
  double sum = 0.0;
  each_ring(floor, [&](double area, double place) {
    if (std::fabs(place - distance) >= gathered) return;
    const double cosine =
        (place * place + distance * distance - gathered * gathered) / (2.0 * place * distance);
    sum += area * std::acos(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi;
  });
  return sum / (std::numbers::pi * gathered * gathered);
}

TEST(ImagePhotonTruths, APaneOfGlassTakesNoLight) {
  const LitFloor lit = lit_floor({.glass = "box { <-2, 0, -2>, <2, 0.3, 2>", .beam = 9.0});
  double sum = 0.0;
  for (const LitFloor::Place& place : lit.places) sum += place.light;
  EXPECT_NEAR(sum / static_cast<double>(lit.places.size()), 1.0, 0.002);
}

TEST(ImagePhotonTruths, ABallSendsOnAllThatMeetsIt) {
  constexpr double kFloor = -2.5, kReach = 3.0;
  const LitFloor lit = lit_floor({.floor = kFloor,
                                  .width = 6.4,
                                  .size = 160,
                                  .light = 1.0 / 64.0,
                                  .spacing = 1.0 / 128.0,
                                  .gathered = 0.12});
  double seen = 0.0, sent = 0.0;
  for (const LitFloor::Place& place : lit.places) {
    if (place.squared < kReach * kReach) seen += place.light * lit.pixel * lit.pixel;
  }
  each_ring(kFloor, [&](double area, double place) { sent += place < kReach ? area : 0.0; });
  EXPECT_NEAR(seen / sent, 1.0, 0.01);
}

/// From the widths of a thin beam before and behind it.
TEST(ImagePhotonTruths, ABallsFocusIsWhereItShouldBe) {
  constexpr double kBefore = 1.25, kBehind = 1.75, kGathered = 0.005;
  const auto width = [](double below) {
    const LitFloor lit = lit_floor({.floor = -below,
                                    .width = 0.08,
                                    .size = 50,
                                    .light = 1.0 / 64.0,
                                    .beam = 0.1,
                                    .spacing = 1.0 / 256.0,
                                    .gathered = kGathered});
    double light = 0.0, spread = 0.0;
    for (const LitFloor::Place& place : lit.places) {
      light += place.light;
      spread += place.light * place.squared;
    }
    return std::sqrt(spread / light - kGathered * kGathered / 2.0);
  };
  const double before = width(kBefore), behind = width(kBehind);
  const double focus = kBefore + (kBehind - kBefore) * before / (before + behind);
  EXPECT_NEAR(focus / (kTruthIor / (2.0 * (kTruthIor - 1.0))), 1.0, 0.01);
}

TEST(ImagePhotonTruths, ABallsCausticFallsAsSnellSays) {
  constexpr double kFloor = -1.3, kGathered = 0.03, kFrom = 0.05, kStep = 0.05;
  constexpr std::size_t kBands = 8;
  const LitFloor lit = lit_floor({.floor = kFloor,
                                  .size = 50,
                                  .light = 1.0 / 512.0,
                                  .spacing = 1.0 / 128.0,
                                  .gathered = kGathered});
  std::vector<double> seen(kBands), wanted(kBands);
  for (const LitFloor::Place& place : lit.places) {
    const double distance = std::sqrt(place.squared);
    const auto band = static_cast<std::size_t>((distance - kFrom) / kStep);
    if (distance < kFrom || band >= kBands) continue;
    seen[band] += place.light;
    wanted[band] += caustic(kFloor, kGathered, distance);
  }
  for (std::size_t band = 0; band < kBands; ++band) {
    EXPECT_NEAR(seen[band] / wanted[band], 1.0, 0.04) << kFrom + kStep * static_cast<double>(band);
  }
}

}  // namespace
}  // namespace lentray::test
