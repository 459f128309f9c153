#include "camera/depth_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "camera/parallax.h"

namespace lentray::camera {
namespace {

/// A pixel of the sheet by its lens, its row and its view.
struct SheetPixel {
  std::int64_t lens = 0, row = 0, view = 0;
};

struct Looked {
  SheetPixel pixel;
  double depth = 0.0;
};

/// Which pixels of a large sheet are looked at: every so many lenses, rows and views.
struct SurveyGrid {
  std::int64_t lenses = 1, rows = 1, views = 1;
};

class Surveyor {
 public:
  Surveyor(const Lenticular& sheet, const SceneProbe& probe, std::uint64_t most_rays)
      : m_sheet(sheet), m_probe(probe), m_most(most_rays), m_views(usual_views(sheet.sheet())),
        m_lenses(sheet.sheet().lens_count()), m_bends(column_bends(sheet.sheet())) {}

  DepthSurvey run() {
    const std::uint64_t pixels = std::uint64_t{m_sheet.width()} * m_sheet.height();
    m_out.is_whole = pixels / 2 <= m_most;
    if (m_out.is_whole) {
      for (std::uint32_t row = 0; row < m_sheet.height(); ++row) {
        for (std::uint32_t k = 0; k < m_sheet.width(); ++k) count(look(k, row));
      }
    } else {
      look_at_grid();
    }
    finish();
    return std::move(m_out);
  }

 private:
  static constexpr std::int64_t kViewsOfGrid = 9;
  static constexpr std::size_t kSearches = 64;

  struct Met {
    bool is_dark = false;
    std::optional<double> depth{};
    std::size_t object = 0;
  };
  struct Gathered {
    SeenObject object;
    std::uint64_t pixels = 0;
  };

  /// A pixel's first surface, which extends what is known of its object.
  Met look(std::int64_t column, std::int64_t row) {
    core::Ray ray;
    ++m_out.rays;
    if (!m_sheet.ray(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5, ray)) {
      return {true};
    }
    const auto hit = m_probe(ray, core::Bounds::kInf);
    if (!hit) return {};
    const SheetPlacement& place = m_sheet.placement();
    const core::Vec3 from_middle = ray.at(hit->distance) - place.centre;
    const PlanPoint point{core::dot(from_middle, place.right),
                          core::dot(from_middle, place.normal)};
    const std::size_t index = index_of(*hit);
    add(point, m_bends[static_cast<std::size_t>(column)], m_gathered[index].object);
    return {false, point.depth, index};
  }

  void add(const PlanPoint& point, double bend, SeenObject& object) {
    constexpr std::size_t kMostPoints = 512;
    object.nearest = std::min(object.nearest, point.depth);
    object.farthest = std::max(object.farthest, point.depth);
    const double step = parallax_at_bend(m_sheet, point.depth, bend);
    m_out.least_step = std::min(m_out.least_step, step);
    m_out.most_step = std::max(m_out.most_step, step);
    m_out.nearest = std::min(m_out.nearest, point.depth);
    m_out.farthest = std::max(m_out.farthest, point.depth);
    object.outline.push_back(point);
    if (object.outline.size() >= kMostPoints) object.outline = convex_outline(object.outline);
  }

