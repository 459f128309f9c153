// What media leave of light that goes along a ray, whatever they send out themselves. For shadow rays.
// World space; colours linear. One a thread.
#pragma once

#include <vector>

#include "core/base/segment.h"
#include "core/material/medium.h"
#include "core/trace/interior_table.h"
#include "core/trace/media_sampling.h"

namespace lentray::core {

/// Media that fill one place together.
using MediaList = std::vector<const Medium*>;

/// Those of the interiors, outermost first; none where they are not all hollow.
void find_media(const InteriorTable& table, InteriorsId inside, MediaList& list);
/// Of these, the one whose sampling settings hold for all: with the most intervals, the first of such.
const Medium& leading(const MediaList& list);
double least_aa_threshold(const MediaList& list);

class MediaAttenuation {
 public:
  /// The same for the same way, whatever was asked before.
  Rgb left(const MediaList& media, const Segment& way);

 private:
  std::vector<RayPart> m_lit;  ///< stays empty
  IntervalCutter m_cutter;
  std::vector<MediaInterval> m_intervals;
};

}  // namespace lentray::core
