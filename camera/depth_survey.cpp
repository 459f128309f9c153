#include "camera/depth_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "camera/depth_tally.h"
#include "camera/parallax.h"
#include "core/pass/pass_list.h"

namespace lentray::camera {
namespace {

constexpr std::int64_t kViewsOfGrid = 9;
constexpr std::size_t kSearches = 64;  ///< to nearer pixels, and as many to farther ones

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

using Looks = std::vector<SheetLook>;

/// Looks at pixels. Any number of threads.
class SheetEye {
 public:
  SheetEye(const Lenticular& sheet, const SceneProbe& probe)
      : m_sheet(sheet), m_probe(probe), m_views(usual_views(sheet.sheet())),
        m_lenses(sheet.sheet().lens_count()) {}

  std::int64_t views() const { return m_views; }
  std::int64_t lenses() const { return m_lenses; }
  bool has(const SheetPixel& p) const {
    return p.lens >= 0 && p.lens < m_lenses && p.row >= 0 && p.row < m_sheet.height() &&
           p.view >= 0 && p.view < m_views && column_of(p) < m_sheet.width();
  }

  const SheetLook& look(std::int64_t column, std::int64_t row, Looks& out) const {
    SheetLook& at = out.emplace_back();
    at.column = column;
    core::Ray ray;
    if (!m_sheet.ray(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5, ray)) {
      at.is_dark = true;
      return at;
    }
    at.hit = m_probe(ray, core::Bounds::kInf);
    if (!at.hit) return at;
    const SheetPlacement& place = m_sheet.placement();
    const core::Vec3 from_middle = ray.at(at.hit->distance) - place.centre;
    at.point = {core::dot(from_middle, place.right), core::dot(from_middle, place.normal)};
    return at;
  }
  const SheetLook& look(const SheetPixel& p, Looks& out) const {
    return look(column_of(p), p.row, out);
  }

  /// To nearer pixels (sign 1) or farther ones (-1), in steps that are halved where there are none.
  Looks search(Looked at, SurveyGrid step, double sign) const {
    constexpr int kMostSteps = 200;
    Looks out;
    for (int i = 0; i < kMostSteps; ++i) {
      const Looked next = best_beside(at, step, sign, out);
      if (sign * next.depth < sign * at.depth) {
        at = next;
        continue;
      }
      if (step.lenses == 1 && step.rows == 1 && step.views == 1) break;
      for (std::int64_t* size : {&step.lenses, &step.rows, &step.views}) *size = (*size + 1) / 2;
    }
    return out;
  }

 private:
  std::int64_t column_of(const SheetPixel& p) const {
    return view_column(m_sheet.sheet().lens().pixels, static_cast<std::uint32_t>(p.view),
                       static_cast<std::uint32_t>(m_views), p.lens);
  }

