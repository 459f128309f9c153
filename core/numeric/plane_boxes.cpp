#include "core/numeric/plane_boxes.h"

#include <immintrin.h>

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

constexpr double kRounding = 0x1p-20;  ///< of the largest number: above that of floats
constexpr float kNothing = -1e30f;     ///< half width of a box that is not there

}  // namespace

std::vector<PlaneBoxes::Eight> PlaneBoxes::eights(const std::vector<PlaneBox>& boxes, const Vec2& lo,
                                                  const Vec2& share) {
  Eight nothing{};
  std::fill_n(nothing.du, kLanes, kNothing);
  std::fill_n(nothing.dv, kLanes, kNothing);
  std::vector<Eight> all((boxes.size() + kLanes - 1) / kLanes, nothing);
  const bool is_known = share.u > 0.0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Eight& eight = all[i / kLanes];
    const auto set = [&](float* middle, float* half, double from, double to, double least, double by) {
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
  m_share = are_known ? Vec2{1.0 / (around.hi.u - around.lo.u), 1.0 / (around.hi.v - around.lo.v)} : Vec2{};
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
  constexpr double kFar = 0x1p9;  // of the box around: farther, floats tell too little
  const __m128d sign = _mm_set1_pd(-0.0), one_half = _mm_set1_pd(0.5), shares = _mm_loadu_pd(&share.u);
  const auto in_shares = [&](const Vec2& p) {
    return _mm_mul_pd(_mm_sub_pd(_mm_loadu_pd(&p.u), _mm_loadu_pd(&lo.u)), shares);
  };
  const auto sum = [](__m128d uv) { return _mm_cvtsd_f64(_mm_add_sd(uv, _mm_unpackhi_pd(uv, uv))); };
  const __m128d begin = in_shares(way.begin), end = in_shares(way.end);
  const __m128d along = _mm_sub_pd(end, begin), length = _mm_andnot_pd(sign, along);
  const __m128d between = _mm_mul_pd(_mm_add_pd(begin, end), one_half);
  const double far = sum(_mm_add_pd(_mm_andnot_pd(sign, between), length));
  if (!way.is_known || !(share.u > 0.0) || !(far < kFar)) {
    middle[0] = middle[1] = across[0] = across[1] = reach = 0.0f;
    half[0] = half[1] = 1e15f;
    return;
  }
  const double slack = kRounding * (1.0 + far) + way.slack * std::max(share.u, share.v);
  const auto put = [](float* at, __m128d uv) { _mm_storel_pi(reinterpret_cast<__m64*>(at), _mm_cvtpd_ps(uv)); };
  put(middle, between);
  put(half, _mm_add_pd(_mm_mul_pd(length, one_half), _mm_set1_pd(slack)));
  put(across, _mm_xor_pd(_mm_shuffle_pd(along, along, 1), _mm_set_pd(-0.0, 0.0)));
  reach = static_cast<float>(sum(length) * slack);
}

std::uint64_t PlaneBoxes::touched_portable(const Line& line, const Eight* first, std::size_t count) {
  std::uint64_t touched = 0;
  for (std::size_t i = 0; i < count * kLanes; ++i) {
    const Eight& eight = first[i / kLanes];
    const std::size_t lane = i % kLanes;
    const float u = eight.u[lane] - line.middle[0], v = eight.v[lane] - line.middle[1], du = eight.du[lane], dv = eight.dv[lane];
    const bool beside = std::fabs(u) > du + line.half[0] || std::fabs(v) > dv + line.half[1];
    const float reach = du * std::fabs(line.across[0]) + (dv * std::fabs(line.across[1]) + line.reach);
    const bool across = std::fabs(u * line.across[0] + v * line.across[1]) > reach;
    if (!beside && !across) touched |= std::uint64_t{1} << i;
  }
  return touched;
}

LENTRAY_AVX2 std::uint64_t PlaneBoxes::touched_avx2(const Line& line, const Eight* first, std::size_t count) {
  const __m256 sign = _mm256_set1_ps(-0.0f);
  const __m256 middle_u = _mm256_set1_ps(line.middle[0]), middle_v = _mm256_set1_ps(line.middle[1]);
  const __m256 wide_u = _mm256_set1_ps(line.half[0]), wide_v = _mm256_set1_ps(line.half[1]);
  const __m256 nu = _mm256_set1_ps(line.across[0]), nv = _mm256_set1_ps(line.across[1]), reach = _mm256_set1_ps(line.reach);
  const __m256 abs_nu = _mm256_andnot_ps(sign, nu), abs_nv = _mm256_andnot_ps(sign, nv);
  std::uint64_t touched = 0;
  for (std::size_t i = count; i-- > 0;) {
    const Eight& eight = first[i];
    const __m256 u = _mm256_sub_ps(_mm256_load_ps(eight.u), middle_u);
    const __m256 v = _mm256_sub_ps(_mm256_load_ps(eight.v), middle_v);
    const __m256 du = _mm256_load_ps(eight.du), dv = _mm256_load_ps(eight.dv);
    const __m256 off = _mm256_fmadd_ps(u, nu, _mm256_mul_ps(v, nv));
    const __m256 most = _mm256_fmadd_ps(du, abs_nu, _mm256_fmadd_ps(dv, abs_nv, reach));
    __m256 in = _mm256_cmp_ps(_mm256_andnot_ps(sign, u), _mm256_add_ps(du, wide_u), _CMP_LE_OQ);
    in = _mm256_and_ps(in, _mm256_cmp_ps(_mm256_andnot_ps(sign, v), _mm256_add_ps(dv, wide_v), _CMP_LE_OQ));
    in = _mm256_and_ps(in, _mm256_cmp_ps(_mm256_andnot_ps(sign, off), most, _CMP_LE_OQ));
    touched = touched << kLanes | static_cast<std::uint64_t>(_mm256_movemask_ps(in));
  }
  return touched;
}

}  // namespace lentray::core
