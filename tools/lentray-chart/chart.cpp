#include "tools/lentray-chart/chart.h"

#include <algorithm>

namespace lentray::chart {

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::lens_model: return "lens_model";
    case Kind::antialiasing: return "antialiasing";
    case Kind::area_light: return "area_light";
    case Kind::focal_blur: return "focal_blur";
    case Kind::media: return "media";
    case Kind::radiosity: return "radiosity";
    case Kind::photons: return "photons";
    case Kind::subsurface: return "subsurface";
    case Kind::depth: return "depth";
    case Kind::quality: return "quality";
    case Kind::combined: return "combined";
    case Kind::exact: break;
  }
  return "exact";
}

std::optional<Kind> kind_named(std::string_view name) {
  for (const Kind kind : {Kind::lens_model, Kind::antialiasing, Kind::area_light, Kind::focal_blur,
                          Kind::media, Kind::radiosity, Kind::photons, Kind::subsurface,
                          Kind::depth, Kind::quality, Kind::combined, Kind::exact}) {
    if (name == name_of(kind)) return kind;
  }
  return std::nullopt;
}

double Point::seconds() const {
  if (cpu_s.empty()) return 0.0;
  std::vector<double> sorted = cpu_s;
  std::ranges::sort(sorted);
  const std::size_t n = sorted.size();
  return n % 2 == 1 ? sorted[n / 2] : 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]);
}

double Point::least() const { return cpu_s.empty() ? 0.0 : std::ranges::min(cpu_s); }
double Point::most() const { return cpu_s.empty() ? 0.0 : std::ranges::max(cpu_s); }

}  // namespace lentray::chart
