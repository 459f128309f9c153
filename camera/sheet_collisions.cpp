#include "camera/sheet_collisions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "camera/text.h"

namespace lentray::camera {
namespace {

using core::Vec3;

constexpr int kLines = 24;  // across a sheet, each way

struct Crossing {
  ProbeHit hit;
  double along = 0.0;  ///< 0 .. 1 of the segment
  Vec3 point;
};

/// All surfaces on a segment, in order.
std::vector<Crossing> crossings(const SceneProbe& probe, const Vec3& from, const Vec3& to) {
  constexpr int kMost = 64;
  std::vector<Crossing> out;
  double along = 0.0;
  for (int i = 0; i < kMost; ++i) {
    const core::Ray ray{from + (to - from) * along, to - from};
    const auto hit = probe(ray, 1.0 - along);
    if (!hit || !(hit->distance > 0.0)) break;
    along += hit->distance;
    out.push_back({*hit, along, ray.at(hit->distance)});
  }
  return out;
}

/// Every surface that crosses a rectangle along a grid of lines in it.
void on_rectangle(const SceneProbe& probe, const Vec3& centre, const Vec3& across, const Vec3& down,
                  const std::function<void(const Crossing&)>& visit) {
  for (int i = 0; i < kLines; ++i) {
    const double at = (i + 0.5) / kLines - 0.5;
    const Vec3 beside = centre + across * at, below = down * at, half = down * 0.5;
    std::ranges::for_each(
        crossings(probe, centre - across * 0.5 + below, centre + across * 0.5 + below), visit);
    std::ranges::for_each(crossings(probe, beside - half, beside + half), visit);
  }
}

/// Objects, counted by name.
class ObjectList {
 public:
  void add(const ProbeHit& hit) {
    if (m_seen.insert(hit.id).second || !hit.id) ++m_counts[hit.name()];
  }
  bool has(const void* id) const { return id && m_seen.count(id) > 0; }
  bool empty() const { return m_counts.empty(); }
  /// "2 sphere at a.pov:3:5, box at a.pov:9:1"; of many the first.
  std::string text() const {
    constexpr std::size_t kMost = 8;
    std::string out;
    std::size_t told = 0;
    for (const auto& [name, count] : m_counts) {
      if (told++ == kMost) return out + " and " + std::to_string(m_counts.size() - kMost) + " more";
      out += out.empty() ? "" : ", ";
      out += (count > 1 && !m_seen.count(nullptr) ? std::to_string(count) + " " : "") + name;
    }
    return out;
  }

