#include "core/trace/plain_lights.h"

#include <algorithm>
#include <cmath>

#include "core/base/simd.h"
#include "core/trace/facing.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/reflectance.h"

namespace lentray::core {
namespace {

bool is_plain(const Light& light) {
  const Rgb& c = light.colour;
  return !light.illuminates_by_area() && std::isfinite(c.r) && std::isfinite(c.g) &&
         std::isfinite(c.b);
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
    const unsigned here = bits(m_of.m_lit & ~m_of.m_unlit);
    if (here == 0) return;
    const Int4 answer = simd::int4_at(m_answers.answer + m_first);
    const unsigned asked = here & simd::signs(answer > simd::int4(LightAnswers::kBehind));
    if (asked == 0) return;
    for (std::size_t d = 0; d < m_of.m_deepest; ++d) {
      Depth& depth = m_of.m_depths[d];
      if ((bits(depth.lit) & asked) != 0) add(depth, asked, answer);
    }
  }

 private:
  LENTRAY_SIMD32 void add(Depth& depth, unsigned asked, Int4 answer) {
    const Double4 n[3] = {at(depth.normal[0]), at(depth.normal[1]), at(depth.normal[2])};
    const Double4 d[3] = {at(m_answers.direction[0]), at(m_answers.direction[1]),
                          at(m_answers.direction[2])};
    const Double4 cosine = dot_of(n, d);
    const unsigned facing =
        bits(depth.lit) & asked & ~simd::signs(cosine < simd::double4(kGrazing));
    if (facing == 0) return;
    const unsigned dark = facing & simd::signs(answer > simd::int4(LightAnswers::kFiltered));
    count(facing & ~bits(m_of.m_counted), dark, answer);
    m_of.m_counted |= std::uint64_t{facing} << m_first;
    const unsigned lit = facing & ~dark & ~bits(m_of.m_dark);
    if (lit == 0) return;
    Float4 light[3];
    for (int c = 0; c < 3; ++c) light[c] = simd::float4(m_colour[c]);
    const unsigned own = bits(m_of.m_own_colour) & lit;
    if (own != 0) {
      const Int4 lanes = lanes_of(own);
      for (int c = 0; c < 3; ++c) {
        light[c] = chosen(lanes, simd::float4_at(m_of.m_colour[c] + m_first), light[c]);
      }
    }
    Double4 intensity = simd::abs(cosine);
    const unsigned shining = lit & bits(depth.shining);
    if (bits(depth.uneven) & lit) bend(depth, lit, intensity);
    intensity = intensity * at(depth.diffuse);
    Float4 share[3];
    for (int c = 0; c < 3; ++c) {
      share[c] = times_lanes(simd::float4_at(depth.pigment[c] + m_first), intensity) * light[c];
    }
    if (shining != 0) add_highlights(depth, shining, n, d, light, share);
    const Int4 lanes = lanes_of(lit);
    for (int c = 0; c < 3; ++c) {
      float* const to = depth.sum[c] + m_first;
      const Float4 sum = simd::float4_at(to);
      simd::store(to, chosen(lanes, sum + share[c], sum));
    }
  }
  LENTRAY_SIMD32 Double4 at(const double* numbers) const {
    return simd::double4_at(numbers + m_first);
  }
  unsigned bits(std::uint64_t places) const {
    return static_cast<unsigned>(places >> m_first) & 15u;
  }
  std::size_t place(int i) const { return static_cast<std::size_t>(m_first + i); }

