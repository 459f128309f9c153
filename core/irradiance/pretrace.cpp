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

/// A level follows as long as the one before it is coarser than the end.
std::vector<PretraceLevel> pretrace_levels(const RadiositySettings& settings, std::uint32_t width,
                                           std::uint32_t height) {
  constexpr double kSame = 1.0 + 7e-11;  ///< quotient of spacings that rounding alone makes
  const double side = std::max(width, height);
  const double end = std::max(1.0, side * settings.pretrace_end);
  std::vector<PretraceLevel> levels;
  double before = 2.0 * side * settings.pretrace_start;
  for (; before > end * kSame; before *= 0.5) {
    levels.push_back({static_cast<int>(levels.size()), std::max(before * 0.5, end),
                      std::max(before * 0.25, end)});
  }
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
  m_at = ((static_cast<std::size_t>(level.index) + 1) * kLevelStep + block.number * kBlockStep) %
         m_numbers.size();
}

double JitterRun::next() {
  m_at = (m_at + 1) % m_numbers.size();
  return m_numbers[m_at];
}

namespace {

/// A stretch of an axis, in pixels.
struct Stretch {
  double begin, end;
};
/// One of `parts` equal parts of the pixels from `first` up to `end`.
Stretch part_of(std::uint32_t first, std::uint32_t end, std::uint32_t part, std::uint32_t parts) {
  const double length = end - first;
  const double begin = first + length * part / parts;
  return {begin, begin + length / parts};
}

/// The multiples of the spacing in a stretch, added up from the first that belongs to the block.
std::vector<double> lattice(std::uint32_t block_begin, const Stretch& stretch, double spacing) {
  std::vector<double> all;
  double at = std::ceil((block_begin - 0.5) / spacing) * spacing;
  while (at < stretch.begin) at += spacing;
  for (; at < stretch.end; at += spacing) all.push_back(at);
  return all;
}

/// How many parts of a level's part the next one has along a side of the block.
std::uint32_t cuts(std::uint32_t pixels, std::uint32_t parts, double spacing) {
  constexpr std::uint32_t kLeastPlaces = 4;  ///< along a part's side
  const auto places = static_cast<std::uint32_t>((pixels + spacing - 1.0) / spacing);
  return std::max(1u, places / (parts * kLeastPlaces));
}

}  // namespace

std::vector<PretracePlace> pretrace_places(const PretraceLevel& level, const PretraceBlock& block,
                                           const PretracePart& part, JitterRun& jitter) {
  constexpr double kMostJitter = 1.0;
  const PixelBlock& pixels = block.pixels;
  const double spacing = level.spacing, jittered = std::min(kMostJitter, spacing / 2.0);
  const auto columns =
      lattice(pixels.left, part_of(pixels.left, pixels.right, part.column, block.across), spacing);
  const auto rows =
      lattice(pixels.top, part_of(pixels.top, pixels.bottom, part.row, block.down), spacing);
  // In the middle of the pixels from one multiple to the next.
  const auto placed = [&](double at) {
    return at + (spacing - 1.0) / 2.0 + jittered * jitter.next() + 0.5;
  };
  std::vector<PretracePlace> places;
  places.reserve(rows.size() * columns.size());
  for (const double y : rows) {
    for (const double x : columns) {
      PretracePlace& place = places.emplace_back();
      place.row = placed(y);
      place.column = placed(x);
    }
  }
  return places;
}

bool goes_on(const PartFindings& found, int enough) {
  constexpr std::size_t kFew = 9;  ///< places that are not enough to judge by
  const auto served = [&] {
    return enough > 0 && found.samples / static_cast<double>(found.queries) >= enough;
  };
  return found.places < kFew || (found.queries > 0 && !served());
}

void end_level(PretraceBlock& block, const PretraceLevel& level,
               const std::vector<PretracePart>& wanted, int enough) {
  const PixelBlock& pixels = block.pixels;
  const bool is_cut = enough > 0;
  const std::uint32_t across =
      is_cut ? cuts(pixels.right - pixels.left, block.across, level.next) : 1;
  const std::uint32_t down = is_cut ? cuts(pixels.bottom - pixels.top, block.down, level.next) : 1;
  block.parts.clear();
  for (const PretracePart& part : wanted) {
    for (std::uint32_t i = 0; i < across * down; ++i) {
      block.parts.push_back({part.column * across + i % across, part.row * down + i / across});
    }
  }
  block.across *= across;
  block.down *= down;
}

}  // namespace lentray::core
