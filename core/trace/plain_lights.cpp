#include "core/trace/plain_lights.h"

#include <cmath>

#include "core/base/simd.h"
#include "core/trace/facing.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/reflectance.h"

namespace lentray::core {
namespace {

bool is_plain(const Light& light) {
  const Rgb& c = light.colour;
  return is_even(light) && std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

LENTRAY_SIMD Int4 lanes_of(unsigned bits) {
  const Int4 each{1, 2, 4, 8};
  return (simd::int4(static_cast<int>(bits)) & each) == each;
}
LENTRAY_SIMD Float4 chosen(Int4 lanes, Float4 yes, Float4 no) {
  return Float4((Int4(yes) & lanes) | (Int4(no) & ~lanes));
}
/// times()
LENTRAY_SIMD32 Float4 times_lanes(Float4 colour, Double4 s) {
  return simd::narrowed(simd::widened(colour) * s);
}
LENTRAY_SIMD32 Double4 dot_of(const Double4 (&a)[3], const Double4 (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

/// Four places and one light.
class PlainLights::Lanes {
 public:
  LENTRAY_SIMD32 Lanes(PlainLights& of, const LightAnswers& answers, const Rgb& colour,
                       ShadowCounts& counts, int first)
      : m_of(of), m_answers(answers), m_colour(colour), m_counts(counts), m_first(first) {}

  LENTRAY_SIMD32 void add() {
    const unsigned lit_here = static_cast<unsigned>(m_of.m_lit >> m_first) & 15u;
    if (lit_here == 0) return;
    const Int4 answer = simd::int4_at(m_answers.answer + m_first);
    const Double4 n[3] = {normal(0), normal(1), normal(2)};
    const Double4 d[3] = {direction(0), direction(1), direction(2)};
    const Double4 cosine = dot_of(n, d);
    const unsigned facing = lit_here & simd::signs(answer > simd::int4(LightAnswers::kBehind)) &
                            ~simd::signs(cosine < simd::double4(kGrazing));
    if (facing == 0) return;
    const unsigned dark = facing & simd::signs(answer > simd::int4(LightAnswers::kFiltered));
    count(facing, dark, answer);
    unsigned lit = facing & ~dark;
    if (lit == 0) return;
    Float4 light[3];
    for (int c = 0; c < 3; ++c) light[c] = simd::float4(m_colour[c]);
    if (m_answers.filtered >> m_first & lit) filter(lit, light);
    const Double4 intensity = simd::abs(cosine) * simd::double4_at(m_of.m_diffuse + m_first);
    Float4 share[3];
    for (int c = 0; c < 3; ++c) {
      share[c] = times_lanes(simd::float4_at(m_of.m_pigment[c] + m_first), intensity) * light[c];
    }
    const unsigned shining = lit & static_cast<unsigned>(m_of.m_shining >> m_first);
    if (shining != 0) add_highlights(shining, n, d, light, share);
    const Int4 lanes = lanes_of(lit);
    for (int c = 0; c < 3; ++c) {
      float* const to = m_of.m_sum[c] + m_first;
      const Float4 sum = simd::float4_at(to);
      simd::store(to, chosen(lanes, sum + share[c], sum));
    }
  }

 private:
  LENTRAY_SIMD32 Double4 normal(int axis) const {
    return simd::double4_at(m_of.m_lights.points().normal(axis) + m_first);
  }
  LENTRAY_SIMD32 Double4 direction(int axis) const {
    return simd::double4_at(m_answers.direction[axis] + m_first);
  }
  LENTRAY_SIMD32 Double4 eye(int axis) const {
    return simd::double4_at(m_of.m_eye[axis] + m_first);
  }
  std::size_t place(int i) const { return static_cast<std::size_t>(m_first + i); }

  /// As visibility() of the plain tester.
  LENTRAY_SIMD32 void count(unsigned facing, unsigned dark, Int4 answer) {
    const auto number = [](unsigned bits) {
      return static_cast<std::uint64_t>(__builtin_popcount(bits));
    };
    m_counts.rays += number(facing);
    m_counts.blocked += number(dark);
    if (!m_of.m_counts_hits) return;
    const std::uint64_t hits =
        number(dark & simd::signs(answer == simd::int4(LightAnswers::kForeseen)));
    m_counts.hits += hits;
    m_counts.misses += number(dark) - hits;
  }
  [[gnu::noinline]] void filter(unsigned& lit, Float4 (&light)[3]) const {
    const unsigned filtered = static_cast<unsigned>(m_answers.filtered >> m_first) & lit;
    for (unsigned left = filtered; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      Rgb colour = m_colour;
      colour *= m_of.m_filter[place(i)];
      for (int c = 0; c < 3; ++c) light[c][i] = colour[c];
      if (is_dark(colour)) lit &= ~(1u << i);
    }
  }
  /// highlights(), of finishes that are not metallic.
  LENTRAY_SIMD32 void add_highlights(unsigned shining, const Double4 (&n)[3], const Double4 (&d)[3],
                                     const Float4 (&light)[3], Float4 (&share)[3]) {
    const Double4 e[3] = {eye(0), eye(1), eye(2)};
    const Double4 back = -2.0 * dot_of(e, n);
    const Double4 mirrored[3] = {e[0] + n[0] * back, e[1] + n[1] * back, e[2] + n[2] * back};
    const Double4 half[3] = {(d[0] - e[0]) * 0.5, (d[1] - e[1]) * 0.5, (d[2] - e[2]) * 0.5};
    const Double4 size = simd::sqrt(dot_of(half, half));
    const Double4 at_mirror = dot_of(mirrored, d), at_half = dot_of(half, n) / size;
    alignas(32) double phong[4] = {}, specular[4] = {};
    for (unsigned left = shining; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      const Finish& finish = *m_of.m_texture[place(i)]->finish;
      if (finish.phong > 0.0) phong[i] = phong_of(finish, at_mirror[i]);
      if (finish.specular > 0.0 && size[i] > 0.0) specular[i] = specular_of(finish, at_half[i]);
    }
    const Double4 by_phong = simd::double4_at(phong), by_specular = simd::double4_at(specular);
    const Int4 lanes = lanes_of(shining);
    for (int c = 0; c < 3; ++c) {
      const Float4 highlight =
          Float4{} + times_lanes(light[c], by_phong) + times_lanes(light[c], by_specular);
      share[c] = chosen(lanes, share[c] + highlight, share[c]);
    }
  }

  PlainLights& m_of;
  const LightAnswers& m_answers;
  const Rgb& m_colour;
  ShadowCounts& m_counts;
  const int m_first;
};

PlainLights::PlainLights(ThreadContext& context, ShadowTester& shadows, const BlockLights& lights)
    : m_context(context), m_lights(lights) {
  if (!lights.knows_all()) return;
  m_counts_hits = shadows.plain()->counts_hits();
  m_works = true;
  for (const std::uint32_t i : context.scene.global_lights()) {
    if (!is_plain(context.scene.lights()[i])) m_works = false;
  }
}

void PlainLights::drop_unknown() {
  for (const std::uint32_t i : m_context.scene.global_lights()) m_lit &= ~m_lights.of(i)->unknown;
}

LENTRAY_AVX2 void PlainLights::add_light(std::uint32_t light, const LightAnswers& answers) {
  const Rgb& colour = m_context.scene.lights()[light].colour;
  if (is_dark(colour)) return;
  ShadowCounts& counts = m_context.counters.lights[light];
  const int count = static_cast<int>(m_count);
  for (int first = 0; first < count; first += 4) {
    Lanes(*this, answers, colour, counts, first).add();
  }
}

}  // namespace lentray::core