  std::size_t index_of(const ProbeHit& hit) {
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

  void count(const Met& met) {
    if (met.is_dark) return;
    ++m_counted;
    if (met.depth) {
      ++m_gathered[met.object].pixels;
      m_depths.push_back(*met.depth);
    } else {
      ++m_open;
    }
  }

  bool has(const SheetPixel& p) const {
    return p.lens >= 0 && p.lens < m_lenses && p.row >= 0 && p.row < m_sheet.height() &&
           p.view >= 0 && p.view < m_views && column_of(p) < m_sheet.width();
  }
  std::int64_t column_of(const SheetPixel& p) const {
    return view_column(m_sheet.sheet().lens().pixels, static_cast<std::uint32_t>(p.view),
                       static_cast<std::uint32_t>(m_views), p.lens);
  }

  /// As far apart across as downwards, in the scene.
  SurveyGrid grid() const {
    SurveyGrid out;
    const std::int64_t views = std::min(m_views, kViewsOfGrid);
    const double rays = static_cast<double>(m_most) / static_cast<double>(views);
    const SheetPlacement& place = m_sheet.placement();
    const double apart = std::sqrt(place.width * place.height / rays);
    const double lens = place.width / m_sheet.sheet().lenses();
    const auto whole = [](double steps) {
      return std::max<std::int64_t>(1, std::llround(std::min(steps, 1e9)));
    };
    out.lenses = whole(apart / lens);
    const double columns =
        std::ceil(static_cast<double>(m_lenses) / static_cast<double>(out.lenses));
    out.rows = whole(std::ceil(m_sheet.height() * columns / rays));
    out.views = views > 1 ? (m_views - 1) / (views - 1) : 1;
    return out;
  }

  /// The first and the last view, and some between them.
  std::vector<std::int64_t> views_of_grid() const {
    const std::int64_t count = std::min(m_views, kViewsOfGrid);
    std::vector<std::int64_t> out;
    for (std::int64_t i = 0; i < count; ++i) {
      out.push_back(count > 1 ? i * (m_views - 1) / (count - 1) : 0);
    }
    return out;
  }

  void look_at_grid() {
    const SurveyGrid step = grid();
    // The best of each block of the grid, so that searches begin all over the picture.
    constexpr std::int64_t kBlock = 8;
    std::map<std::pair<std::int64_t, std::int64_t>, std::array<Looked, 2>> best;
    const std::vector<std::int64_t> views = views_of_grid();
    for (std::int64_t row = step.rows / 2; row < m_sheet.height(); row += step.rows) {
      for (std::int64_t lens = step.lenses / 2; lens < m_lenses; lens += step.lenses) {
        for (const std::int64_t view : views) {
          const SheetPixel pixel{lens, row, view};
          if (!has(pixel)) continue;
          const Met met = look(column_of(pixel), row);
          count(met);
          if (!met.depth) continue;
          const Looked here{pixel, *met.depth};
          const std::pair key{row / (kBlock * step.rows), lens / (kBlock * step.lenses)};
          const auto [at, is_new] = best.try_emplace(key, std::array{here, here});
          if (here.depth < at->second[0].depth) at->second[0] = here;
          if (here.depth > at->second[1].depth) at->second[1] = here;
        }
      }
    }
    for (const int side : {0, 1}) {
      const double sign = side == 0 ? 1.0 : -1.0;
      std::vector<Looked> starts;
      for (const auto& [key, two] : best) starts.push_back(two[static_cast<std::size_t>(side)]);
      std::ranges::stable_sort(starts, [sign](const Looked& a, const Looked& b) {
        return sign * a.depth < sign * b.depth;
      });
      if (starts.size() > kSearches) starts.resize(kSearches);
      for (const Looked& start : starts) search(start, step, sign);
    }
  }

  /// To nearer pixels (sign 1) or farther ones (-1), in steps that are halved where there are none.
  void search(Looked at, SurveyGrid step, double sign) {
    constexpr int kMostSteps = 200;
    for (int i = 0; i < kMostSteps; ++i) {
      const Looked next = best_beside(at, step, sign);
      if (sign * next.depth < sign * at.depth) {
        at = next;
        continue;
      }
      if (step.lenses == 1 && step.rows == 1 && step.views == 1) return;
      for (std::int64_t* size : {&step.lenses, &step.rows, &step.views}) *size = (*size + 1) / 2;
    }
  }

  Looked best_beside(const Looked& at, const SurveyGrid& step, double sign) {
    Looked best = at;
    const auto try_pixel = [&](std::int64_t across, std::int64_t down, std::int64_t turn) {
      const SheetPixel pixel{at.pixel.lens + across, at.pixel.row + down, at.pixel.view + turn};
      if (!has(pixel)) return;
      const Met met = look(column_of(pixel), pixel.row);
      if (met.depth && sign * *met.depth < sign * best.depth) best = {pixel, *met.depth};
    };
    for (const std::int64_t across : {-1, 0, 1}) {
      for (const std::int64_t down : {-1, 0, 1}) {
        if (across != 0 || down != 0) try_pixel(across * step.lenses, down * step.rows, 0);
      }
    }
    // The same point in another view lies as many lenses beside as its parallax says.
    const double lenses = parallax(m_sheet, at.depth) * static_cast<double>(step.views);
    const bool near = std::fabs(lenses) < static_cast<double>(m_lenses);
    const std::int64_t beside = near ? std::llround(lenses) : 0;
    for (const std::int64_t turn : {-1, 1}) {
      for (const std::int64_t more : {-1, 0, 1})
        try_pixel(-turn * beside + more, 0, turn * step.views);
    }
    return best;
  }

  void finish() {
    if (m_counted == 0) return;
    const auto all = static_cast<double>(m_counted);
    m_out.background = static_cast<double>(m_open) / all;
    for (Gathered& g : m_gathered) {
      g.object.share = static_cast<double>(g.pixels) / all;
      g.object.outline = convex_outline(std::move(g.object.outline));
      m_out.objects.push_back(std::move(g.object));
    }
    std::ranges::stable_sort(m_out.objects, {}, &SeenObject::nearest);
    if (m_depths.empty()) return;
    constexpr std::size_t kPart = 20;
    std::ranges::sort(m_depths);
    m_out.near_part = m_depths[m_depths.size() / kPart];
    m_out.far_part = m_depths[m_depths.size() - 1 - m_depths.size() / kPart];
  }

  const Lenticular& m_sheet;
  const SceneProbe& m_probe;
  const std::uint64_t m_most;
  const std::int64_t m_views, m_lenses;
  const std::vector<double> m_bends;  ///< by column
  DepthSurvey m_out;
  std::vector<Gathered> m_gathered;
  std::unordered_map<const void*, std::size_t> m_by_id;
  std::map<std::string, std::size_t> m_by_name;
  std::vector<double> m_depths;  ///< of the pixels that count
  std::uint64_t m_counted = 0, m_open = 0;
};

/// Twice the area of the triangle, positive to the left.
double turn_of(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
  return (b.x - a.x) * (c.depth - a.depth) - (b.depth - a.depth) * (c.x - a.x);
}

}  // namespace

DepthSurvey survey_depth(const Lenticular& sheet, const SceneProbe& probe,
                         std::uint64_t most_rays) {
  if (!probe) return {};
  return Surveyor(sheet, probe, most_rays).run();
}

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
