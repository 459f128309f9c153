// The paper's test (its section 5), put to the kernel: a square facing the sheet, on it one
// rectangle of shadow. The shadow is cast by a thin box of the same size that cameras do not see,
// in light that comes straight along the sheet's normal, so the shadow's edges are its edges.
// World: mm, x to the right, y up, z into the display; the sheet in z = 0, its middle the origin.
//
// Rendered are the rows and the lenses that see the shadow, and at least one more row above and
// below and one more lens to either side where the sheet has one (all lenses if N is fractional,
// for then a lens may lack a view): all others see no shadow, and runs end in these.
// Immutable after construction; measure() may be called by any number of threads.
#pragma once

#include <memory>
#include <string>

#include "core/scene/scene.h"
#include "shadow/hit_model/enumeration.h"

namespace lentray::shadow {

struct Measurement {
  std::uint64_t continuous_hits = 0;  ///< the longest run of successive blocked shadow rays
  std::uint64_t rays = 0, blocked = 0;
  std::uint64_t cache_hits = 0;
};

class PaperTest {
 public:
  /// Both must outlive the test.
  PaperTest(const PaperSheet& sheet, const Enumeration& shadow, double distance);

  /// Renders with one thread, the pixels in the style's order. `cache`: a name of tester_names().
  /// Throws std::logic_error if a pixel that is not dark cast no shadow ray: then the square
  /// was missed, and runs would mean nothing.
  Measurement measure(const Style& style, const std::string& cache = "last") const;

 private:
  /// Columns [left, right), rows [top, bottom).
  struct Part {
    std::uint32_t left = 0, right = 0, top = 0, bottom = 0;
  };
  Part rendered(std::uint32_t group) const;

  const PaperSheet& m_sheet;
  const Enumeration& m_shadow;
  std::unique_ptr<core::Scene> m_scene;
};

}  // namespace lentray::shadow
