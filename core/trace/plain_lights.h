// The light that lights make of plain layers (core/trace/layer.h) at the places of a block, four places at a
// time, light after light, in the order of operations of SurfaceShading::lit(). The layers of a place are lit by what
// arrives there once.
// World space; colours linear. One a thread. Needs AVX2 (core/base/processor.h).
// Test: tests/unit/trace/ray_waves_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/trace/block_lights.h"
#include "core/trace/layer.h"

namespace lentray::core {

class PlainLights {
 public:
  static constexpr std::size_t kMost = BlockLights::kMost;
  static constexpr std::size_t kMostLayers = 4;

  PlainLights(ThreadContext& context, ShadowTester& shadows, const BlockLights& lights);
  /// False: there are lights of other kinds; nothing else may be asked.
  bool works() const { return m_works; }

  void clear() {
    m_count = m_deepest = 0;
    m_known = m_lit = m_shows = m_diffuse = 0;
  }
  /// The next place, with its layers from the top, which stay there; none: it is not lit here. `eye`: the direction of
  /// the ray that looks.
  void add(Layers layers, const Vec3& eye);
  /// Once the block's lights are found. `filters(light, place)`: what filters leave of the light there.
  template <class Filters>
  void light(const Filters& filters) {
    drop_unknown();
    for (const std::uint32_t i : m_context.scene.global_lights()) {
      const Light& light = m_context.scene.lights()[i];
      const LightAnswers& answers = *m_lights.of(i);
      m_own_colour = m_dark = m_unlit = m_counted = 0;
      if (!is_even(light)) {
        find_colours(light, answers);
      } else if (is_dark(light.colour)) {
        continue;
      }
      for (std::uint64_t left = answers.filtered & m_shows & ~m_unlit; left != 0;
           left &= left - 1) {
        const auto place = static_cast<std::size_t>(__builtin_ctzll(left));
        if (may_show(light, answers, place)) {
          filter(light, place, filters(i, place));
        } else {
          m_dark |= std::uint64_t{1} << place;
        }
      }
      add_light(i, answers);
    }
  }
  /// False: something there was not known, and the place is not lit.
  bool is_known(std::size_t place) const { return m_known >> place & 1; }
  /// Of all lights, on one of the place's layers.
  Rgb sum(std::size_t place, std::size_t layer) const {
    const Depth& at = m_depths[layer];
    return {at.sum[0][place], at.sum[1][place], at.sum[2][place]};
  }

 private:
  /// A layer of each place, as deep below the top.
  struct Depth {
    // Bits of places.
    std::uint64_t lit = 0, shining = 0;
    std::uint64_t uneven = 0;  ///< with a brilliance
    std::array<const Layer*, kMost> layer;
    alignas(32) double normal[3][kMost] = {}, diffuse[kMost] = {};
    alignas(16) float pigment[3][kMost] = {}, sum[3][kMost] = {};
    void clear() { lit = shining = uneven = 0; }
  };
  class Lanes;
  void drop_unknown();
  void find_colours(const Light& light, const LightAnswers& answers);
  /// False: whatever filters leave of the light changes nothing there.
  bool may_show(const Light& light, const LightAnswers& answers, std::size_t place) const;
  void filter(const Light& light, std::size_t place, const Rgb& left);
  Rgb colour_at(const Light& light, std::size_t place) const {
    if ((m_own_colour >> place & 1) == 0) return light.colour;
    return {m_colour[0][place], m_colour[1][place], m_colour[2][place]};
  }
  void add_light(std::uint32_t light, const LightAnswers& answers);
  void set_colour(std::size_t place, const Rgb& colour) {
    m_own_colour |= std::uint64_t{1} << place;
    for (int c = 0; c < 3; ++c) m_colour[c][place] = colour[c];
  }

  ThreadContext& m_context;
  const BlockLights& m_lights;
  bool m_works = false, m_counts_hits = false;
  std::size_t m_count = 0, m_deepest = 0;
  // Bits of places.
  std::uint64_t m_known = 0;    ///< that are lit here, or by no light
  std::uint64_t m_lit = 0;      ///< of which a layer is lit
  std::uint64_t m_shows = 0;    ///< of which a layer shows light that is not nothing
  std::uint64_t m_diffuse = 0;  ///< of which a layer has diffuse light
  std::array<Depth, kMostLayers> m_depths;
  alignas(32) double m_eye[3][kMost] = {};
  // Of the light that is added.
  std::uint64_t m_own_colour = 0;  ///< where its colour is one of m_colour
  std::uint64_t m_dark = 0;        ///< where nothing is left of it behind filters
  std::uint64_t m_unlit = 0;       ///< where it does not shine
  std::uint64_t m_counted = 0;     ///< whose ray is counted
  alignas(16) float m_colour[3][kMost] = {};
};

}  // namespace lentray::core
