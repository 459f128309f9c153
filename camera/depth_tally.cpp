#include "camera/depth_tally.h"

#include <algorithm>
#include <utility>

#include "camera/parallax.h"

namespace lentray::camera {

DepthTally::DepthTally(const Lenticular& sheet)
    : m_sheet(sheet), m_bends(column_bends(sheet.sheet())) {}

void DepthTally::add(const SheetLook& look) {
  ++m_out.rays;
  if (!look.hit) return;
  extend(look.point, m_bends[static_cast<std::size_t>(look.column)],
         m_gathered[index_of(*look.hit)]);
}

void DepthTally::count(const SheetLook& look) {
  add(look);
  if (look.is_dark) return;
  ++m_counted;
  if (look.hit) {
    ++m_gathered[index_of(*look.hit)].pixels;
    m_depths.push_back(look.point.depth);
  } else {
    ++m_open;
  }
}

void DepthTally::extend(const PlanPoint& point, double bend, Gathered& gathered) {
  SeenObject& object = gathered.object;
  object.nearest = std::min(object.nearest, point.depth);
  object.farthest = std::max(object.farthest, point.depth);
  const double step = parallax_rule(m_sheet, bend).at(point.depth / m_sheet.scale());
  m_out.least_step = std::min(m_out.least_step, step);
  m_out.most_step = std::max(m_out.most_step, step);
  m_out.nearest = std::min(m_out.nearest, point.depth);
  m_out.farthest = std::max(m_out.farthest, point.depth);
  object.outline.push_back(point);
  if (object.outline.size() < gathered.crowd) return;
  object.outline = convex_outline(std::move(object.outline));
  // A round thing's points may all be corners: the next time is when there are twice as many.
  gathered.crowd = std::max(gathered.crowd, 2 * object.outline.size());
}

std::size_t DepthTally::index_of(const ProbeHit& hit) {
  const auto [at, is_new] = m_by_id.try_emplace(hit.id, 0);
  if (!is_new && hit.id) return at->second;
  const std::string name = hit.name();
  const auto [named, is_first] = m_by_name.try_emplace(name, m_gathered.size());
  if (is_first) {
    m_gathered.emplace_back();
    m_gathered.back().object.name = name;
  }
  return at->second = named->second;
}

DepthSurvey DepthTally::survey() {
  if (m_counted == 0) return std::move(m_out);
  const auto all = static_cast<double>(m_counted);
  m_out.background = static_cast<double>(m_open) / all;
  for (Gathered& g : m_gathered) {
    g.object.share = static_cast<double>(g.pixels) / all;
    g.object.outline = convex_outline(std::move(g.object.outline));
    m_out.objects.push_back(std::move(g.object));
  }
  std::ranges::stable_sort(m_out.objects, {}, &SeenObject::nearest);
  if (m_depths.empty()) return std::move(m_out);
  constexpr std::size_t kPart = 20;
  std::ranges::sort(m_depths);
  m_out.near_part = m_depths[m_depths.size() / kPart];
  m_out.far_part = m_depths[m_depths.size() - 1 - m_depths.size() / kPart];
  return std::move(m_out);
}

namespace {

/// Twice the area of the triangle, positive to the left.
double turn_of(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
  return (b.x - a.x) * (c.depth - a.depth) - (b.depth - a.depth) * (c.x - a.x);
}

}  // namespace

// Andrew's monotone chain.
std::vector<PlanPoint> convex_outline(std::vector<PlanPoint> points) {
  std::ranges::sort(points, [](const PlanPoint& a, const PlanPoint& b) {
    return a.x < b.x || (a.x == b.x && a.depth < b.depth);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<PlanPoint> out;
  for (const int side : {0, 1}) {
    const std::size_t first = out.size();
    for (const PlanPoint& p : points) {
      while (out.size() >= first + 2 && turn_of(out[out.size() - 2], out.back(), p) <= 0.0) {
        out.pop_back();
      }
      out.push_back(p);
    }
    out.pop_back();  // the next side begins with it
    if (side == 0) std::ranges::reverse(points);
  }
  return out;
}

}  // namespace lentray::camera
