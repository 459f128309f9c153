// Where a picture is looked at before it is made, coarse places first, so that the samples that lie there
// serve all of it. Pixels; (0, 0) is the corner of the picture at the upper left. Pure functions.
// Source: reference manual 3.7, "pretrace_start"; places, jitter and order are those of stock's samples
// (tests/unit/irradiance/irradiance_test.cpp). The numbers of the jitter are Matsumoto and Nishimura's MT19937, 1998.
#pragma once

#include <cstdint>
#include <vector>

#include "core/irradiance/settings.h"

namespace lentray::core {

/// A block of pixels; `right` and `bottom` are beyond it.
struct PixelBlock {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;
};
/// Of a picture, row by row.
std::vector<PixelBlock> pixel_blocks(std::uint32_t width, std::uint32_t height);

struct PretraceLevel {
  int index = 0;         ///< from 0
  double spacing = 1.0;  ///< of its places
  double next = 1.0;     ///< of the level behind it, if there were one
};
std::vector<PretraceLevel> pretrace_levels(const RadiositySettings& settings, std::uint32_t width,
                                           std::uint32_t height);

struct PretracePlace {
  double column = 0.0, row = 0.0;  ///< the centre of pixel i is i + 0.5
};

/// A part of a block that is looked at: of a grid of parts.
struct PretracePart {
  std::uint32_t column = 0, row = 0;
};
/// A block with what of it the next level samples.
struct PretraceBlock {
  PixelBlock pixels;
  std::size_t number = 0;              ///< among the picture's blocks
  std::uint32_t across = 1, down = 1;  ///< parts
  std::vector<PretracePart> parts{{}};
};
std::vector<PretraceBlock> pretrace_blocks(std::uint32_t width, std::uint32_t height);

/// Numbers in [-1, 1), in a cycle.
class JitterCycle {
 public:
  JitterCycle();
  const std::vector<double>& numbers() const { return m_numbers; }

 private:
  std::vector<double> m_numbers;
};
/// Those of a block on a level.
class JitterRun {
 public:
  JitterRun(const JitterCycle& cycle, const PretraceLevel& level, const PretraceBlock& block);
  double next();

 private:
  const std::vector<double>& m_numbers;
  std::size_t m_at;
};

/// The places of a part, in order.
std::vector<PretracePlace> pretrace_places(const PretraceLevel& level, const PretraceBlock& block,
                                           const PretracePart& part, JitterRun& jitter);

/// What was found at the places of a part.
struct PartFindings {
  std::size_t places = 0;
  std::uint64_t queries = 0;
  double samples = 0.0;  ///< that could be used again, in all queries
};
/// Whether the next level samples it too. `enough` samples a query: it need not; 0: they never are.
bool goes_on(const PartFindings& found, int enough);

/// Ends a level: `wanted` parts (some of the block's) remain, where `enough` is not 0 cut finer.
void end_level(PretraceBlock& block, const PretraceLevel& level,
               const std::vector<PretracePart>& wanted, int enough);

}  // namespace lentray::core
