#include "tools/lentray-chart/front.h"

#include <tuple>
#include <utility>

#include "tools/common/duration.h"
#include "tools/common/repeats.h"
#include "tools/common/shell_words.h"

namespace lentray::chart {
namespace {

/// Exact settings have the plain one's error, and differ from it in time alone.
bool is_exact(const Point& p) { return p.setting.kind == Kind::exact && !p.setting.is_plain; }

/// Other lens models are other pictures, and exact settings may be added to any other: the ones have a
/// front of their own, the others none.
bool shares_a_front(const Point& a, const Point& b) {
  return !is_exact(a) && !is_exact(b) &&
         (a.setting.kind == Kind::lens_model) == (b.setting.kind == Kind::lens_model);
}

bool dominates(const Point& a, const Point& b) {
  const bool no_worse = a.seconds() <= b.seconds() && a.error->rms <= b.error->rms;
  return no_worse && (a.seconds() < b.seconds() || a.error->rms < b.error->rms);
}

/// Of those better in both, or else no worse, the fastest; of equally fast ones that with the least error.
const Point* dominator(const Chart& chart, const Point& p) {
  const Point* best = nullptr;
  const auto rank = [&](const Point& q) {
    return !(q.seconds() < p.seconds() && q.error->rms < p.error->rms);
  };
  for (const Point& q : chart.points) {
    if (&q == &p || !q.is_known() || !shares_a_front(q, p) || !dominates(q, p)) continue;
    const auto key = [&](const Point& x) { return std::tuple(rank(x), x.seconds(), x.error->rms); };
    if (best == nullptr || key(q) < key(*best)) best = &q;
  }
  return best;
}

/// Exact settings last: they are chosen where nothing else of their error is fast enough.
std::vector<const Point*> candidates(const Chart& chart) {
  std::vector<const Point*> out;
  for (const bool exact : {false, true}) {
    for (const Point& p : chart.points) {
      if (p.is_known() && p.setting.kind != Kind::lens_model && is_exact(p) == exact) {
        out.push_back(&p);
      }
    }
  }
  return out;
}

Choice chosen(const Point& point) { return {&point, point.command, ""}; }

}  // namespace

void derive(Chart& chart) {
  for (Point& p : chart.points) {
    std::vector<std::string> options = p.setting.options;
    p.command = chart.command;
    if (!options.empty()) p.command += " " + tool::shell_command(options);
    p.stock_cpu_s.reset();
    if (!p.stock_runs.empty()) p.stock_cpu_s = tool::median_of(p.stock_runs);
    p.told_apart = true;
    p.on_front = false;
    p.dominated_by.clear();
    if (!p.is_known()) continue;
    const bool is_lens = p.setting.kind == Kind::lens_model && chart.lens_reference;
    const Reference& reference = is_lens ? *chart.lens_reference : chart.reference;
    p.told_apart = p.error->rms >= 10.0 * reference.change;
    const Point* const better = dominator(chart, p);
    p.on_front = better == nullptr && !is_exact(p);
    if (better != nullptr) p.dominated_by = better->setting.id;
  }
}

Choice choose_by_budget(const Chart& chart, double seconds) {
  const Point *best = nullptr, *fastest = nullptr;
  for (const Point* p : candidates(chart)) {
    if (fastest == nullptr || p->seconds() < fastest->seconds()) fastest = p;
    if (p->seconds() > seconds) continue;
    const auto key = [](const Point& q) {
      return std::tuple(q.error->rms, is_exact(q), q.seconds());
    };
    if (best == nullptr || key(*p) < key(*best)) best = p;
  }
  if (best != nullptr) return chosen(*best);
  if (fastest == nullptr) return {nullptr, "", "no setting has a time and an error"};
  return {nullptr, "",
          "no setting renders within " + tool::duration_text(seconds) + "; the fastest, " +
              fastest->setting.label + ", takes " + tool::duration_text(fastest->seconds())};
}

Choice choose_by_error(const Chart& chart, double rms) {
  const Point *best = nullptr, *least = nullptr;
  for (const Point* p : candidates(chart)) {
    if (least == nullptr || p->error->rms < least->error->rms) least = p;
    if (p->error->rms > rms || is_exact(*p)) continue;
    const auto key = [](const Point& q) { return std::pair(q.seconds(), q.error->rms); };
    if (best == nullptr || key(*p) < key(*best)) best = p;
  }
  if (best != nullptr) return chosen(*best);
  if (least == nullptr) return {nullptr, "", "no setting has a time and an error"};
  return {nullptr, "",
          "no setting has an error of at most " + error_text(rms) + "; the least, " +
              error_text(least->error->rms) + ", has " + least->setting.label + " in " +
              tool::duration_text(least->seconds())};
}

}  // namespace lentray::chart
