#include "core/numeric/plane_boxes.h"

#include <algorithm>
#include <cmath>

#include "core/base/simd.h"

namespace lentray::core {
namespace {

constexpr double kRounding = 0x1p-20;  ///< of the largest number: above that of floats
constexpr float kNothing = -1e30f;     ///< half width of a box that is not there

}  // namespace

std::vector<PlaneBoxes::Eight> PlaneBoxes::eights(const std::vector<PlaneBox>& boxes,
                                                  const Vec2& lo, const Vec2& share) {
  Eight nothing{};
  std::fill_n(nothing.du, kLanes, kNothing);
  std::fill_n(nothing.dv, kLanes, kNothing);
  std::vector<Eight> all((boxes.size() + kLanes - 1) / kLanes, nothing);
  const bool is_known = share.u > 0.0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Eight& eight = all[i / kLanes];
    const auto set = [&](float* middle, float* half, double from, double to, double least,
                         double by) {
      const double a = (from - least) * by, b = (to - least) * by;
      middle[i % kLanes] = is_known ? static_cast<float>(0.5 * (a + b)) : 0.0f;
      half[i % kLanes] = is_known ? static_cast<float>(0.5 * (b - a) + kRounding) : 1.0f;
    };
    set(eight.u, eight.du, boxes[i].lo.u, boxes[i].hi.u, lo.u, share.u);
    set(eight.v, eight.dv, boxes[i].lo.v, boxes[i].hi.v, lo.v, share.v);
  }
  return all;
}

void PlaneBoxes::fill(const std::vector<PlaneBox>& boxes, const PlaneBox& around, bool are_known) {
  m_lo = are_known ? around.lo : Vec2{};
  m_share = are_known ? Vec2{1.0 / (around.hi.u - around.lo.u), 1.0 / (around.hi.v - around.lo.v)}
                      : Vec2{};
  m_boxes = eights(boxes, m_lo, m_share);
  m_sets.clear();
  if (boxes.size() <= kSet) return;
  std::vector<PlaneBox> sets;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i % kSet == 0) sets.push_back(boxes[i]);
    PlaneBox& box = sets.back();
    box.lo = {std::min(box.lo.u, boxes[i].lo.u), std::min(box.lo.v, boxes[i].lo.v)};
    box.hi = {std::max(box.hi.u, boxes[i].hi.u), std::max(box.hi.v, boxes[i].hi.v)};
  }
  m_sets = eights(sets, m_lo, m_share);
}

PlaneBoxes::Line::Line(const PlaneWay& way, const Vec2& lo, const Vec2& share) {
  constexpr double kFar = 0x1p9;  // of the box around: farther, floats are too coarse
  const Double2 shares = simd::double2_at(&share.u);
  const auto in_shares = [&](const Vec2& p) {
    return (simd::double2_at(&p.u) - simd::double2_at(&lo.u)) * shares;
  };
  const auto sum = [](Double2 uv) { return uv[0] + uv[1]; };
  const Double2 begin = in_shares(way.begin), end = in_shares(way.end);
  const Double2 along = end - begin, length = simd::abs(along);
  const Double2 between = (begin + end) * 0.5;
  const double far = sum(simd::abs(between) + length);
  if (!way.is_known || !(share.u > 0.0) || !(far < kFar)) {
    middle[0] = middle[1] = across[0] = across[1] = reach = 0.0f;
    half[0] = half[1] = 1e15f;
    return;
  }
  const double slack = kRounding * (1.0 + far) + way.slack * std::max(share.u, share.v);
  simd::store_narrowed(middle, between);
  simd::store_narrowed(half, length * 0.5 + slack);
  simd::store_narrowed(across, simd::shuffled<1, 0>(along) * Double2{1.0, -1.0});
  reach = static_cast<float>(sum(length) * slack);
}

std::uint64_t PlaneBoxes::touched_portable(const Line& line, const Eight* first,
                                           std::size_t count) {
  std::uint64_t touched = 0;
  for (std::size_t i = 0; i < count * kLanes; ++i) {
    const Eight& eight = first[i / kLanes];
    const std::size_t lane = i % kLanes;
    const float u = eight.u[lane] - line.middle[0], v = eight.v[lane] - line.middle[1],
                du = eight.du[lane], dv = eight.dv[lane];
    const bool beside = std::fabs(u) > du + line.half[0] || std::fabs(v) > dv + line.half[1];
    const float reach =
        du * std::fabs(line.across[0]) + (dv * std::fabs(line.across[1]) + line.reach);
    const bool across = std::fabs(u * line.across[0] + v * line.across[1]) > reach;
    if (!beside && !across) touched |= std::uint64_t{1} << i;
  }
  return touched;
}

LENTRAY_AVX2 std::uint64_t PlaneBoxes::touched_avx2(const Line& line, const Eight* first,
                                                    std::size_t count) {
  const Float8 middle_u = simd::float8(line.middle[0]), middle_v = simd::float8(line.middle[1]);
  const Float8 wide_u = simd::float8(line.half[0]), wide_v = simd::float8(line.half[1]);
  const Float8 nu = simd::float8(line.across[0]), nv = simd::float8(line.across[1]),
               reach = simd::float8(line.reach);
  const Float8 abs_nu = simd::abs(nu), abs_nv = simd::abs(nv);
  std::uint64_t touched = 0;
  for (std::size_t i = count; i-- > 0;) {
    const Eight& eight = first[i];
    const Float8 u = simd::float8_at(eight.u) - middle_u;
    const Float8 v = simd::float8_at(eight.v) - middle_v;
    const Float8 du = simd::float8_at(eight.du), dv = simd::float8_at(eight.dv);
    const Float8 off = simd::fma(u, nu, v * nv);
    const Float8 most = simd::fma(du, abs_nu, simd::fma(dv, abs_nv, reach));
    Int8 in = simd::abs(u) <= du + wide_u;
    in &= simd::abs(v) <= dv + wide_v;
    in &= simd::abs(off) <= most;
    touched = touched << kLanes | simd::signs(in);
  }
  return touched;
}

}  // namespace lentray::core