 private:
  std::map<std::string, int> m_counts;
  std::set<const void*> m_seen;
};

/// The slope of a view's rays through the sheet's middle; `side` -1: the first view, 1: the last.
double slope_of_view(const Lenticular& sheet, int side) {
  const LensParameters& lens = sheet.sheet().lens();
  const double outermost = lens.ior * lens.print_pitch() /
                           (2.0 * lens.focal_length * lens.slant_cosine()) *
                           (1.0 - 1.0 / lens.pixels) * sheet.depth_factor();
  return sheet.placement().eye_slope_x + side * outermost;
}

/// Where the rays of a view start that pass the sheet at a point.
Vec3 start_of(const Lenticular& sheet, int side, const Vec3& on_sheet) {
  const SheetPlacement& place = sheet.placement();
  const Vec3 middle =
      place.right * slope_of_view(sheet, side) + place.normal + place.up * place.eye_slope_y;
  const Vec3 tilt =
      sheet.has_near_eye() ? (on_sheet - place.centre) / sheet.eye_distance() : Vec3{};
  return on_sheet - (middle + tilt) * place.front;
}

/// Some of the object is what a view sees towards a point of the sheet.
bool seen_through(const Lenticular& sheet, const SceneProbe& probe, const Crossing& c) {
  for (const int side : {-1, 0, 1}) {
    const Vec3 from = start_of(sheet, side, c.point);
    const auto hit = probe({from, c.point - from}, 1.0 - 1e-6);
    if (!hit || (c.hit.id && hit->id == c.hit.id)) return true;
  }
  return false;
}

bool larger_than(const ProbeHit& hit, const SheetPlacement& place) {
  if (!hit.bounds) return true;
  const core::Bounds bounds = hit.bounds();
  if (!bounds.is_finite()) return true;
  const Vec3 size = bounds.hi - bounds.lo;
  return std::max({size.x, size.y, size.z}) > std::hypot(place.width, place.height);
}

void look_through_sheet(const Lenticular& sheet, const SceneProbe& probe, Collisions& out) {
  const SheetPlacement& place = sheet.placement();
  ObjectList cut, scenery;
  std::map<const void*, bool> is_large;
  on_rectangle(probe, place.centre, place.right * place.width, place.up * place.height,
               [&](const Crossing& c) {
                 const auto [large, is_new] = is_large.try_emplace(c.hit.id);
                 if (is_new || !c.hit.id) large->second = larger_than(c.hit, place);
                 ObjectList& list = large->second ? scenery : cut;
                 if (!list.has(c.hit.id) && seen_through(sheet, probe, c)) list.add(c.hit);
               });
  if (!scenery.empty()) {
    out.notes.push_back("Larger than the sheet and running through it, as floors do: " +
                        scenery.text());
  }
  if (!cut.empty()) {
    out.warnings.push_back("the lens sheet cuts an object (" + cut.text() +
                           "): it will show partly before and partly behind the sheet");
  }
}

/// "views 0 to 3"; nothing when no view's eye is that far from the middle one's.
std::string views_beyond(const Lenticular& sheet, int side, double part) {
  const std::uint32_t views = sheet.sheet().views();
  std::optional<std::uint32_t> first, last;
  for (std::uint32_t j = 0; j < views; ++j) {
    const double at = views > 1 ? (2.0 * j - (views - 1.0)) / (views - 1.0) * side : 0.0;
    if (at < part) continue;
    if (!first) first = j;
    last = j;
  }
  if (!first) return {};
  if (*first == *last) return "view " + std::to_string(*first);
  return "views " + std::to_string(*first) + " to " + std::to_string(*last);
}

/// Rays start at the eyes: their way from the middle to either side.
void follow_eyes(const Lenticular& sheet, const SceneProbe& probe, Collisions& out) {
  const Vec3 middle = start_of(sheet, 0, sheet.placement().centre);
  ObjectList met;
  std::string beyond;
  double free = 1.0;  // of the way to the outermost eyes
  for (const int side : {-1, 1}) {
    const Vec3 end = start_of(sheet, side, sheet.placement().centre);
    const auto found = crossings(probe, middle, end);
    if (found.empty()) continue;
    for (const Crossing& c : found) met.add(c.hit);
    free = std::min(free, found.front().along);
    const std::string views = views_beyond(sheet, side, found.front().along);
    if (!views.empty()) beyond += (beyond.empty() ? "" : ", ") + views;
  }
  if (met.empty()) return;
  const double reach = core::length(start_of(sheet, 1, sheet.placement().centre) - middle);
  out.warnings.push_back("cut: the eyes of the views, up to " + format(reach) +
                         " scene units to either side of the camera, run into an object (" +
                         met.text() + ")" +
                         (beyond.empty() ? "" : ": seen from inside or behind it: " + beyond) +
                         "; " + brief(100.0 * free) + " % of the depth would avoid it");
}

/// Rays start in a plane: what it cuts shows its inside.
void look_through_start(const Lenticular& sheet, const SceneProbe& probe, Collisions& out) {
  const SheetPlacement& place = sheet.placement();
  const double distance = sheet.eye_distance();
  const double shrunk = 1.0 - place.front / distance;  // 1 when V is infinite
  ObjectList met;
  for (const int side : {-1, 0, 1}) {
    on_rectangle(probe, start_of(sheet, side, place.centre), place.right * (place.width * shrunk),
                 place.up * (place.height * shrunk), [&](const Crossing& c) { met.add(c.hit); });
  }
  if (met.empty()) return;
  out.warnings.push_back("cut: the plane where rays start, " + format(place.front) +
                         " scene units before the sheet (Lens_Front), cuts an object (" +
                         met.text() + "): some rays start inside or behind it");
}

}  // namespace

Collisions collisions_of(const Lenticular& sheet, const SceneProbe& probe) {
  Collisions out;
  if (!probe) return out;
  const SheetPlacement& place = sheet.placement();
  const double distance = sheet.eye_distance();
  // What lies in the plane of a composed sheet is there on purpose.
  if (place.front > 0.0 && !place.eye) look_through_sheet(sheet, probe, out);
  if (std::isfinite(distance) && std::fabs(place.front - distance) <= 1e-9 * distance) {
    follow_eyes(sheet, probe, out);
  } else {
    look_through_start(sheet, probe, out);
  }
  return out;
}

}  // namespace lentray::camera
