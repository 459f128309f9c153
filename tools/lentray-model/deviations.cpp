#include "tools/lentray-model/deviations.h"
#include "core/base/formed.h"
#include "tools/common/csv.h"

#include <cmath>
#include <cstdio>

namespace lentray::model {

using tool::number_text;

using shadow::paper::Alpha;

namespace {

enum Number : std::size_t { kAll, kNear, kFull, kSmall, kTiny, kEdge, kElsewhere };

/// The shadow, or a lens that would see it, is not on the sheet.
bool over_the_edge(const shadow::PaperSheet& sheet, const shadow::ShadowSquare& shadow,
                   Alpha alpha) {
  const double half = 0.5 * sheet.columns().sheet_width();
  const double fan =
      shadow.distance == 0.0
          ? 0.0
          : shadow.distance * std::tan(0.5 * shadow::paper::fan_angle(sheet.lens(), alpha));
  const double low = 0.5 * sheet.height();
  return shadow.x - fan < -half || shadow.x + shadow.size + fan > half || shadow.y < -low ||
         shadow.y + shadow.size > low;
}

std::string padded(std::string text, std::size_t width, bool left = false) {
  if (text.size() >= width) return text;
  return left ? text + std::string(width - text.size(), ' ')
              : std::string(width - text.size(), ' ') + text;
}

}  // namespace

const std::vector<Region>& regions() {
  static const std::vector<Region> kRegions{
      {"all", "every point of the grid"},
      {"near", "D -> 0: a lens's rays lie within a pixel on the shadow's plane"},
      {"full", "theta >= alpha: a lens can see nothing but shadow"},
      {"small", "A < P: no two rays of a view need hit"},
      {"tiny", "A < ps: the shadow is smaller than a pixel"},
      {"edge", "a part of the shadow, or a lens that would see it, is off the sheet"},
      {"elsewhere", "none of these: theta < alpha, A >= P, within the sheet"}};
  return kRegions;
}

bool lies_in(std::size_t region, const shadow::PaperSheet& sheet,
             const shadow::ShadowSquare& shadow, Alpha alpha) {
  const double angle = shadow::paper::fan_angle(sheet.lens(), alpha);
  switch (region) {
    case kAll: return true;
    case kNear: return 2.0 * shadow.distance * std::tan(0.5 * angle) < sheet.pixel();
    case kFull: return shadow::paper::shadow_angle(shadow.size, shadow.distance) >= angle;
    case kSmall: return shadow.size < sheet.lens().pitch;
    case kTiny: return shadow.size < sheet.pixel();
    case kEdge: return over_the_edge(sheet, shadow, alpha);
    default:
      for (std::size_t other = kNear; other < kElsewhere; ++other) {
        if (lies_in(other, sheet, shadow, alpha)) return false;
      }
      return true;
  }
}

std::vector<Deviation> deviations(const Grid& grid, const Arguments& arguments,
                                  const shadow::PaperSheet& sheet) {
  std::vector<Deviation> out;
  for (const StyleGrid& style : grid.styles) {
    if (!style.style.is_ideal()) continue;  // no equation
    for (const Alpha alpha : {Alpha::kPrinted, Alpha::kRefracted}) {
      for (std::size_t region = 0; region < regions().size(); ++region) {
        Deviation d;
        d.style = style.style.name();
        d.region = regions()[region].name;
        d.alpha = alpha;
        std::size_t with_hits = 0;
        for (const Point& p : style.points) {
          if (!lies_in(region, sheet, arguments.shadow(p.a, p.d), alpha)) continue;
          const double difference =
              static_cast<double>(*p.closed(alpha)) - static_cast<double>(p.enumerated);
          ++d.points;
          if (difference == 0.0) ++d.equal;
          d.mean += difference;
          if (p.enumerated > 0) {
            ++with_hits;
            d.mean_relative += std::fabs(difference) / static_cast<double>(p.enumerated);
          }
          if (d.points == 1 || std::fabs(difference) > std::fabs(d.worst)) {
            d.worst = difference;
            d.at = p;
          }
        }
        if (d.points == 0) continue;
        d.mean /= static_cast<double>(d.points);
        if (with_hits > 0) d.mean_relative /= static_cast<double>(with_hits);
        out.push_back(d);
      }
    }
  }
  return out;
}

std::string csv_of(const std::vector<Deviation>& all) {
  std::string out =
      "style,alpha,region,points,equal,mean,mean_relative,worst,A,D,closed_form,enumerated\n";
  for (const Deviation& d : all) {
    out += d.style + "," + shadow::paper::name_of(d.alpha) + "," + d.region + "," +
           std::to_string(d.points) + "," + std::to_string(d.equal) + "," +
           core::formed("%.6g", d.mean) + "," + core::formed("%.6g", d.mean_relative) + "," +
           number_text(d.worst) + "," + number_text(d.at.a) + "," + number_text(d.at.d) + "," +
           std::to_string(*d.at.closed(d.alpha)) + "," + std::to_string(d.at.enumerated) + "\n";
  }
  return out;
}

std::string table_of(const std::vector<Deviation>& all) {
  std::string out =
      "equation minus enumeration, in rays\n"
      "style     alpha      region     points   equal       mean  relative      worst  at A, D\n";
  for (const Deviation& d : all) {
    out += padded(d.style, 10, true) + padded(shadow::paper::name_of(d.alpha), 11, true) +
           padded(d.region, 9, true) + padded(std::to_string(d.points), 8) +
           padded(std::to_string(d.equal), 8) + padded(core::formed("%.1f", d.mean), 11) +
           padded(core::formed("%.1f %%", 100.0 * d.mean_relative), 10) +
           padded(number_text(d.worst), 11) + "  " + number_text(d.at.a) + ", " +
           number_text(d.at.d) + ": " + std::to_string(*d.at.closed(d.alpha)) + " for " +
           std::to_string(d.at.enumerated) + "\n";
  }
  for (const Region& region : regions()) {
    out += padded(region.name, 10, true) + region.meaning + "\n";
  }
  return out;
}

}  // namespace lentray::model