  /// As visibility() of the plain tester.
  LENTRAY_SIMD32 void count(unsigned fresh, unsigned dark, Int4 answer) {
    const auto number = [](unsigned bits) {
      return static_cast<std::uint64_t>(__builtin_popcount(bits));
    };
    m_counts.rays += number(fresh);
    m_counts.blocked += number(fresh & dark);
    if (!m_of.m_counts_hits) return;
    const std::uint64_t hits =
        number(fresh & dark & simd::signs(answer == simd::int4(LightAnswers::kForeseen)));
    m_counts.hits += hits;
    m_counts.misses += number(fresh & dark) - hits;
  }
  /// The brilliance of diffuse light.
  [[gnu::noinline]] void bend(const Depth& depth, unsigned lit, Double4& intensity) const {
    for (unsigned left = bits(depth.uneven) & lit; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      intensity[i] = std::pow(intensity[i], depth.layer[place(i)]->finish->brilliance);
    }
  }
  /// highlights()
  LENTRAY_SIMD32 void add_highlights(const Depth& depth, unsigned shining, const Double4 (&n)[3],
                                     const Double4 (&d)[3], const Float4 (&light)[3],
                                     Float4 (&share)[3]) {
    const Double4 e[3] = {at(m_of.m_eye[0]), at(m_of.m_eye[1]), at(m_of.m_eye[2])};
    const Double4 back = -2.0 * dot_of(e, n);
    const Double4 mirrored[3] = {e[0] + n[0] * back, e[1] + n[1] * back, e[2] + n[2] * back};
    const Double4 half[3] = {(d[0] - e[0]) * 0.5, (d[1] - e[1]) * 0.5, (d[2] - e[2]) * 0.5};
    const Double4 size = simd::sqrt(dot_of(half, half));
    const Double4 at_mirror = dot_of(mirrored, d), at_half = dot_of(half, n) / size;
    alignas(32) double phong[4] = {}, specular[4] = {};
    Float4 shown[3] = {light[0], light[1], light[2]};
    for (unsigned left = shining; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      const Layer& layer = *depth.layer[place(i)];
      const Finish& finish = *layer.finish;
      if (finish.phong > 0.0) phong[i] = phong_of(finish, at_mirror[i]);
      if (finish.specular > 0.0 && size[i] > 0.0) specular[i] = specular_of(finish, at_half[i]);
      if (finish.metallic > 0.0) show_on_metal(layer, i, shown);
    }
    const Double4 by_phong = simd::double4_at(phong), by_specular = simd::double4_at(specular);
    const Int4 lanes = lanes_of(shining);
    for (int c = 0; c < 3; ++c) {
      const Float4 highlight =
          Float4{} + times_lanes(shown[c], by_phong) + times_lanes(shown[c], by_specular);
      share[c] = chosen(lanes, share[c] + highlight, share[c]);
    }
  }
  [[gnu::noinline]] void show_on_metal(const Layer& layer, int i, Float4 (&shown)[3]) const {
    const Rgb light{shown[0][i], shown[1][i], shown[2][i]};
    const Rgb on_metal = metal_highlight(
        *layer.finish, {m_answers.direction_at(place(i)), {}, layer.normal, light, layer.pigment});
    for (int c = 0; c < 3; ++c) shown[c][i] = on_metal[c];
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

void PlainLights::add(Layers layers, const Vec3& eye) {
  const std::size_t at = m_count++;
  if (layers.empty() || layers.size() > kMostLayers) return;
  const std::uint64_t bit = std::uint64_t{1} << at;
  m_known |= bit;
  for (; m_deepest < layers.size(); ++m_deepest) m_depths[m_deepest].clear();
  for (int a = 0; a < 3; ++a) m_eye[a][at] = eye[a];
  for (std::size_t d = 0; d < layers.size(); ++d) {
    const Layer& layer = layers[d];
    Depth& depth = m_depths[d];
    for (int c = 0; c < 3; ++c) depth.sum[c][at] = 0.0f;
    if (!layer.is_lit) continue;
    m_lit |= bit;
    if (layer.diffuse != 0.0) m_diffuse |= bit;
    if (layer.diffuse != 0.0 || layer.shines) m_shows |= bit;
    depth.lit |= bit;
    if (layer.shines) depth.shining |= bit;
    if (layer.finish->brilliance != 1.0) depth.uneven |= bit;
    depth.layer[at] = &layer;
    depth.diffuse[at] = layer.diffuse;
    for (int c = 0; c < 3; ++c) {
      depth.normal[c][at] = layer.normal[c];
      depth.pigment[c][at] = layer.pigment[c];
    }
  }
}

void PlainLights::drop_unknown() {
  std::uint64_t unknown = 0;
  for (const std::uint32_t i : m_context.scene.global_lights()) unknown |= m_lights.of(i)->unknown;
  unknown &= m_lit;
  m_known &= ~unknown;
  m_lit &= ~unknown;
  m_shows &= ~unknown;
}

/// light_colour() of an uneven light.
void PlainLights::find_colours(const Light& light, const LightAnswers& answers) {
  for (std::uint64_t left = m_lit; left != 0; left &= left - 1) {
    const auto place = static_cast<std::size_t>(__builtin_ctzll(left));
    if (!LightAnswers::has_ray(answers.at(place))) continue;
    const Rgb colour =
        light_colour(light, m_lights.points().point_at(place), ray_at(answers, place));
    if (is_dark(colour)) {
      m_unlit |= std::uint64_t{1} << place;
    } else {
      set_colour(place, colour);
    }
  }
}

bool PlainLights::may_show(const Light& light, const LightAnswers& answers,
                           std::size_t place) const {
  if (m_diffuse >> place & 1) return true;
  const Rgb colour = colour_at(light, place);
  const Vec3 eye{m_eye[0][place], m_eye[1][place], m_eye[2][place]};
  for (std::size_t d = 0; d < m_deepest; ++d) {
    if ((m_depths[d].shining >> place & 1) == 0) continue;
    const Layer& layer = *m_depths[d].layer[place];
    if (may_shine(*layer.finish,
                  {answers.direction_at(place), eye, layer.normal, colour, layer.pigment})) {
      return true;
    }
  }
  return false;
}

void PlainLights::filter(const Light& light, std::size_t place, const Rgb& left) {
  Rgb colour = colour_at(light, place);
  colour *= left;
  if (is_dark(colour)) m_dark |= std::uint64_t{1} << place;
  set_colour(place, colour);
}

LENTRAY_AVX2 void PlainLights::add_light(std::uint32_t light, const LightAnswers& answers) {
  const Rgb& colour = m_context.scene.lights()[light].colour;
  ShadowCounts& counts = m_context.counters.lights[light];
  const int count = static_cast<int>(m_count);
  for (int first = 0; first < count; first += 4) {
    Lanes(*this, answers, colour, counts, first).add();
  }
}

}  // namespace lentray::core