  Looked best_beside(const Looked& at, const SurveyGrid& step, double sign, Looks& out) const {
    Looked best = at;
    const auto try_pixel = [&](std::int64_t across, std::int64_t down, std::int64_t turn) {
      const SheetPixel pixel{at.pixel.lens + across, at.pixel.row + down, at.pixel.view + turn};
      if (!has(pixel)) return;
      const SheetLook& met = look(pixel, out);
      if (met.hit && sign * met.point.depth < sign * best.depth) best = {pixel, met.point.depth};
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

  const Lenticular& m_sheet;
  const SceneProbe& m_probe;
  const std::int64_t m_views, m_lenses;
};

/// As far apart across as downwards, in the scene.
SurveyGrid grid_of(const Lenticular& sheet, const SheetEye& eye, std::uint64_t most_rays) {
  SurveyGrid out;
  const std::int64_t views = std::min(eye.views(), kViewsOfGrid);
  const double rays = static_cast<double>(most_rays) / static_cast<double>(views);
  const SheetPlacement& place = sheet.placement();
  const double apart = std::sqrt(place.width * place.height / rays);
  const double lens = place.width / sheet.sheet().lenses();
  const auto whole = [](double steps) {
    return std::max<std::int64_t>(1, std::llround(std::min(steps, 1e9)));
  };
  out.lenses = whole(apart / lens);
  const double columns =
      std::ceil(static_cast<double>(eye.lenses()) / static_cast<double>(out.lenses));
  out.rows = whole(std::ceil(sheet.height() * columns / rays));
  out.views = views > 1 ? (eye.views() - 1) / (views - 1) : 1;
  return out;
}

/// The first and the last view, and some between them.
std::vector<std::int64_t> views_of_grid(std::int64_t views) {
  const std::int64_t count = std::min(views, kViewsOfGrid);
  std::vector<std::int64_t> out;
  for (std::int64_t i = 0; i < count; ++i) {
    out.push_back(count > 1 ? i * (views - 1) / (count - 1) : 0);
  }
  return out;
}

/// The nearest and the farthest of each block of the grid, so that searches begin all over the picture.
class BestOfBlocks {
 public:
  explicit BestOfBlocks(const SurveyGrid& step) : m_step(step) {}
  void add(const Looked& here) {
    constexpr std::int64_t kBlock = 8;
    const std::pair key{here.pixel.row / (kBlock * m_step.rows),
                        here.pixel.lens / (kBlock * m_step.lenses)};
    const auto [at, is_new] = m_best.try_emplace(key, std::array{here, here});
    if (here.depth < at->second[0].depth) at->second[0] = here;
    if (here.depth > at->second[1].depth) at->second[1] = here;
  }
  /// The nearest of all (sign 1), or the farthest (-1), the best first.
  std::vector<Looked> starts(double sign) const {
    std::vector<Looked> out;
    for (const auto& [key, two] : m_best) out.push_back(two[sign > 0.0 ? 0 : 1]);
    std::ranges::stable_sort(
        out, [sign](const Looked& a, const Looked& b) { return sign * a.depth < sign * b.depth; });
    if (out.size() > kSearches) out.resize(kSearches);
    return out;
  }

 private:
  const SurveyGrid m_step;
  std::map<std::pair<std::int64_t, std::int64_t>, std::array<Looked, 2>> m_best;
};

void look_at_all(const Lenticular& sheet, const SheetEye& eye, core::PassRun& run,
                 DepthTally& tally) {
  run.in_order(
      0, sheet.height(),
      [&](unsigned, std::size_t row) {
        Looks looks;
        looks.reserve(sheet.width());
        for (std::uint32_t k = 0; k < sheet.width(); ++k)
          eye.look(k, static_cast<std::int64_t>(row), looks);
        return looks;
      },
      [&](std::size_t row, const Looks& looks) {
        for (const SheetLook& look : looks) tally.count(look);
        run.advance(static_cast<double>(row + 1) / sheet.height());
        return true;
      });
}

void look_at_grid(const Lenticular& sheet, const SheetEye& eye, std::uint64_t most_rays,
                  core::PassRun& run, DepthTally& tally) {
  constexpr double kShareOfGrid = 0.9;
  const SurveyGrid step = grid_of(sheet, eye, most_rays);
  const std::vector<std::int64_t> views = views_of_grid(eye.views());
  const std::int64_t first = step.rows / 2;
  const auto rows = static_cast<std::size_t>(
      std::max<std::int64_t>(0, (sheet.height() - first + step.rows - 1) / step.rows));
  const auto pixels_of = [&](std::size_t job, const auto& visit) {
    const std::int64_t row = first + static_cast<std::int64_t>(job) * step.rows;
    for (std::int64_t lens = step.lenses / 2; lens < eye.lenses(); lens += step.lenses) {
      for (const std::int64_t view : views) {
        const SheetPixel pixel{lens, row, view};
        if (eye.has(pixel)) visit(pixel);
      }
    }
  };
  BestOfBlocks best(step);
  run.in_order(
      0, rows,
      [&](unsigned, std::size_t job) {
        Looks looks;
        pixels_of(job, [&](const SheetPixel& pixel) { eye.look(pixel, looks); });
        return looks;
      },
      [&](std::size_t job, const Looks& looks) {
        std::size_t next = 0;
        pixels_of(job, [&](const SheetPixel& pixel) {
          const SheetLook& look = looks[next++];
          tally.count(look);
          if (look.hit) best.add({pixel, look.point.depth});
        });
        run.advance(kShareOfGrid * static_cast<double>(job + 1) / static_cast<double>(rows));
        return true;
      });
  std::vector<Looked> starts = best.starts(1.0);
  const std::size_t nearer = starts.size();
  for (const Looked& start : best.starts(-1.0)) starts.push_back(start);
  run.in_order(
      0, starts.size(),
      [&](unsigned, std::size_t job) {
        return eye.search(starts[job], step, job < nearer ? 1.0 : -1.0);
      },
      [&](std::size_t, const Looks& looks) {
        for (const SheetLook& look : looks) tally.add(look);
        return true;
      });
}

}  // namespace

double DepthSurveyPass::work() const {
  const double pixels = static_cast<double>(m_sheet.width()) * m_sheet.height();
  return std::min(pixels, 2.0 * static_cast<double>(m_most));
}

void DepthSurveyPass::run(core::PassRun& run) {
  m_result = {};
  if (!m_probe) return;
  const SheetEye eye(m_sheet, m_probe);
  DepthTally tally(m_sheet);
  const std::uint64_t pixels = std::uint64_t{m_sheet.width()} * m_sheet.height();
  const bool is_whole = pixels / 2 <= m_most;
  if (is_whole) {
    look_at_all(m_sheet, eye, run, tally);
  } else {
    look_at_grid(m_sheet, eye, m_most, run, tally);
  }
  m_result = tally.survey();
  m_result.is_whole = is_whole;
  run.count("rays", static_cast<double>(m_result.rays));
}

DepthSurvey survey_depth(const Lenticular& sheet, const SceneProbe& probe,
                         std::uint64_t most_rays) {
  DepthSurveyPass pass(sheet, probe, most_rays);
  core::PassList passes;
  passes.add(pass);
  passes.run({.threads = probe.threads(), .levels = probe.levels()});
  return pass.result();
}

}  // namespace lentray::camera
