#include "tools/lentray-chart/chart.h"

#include <algorithm>
#include <iterator>

#include "core/base/formed.h"
#include "tools/common/repeats.h"

namespace lentray::chart {

namespace {

/// In the order of Kind.
constexpr const char* kKindNames[] = {"lens_model", "antialiasing", "area_light", "focal_blur",
                                      "media",      "radiosity",    "photons",    "subsurface",
                                      "depth",      "quality",      "combined",   "exact"};
static_assert(std::size(kKindNames) == std::size(kKinds));

}  // namespace

const char* name_of(Kind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::optional<Kind> kind_named(std::string_view name) {
  const auto* const at =
      std::ranges::find(kKinds, name, [](Kind kind) { return std::string_view(name_of(kind)); });
  return at == std::end(kKinds) ? std::nullopt : std::optional(*at);
}

const char* name_of(State state) {
  return state == State::done ? "done" : state == State::failed ? "failed" : "waiting";
}

std::string error_text(double rms) { return core::formed("%.3g/255", rms); }

double Point::seconds() const { return tool::median_of(cpu_s); }
double Point::least() const { return cpu_s.empty() ? 0.0 : std::ranges::min(cpu_s); }
double Point::most() const { return cpu_s.empty() ? 0.0 : std::ranges::max(cpu_s); }

}  // namespace lentray::chart
