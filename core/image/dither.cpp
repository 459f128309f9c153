#include "core/image/dither.h"

#include <utility>

namespace lentray::core {
namespace {

// Ranks of the cells, by column and row.
constexpr float kBayer2[2][2] = {{1, 3}, {4, 2}};
constexpr float kBayer3[3][3] = {{3, 7, 4}, {6, 1, 9}, {2, 8, 5}};
constexpr float kBayer4[4][4] = {{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}};

template <std::size_t N>
float bayer(const float (&ranks)[N][N], std::uint32_t x, std::uint32_t y) {
  return ranks[x % N][y % N] / static_cast<float>(N * N) - 0.5f;
}

void add(Channels& to, const Channels& error, float share) {
  for (std::size_t c = 0; c < to.size(); ++c) to[c] += error[c] * share;
}

}  // namespace

Dither::Dither(DitherMethod method, std::uint32_t width) : m_method(method) {
  if (method != DitherMethod::plane && method != DitherMethod::floyd_steinberg) return;
  m_this.resize(std::size_t{width} + 2);
  m_next.resize(std::size_t{width} + 2);
}

Dither::Offset Dither::offset(std::uint32_t x, std::uint32_t y) const {
  switch (m_method) {
    case DitherMethod::none: break;
    case DitherMethod::bayer2: return {{}, bayer(kBayer2, x, y)};
    case DitherMethod::bayer3: return {{}, bayer(kBayer3, x, y)};
    case DitherMethod::bayer4: return {{}, bayer(kBayer4, x, y)};
    case DitherMethod::line: return {m_last, 0.0f};
    // The first pixel of a row still reads the row above: lacks() turns to the next row.
    case DitherMethod::plane:
    case DitherMethod::floyd_steinberg: return {m_this[x + 1], 0.0f};
  }
  return {};
}

void Dither::next_row() {
  std::swap(m_this, m_next);
  m_next.assign(m_next.size(), {});
}

void Dither::lacks(std::uint32_t x, const Channels& error) {
  if (m_method == DitherMethod::line) m_last = error;
  if (m_this.empty()) return;
  if (x == 0) next_row();
  if (m_method == DitherMethod::plane) {
    add(m_this[x + 2], error, 2 / 4.0f);
    add(m_next[x + 1], error, 1 / 4.0f);
    add(m_next[x + 2], error, 1 / 4.0f);
  } else {
    add(m_this[x + 2], error, 7 / 16.0f);
    add(m_next[x], error, 3 / 16.0f);
    add(m_next[x + 1], error, 5 / 16.0f);
    add(m_next[x + 2], error, 1 / 16.0f);
  }
}

}  // namespace lentray::core
