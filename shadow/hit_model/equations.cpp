#include "shadow/hit_model/equations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lentray::shadow::paper {
namespace {

/// Quotients that are whole but for rounding are whole: A = 3 P is three lenses.
std::uint64_t whole_part(double value) {
  constexpr double kRounding = 1e-9;
  return static_cast<std::uint64_t>(std::max(0.0, std::floor(value * (1.0 + kRounding))));
}

std::uint64_t rays_of_lens(double pixels) { return static_cast<std::uint64_t>(std::ceil(pixels)); }

/// Half the width of the fan on the shadow's plane, D tan(alpha/2); finite for D = 0.
double half_fan(const camera::LensParameters& lens, double distance, Alpha kind) {
  if (distance == 0.0) return 0.0;
  return distance * std::tan(0.5 * fan_angle(lens, kind));
}

}  // namespace

const char* name_of(Alpha alpha) { return alpha == Alpha::kPrinted ? "printed" : "refracted"; }

double fan_angle(const camera::LensParameters& lens, Alpha kind) {
  const double edge = 0.5 * lens.pixels * lens.pixel_size();
  if (kind == Alpha::kPrinted) return 2.0 * std::atan(edge / lens.focal_length);
  double slope = 0.0;
  if (!camera::slope_of(lens, edge, slope)) return std::numbers::pi;
  return 2.0 * std::atan(slope);
}

double ray_angle(double alpha, double pixels) { return alpha / pixels; }

double shadow_angle(double width, double distance) { return std::atan2(width, distance); }

std::uint64_t hits_by_angles(double theta, double beta) { return whole_part(theta / beta); }

std::uint64_t hits_in_lens(const camera::LensParameters& lens, double width, double distance,
                           Alpha kind) {
  const double theta = shadow_angle(width, distance);
  const double beta = ray_angle(fan_angle(lens, kind), lens.pixels);
  return std::min(hits_by_angles(theta, beta), rays_of_lens(lens.pixels));
}

double first_place(const camera::LensParameters& lens, double array_start, double n,
                   double distance, Alpha kind) {
  return array_start + lens.pitch * n - half_fan(lens, distance, kind);
}

double last_place(const camera::LensParameters& lens, double array_start, double n, double distance,
                  Alpha kind) {
  return array_start + lens.pitch * n + half_fan(lens, distance, kind);
}

bool crosses(double first_place_of_next, double shadow_end, double width) {
  return first_place_of_next >= shadow_end - width;
}

int crossing_status(double first_place_of_next, double shadow_start) {
  return first_place_of_next >= shadow_start ? 1 : 0;
}

std::uint64_t hits_with_crossing(std::uint64_t in_lens, int status, double pixels) {
  return std::min(in_lens + static_cast<std::uint64_t>(status), rays_of_lens(pixels));
}

std::uint64_t style1_hits(const camera::LensParameters& lens, const Across& across, Alpha kind) {
  const std::uint64_t in_lens = hits_in_lens(lens, across.width, across.distance, kind);
  const double end = across.start + across.width;
  const auto last_hits = [&](std::uint32_t n) {
    const double place = last_place(lens, across.array_start, n, across.distance, kind);
    return place >= across.start && place <= end;
  };
  const auto status = [&](std::uint32_t n) {  // of the crossing from lens n
    if (n + 1 >= across.lenses || !last_hits(n)) return 0;
    return crossing_status(first_place(lens, across.array_start, n + 1.0, across.distance, kind),
                           across.start);
  };
  std::uint32_t n = 0;
  while (n < across.lenses && status(n) == 0) ++n;
  if (n == across.lenses) return in_lens;
  std::uint64_t sum = 0;
  for (int product = 1; product == 1; ++n) {
    product = status(n);
    sum += hits_with_crossing(in_lens, product, lens.pixels);
  }
  return sum;
}

std::uint64_t style2_hits(const camera::LensParameters& lens, double width) {
  return whole_part(width / lens.pitch);
}

std::uint32_t lenses_that_see(const camera::LensParameters& lens, const Across& across,
                              Alpha kind) {
  std::uint32_t count = 0;
  for (std::uint32_t n = 0; n < across.lenses; ++n) {
    const double first = first_place(lens, across.array_start, n, across.distance, kind);
    const double last = last_place(lens, across.array_start, n, across.distance, kind);
    if (first <= across.start + across.width && last >= across.start) ++count;
  }
  return count;
}

std::uint64_t combined_hits(const camera::LensParameters& lens, const Across& across, Alpha kind) {
  const std::uint64_t in_lens = hits_in_lens(lens, across.width, across.distance, kind);
  return lenses_that_see(lens, across, kind) * hits_with_crossing(in_lens, 1, lens.pixels);
}

std::uint64_t style3_hits(const camera::LensParameters& lens, double height) {
  return whole_part(height / lens.pixel_size());
}

std::uint64_t two_dimensional_hits(const camera::LensParameters& lens, const Across& across,
                                   double height, Alpha kind) {
  return combined_hits(lens, across, kind) * style3_hits(lens, height);
}

}  // namespace lentray::shadow::paper
