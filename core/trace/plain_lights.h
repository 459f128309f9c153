// The light that lights make of plain textures (core/trace/plain_texture.h) at the places of a block, four at a time,
// light after light, in the order of operations of SurfaceShading::lit(). World space; colours linear. One a thread.
// Needs AVX2 (core/base/processor.h). Test: tests/unit/trace/ray_waves_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/trace/block_lights.h"
#include "core/trace/plain_texture.h"

namespace lentray::core {

class PlainLights {
 public:
  static constexpr std::size_t kMost = BlockLights::kMost;

  PlainLights(ThreadContext& context, ShadowTester& shadows, const BlockLights& lights);
  /// False: there are lights of other kinds; nothing else may be asked.
  bool works() const { return m_works; }

  void clear() {
    m_count = 0;
    m_lit = m_shining = 0;
  }
  /// The next place; `eye`: the direction of the ray that looks. Null: it is not lit here.
  void add(const PlainTexture* texture, const Vec3& eye) {
    const std::size_t at = m_count++;
    if (!texture) return;
    m_lit |= std::uint64_t{1} << at;
    m_shining |= std::uint64_t{texture->shines} << at;
    m_texture[at] = texture;
    m_diffuse[at] = texture->diffuse;
    for (int c = 0; c < 3; ++c) {
      m_eye[c][at] = eye[c];
      m_pigment[c][at] = texture->pigment[c];
      m_sum[c][at] = 0.0f;
    }
  }
  void add_none() { ++m_count; }
  /// Once the block's lights are found. `filters(light, place)`: what filters leave of the light there.
  template <class Filters>
  void light(const Filters& filters) {
    drop_unknown();
    for (const std::uint32_t i : m_context.scene.global_lights()) {
      const LightAnswers& answers = *m_lights.of(i);
      for (std::uint64_t left = answers.filtered & m_lit; left != 0; left &= left - 1) {
        const auto place = static_cast<std::size_t>(__builtin_ctzll(left));
        m_filter[place] = filters(i, place);
      }
      add_light(i, answers);
    }
  }
  /// Null: something there was not known, and the place is not lit.
  const PlainTexture* texture(std::size_t place) const {
    return m_lit >> place & 1 ? m_texture[place] : nullptr;
  }
  /// Of all lights.
  Rgb sum(std::size_t place) const { return {m_sum[0][place], m_sum[1][place], m_sum[2][place]}; }

 private:
  class Lanes;
  void drop_unknown();
  void add_light(std::uint32_t light, const LightAnswers& answers);

  ThreadContext& m_context;
  const BlockLights& m_lights;
  bool m_works = false, m_counts_hits = false;
  std::size_t m_count = 0;
  std::uint64_t m_lit = 0, m_shining = 0;  ///< bits of places
  std::array<const PlainTexture*, kMost> m_texture;
  std::array<Rgb, kMost> m_filter;
  alignas(32) double m_eye[3][kMost] = {}, m_diffuse[kMost] = {};
  alignas(16) float m_pigment[3][kMost] = {}, m_sum[3][kMost] = {};
};

}  // namespace lentray::core
