#include "core/irradiance/pretrace.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace lentray::core {
namespace {

constexpr std::uint32_t kBlockSide = 32;
constexpr std::size_t kJitterCycle = 2047;

}  // namespace

std::vector<PixelBlock> pixel_blocks(std::uint32_t width, std::uint32_t height) {
  std::vector<PixelBlock> blocks;
  for (std::uint32_t top = 0; top < height; top += kBlockSide) {
    for (std::uint32_t left = 0; left < width; left += kBlockSide) {
      blocks.push_back(
          {left, top, std::min(left + kBlockSide, width), std::min(top + kBlockSide, height)});
    }
  }
  return blocks;
}

std::vector<PretraceLevel> pretrace_levels(const RadiositySettings& settings, std::uint32_t width,
                                           std::uint32_t height) {
  constexpr double kRounding = 1e-10;
  constexpr int kMostLevels = 125;
  const double side = std::max(width, height);
  double start = side * settings.pretrace_start;
  const double end = std::max(1.0, side * settings.pretrace_end);
  int count =
      static_cast<int>(std::floor(std::log(start / end) / std::log(2.0) + (1.0 - kRounding))) + 1;
  if (count > kMostLevels) {
    count = kMostLevels;
    start = std::ldexp(end, count);
  }
  std::vector<PretraceLevel> levels;
  const auto spacing = [&](int i) { return std::max(std::ldexp(start, -i), end); };
  for (int i = 0; i < count; ++i) levels.push_back({i, spacing(i), spacing(i + 1)});
  return levels;
}

std::vector<PretraceBlock> pretrace_blocks(std::uint32_t width, std::uint32_t height) {
  std::vector<PretraceBlock> blocks;
  for (const PixelBlock& pixels : pixel_blocks(width, height)) {
    blocks.push_back({pixels, blocks.size()});
  }
  return blocks;
}

JitterCycle::JitterCycle() {
  std::mt19937 random;  // its standard seed
  m_numbers.reserve(kJitterCycle);
  for (std::size_t i = 0; i < kJitterCycle; ++i) {
    m_numbers.push_back(static_cast<double>(random()) * 0x1.0p-31 - 1.0);
  }
}

JitterRun::JitterRun(const JitterCycle& cycle, const PretraceLevel& level,
                     const PretraceBlock& block)
    : m_numbers(cycle.numbers()) {
  constexpr std::size_t kLevelStep = 17, kBlockStep = 13;
  m_at = ((static_cast<std::size_t>(level.index) + 1) * kLevelStep + block.serial * kBlockStep) %
         m_numbers.size();
}

double JitterRun::next() {
  m_at = (m_at + 1) % m_numbers.size();
  return m_numbers[m_at];
}

std::vector<PretracePlace> pretrace_places(const PretraceLevel& level, const PretraceBlock& block,
                                           const PretracePart& part, JitterRun& jitter) {
  const PixelBlock& pixels = block.pixels;
  const double spacing = level.spacing;
  const double reach = std::min(1.0, spacing / 2.0), middle = (spacing - 1.0) / 2.0;
  const auto first = [&](std::uint32_t edge) {
    return std::ceil((edge - 0.5) / spacing) * spacing;
  };
  const double width = pixels.right - pixels.left, height = pixels.bottom - pixels.top;
  const double left = pixels.left + width * part.column / block.across;
  const double top = pixels.top + height * part.row / block.down;
  const double right = left + width / block.across, bottom = top + height / block.down;
  std::vector<PretracePlace> places;
  for (double y = first(pixels.top); y < bottom; y += spacing) {
    if (y < top) continue;
    for (double x = first(pixels.left); x < right; x += spacing) {
      if (x < left) continue;
      const double row = y + middle + reach * jitter.next();
      const double column = x + middle + reach * jitter.next();
      places.push_back({column + 0.5, row + 0.5});
    }
  }
  return places;
}

bool goes_on(const PartFindings& found, int enough) {
  constexpr std::size_t kFew = 9;  ///< places that tell nothing
  if (found.places < kFew) return true;
  if (found.queries == 0) return false;
  return enough == 0 || found.samples / static_cast<double>(found.queries) < enough;
}

void end_level(PretraceBlock& block, const PretraceLevel& level,
               const std::vector<PretracePart>& wanted, int enough) {
  constexpr double kSide = 4.0;  ///< places along a part's side, at least
  const auto cuts = [&](std::uint32_t pixels, std::uint32_t parts) {
    const double places = std::floor((pixels + level.next - 1.0) / level.next);
    return enough == 0 ? 1u : std::max(1u, static_cast<std::uint32_t>(places / (parts * kSide)));
  };
  const std::uint32_t across = cuts(block.pixels.right - block.pixels.left, block.across);
  const std::uint32_t down = cuts(block.pixels.bottom - block.pixels.top, block.down);
  block.parts.clear();
  for (const PretracePart& part : wanted) {
    for (std::uint32_t row = 0; row < down; ++row) {
      for (std::uint32_t column = 0; column < across; ++column) {
        block.parts.push_back({part.column * across + column, part.row * down + row});
      }
    }
  }
  block.across *= across;
  block.down *= down;
}

}  // namespace lentray::core
