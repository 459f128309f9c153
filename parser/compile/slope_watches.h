// What watches the isosurfaces of a scene that is built: all copies of a statement share one watch.
// One thread.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/numeric/slope_watch.h"
#include "parser/descriptions/object.h"
#include "parser/source/diagnostics.h"

namespace lentray::parser {

/// The slopes that the copies of an isosurface see, and what a warning about its statement begins
/// with ("scene.pov:5:1: warning: ").
struct WatchedSlope {
  std::string heading;
  std::shared_ptr<const core::SlopeWatch> watch;
};

class SlopeWatches {
 public:
  /// Null where `evaluate` looks for the gradient itself.
  std::shared_ptr<core::SlopeWatch> of(const IsosurfaceShape& surface, const Location& where) {
    if (surface.evaluate) return nullptr;
    auto& watch = m_watches[{where.file, where.offset, surface.max_gradient}];
    if (!watch) watch = std::make_shared<core::SlopeWatch>(surface.max_gradient);
    return watch;
  }

  /// In the order of their statements.
  std::vector<WatchedSlope> named(const Diagnostics& diagnostics) const {
    std::vector<WatchedSlope> all;
    for (const auto& [key, watch] : m_watches) {
      all.push_back(
          {diagnostics.heading({std::get<0>(key), std::get<1>(key)}, "warning").before, watch});
    }
    return all;
  }

 private:
  std::map<std::tuple<std::uint32_t, std::uint32_t, double>, std::shared_ptr<core::SlopeWatch>>
      m_watches;
};

}  // namespace lentray::parser
