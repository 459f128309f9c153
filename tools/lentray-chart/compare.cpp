#include "tools/lentray-chart/compare.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/image/reader.h"
#include "tools/common/duration.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"
#include "tools/lentray-chart/errors.h"
#include "tools/lentray-chart/reference.h"

namespace lentray::chart {

namespace fs = std::filesystem;

namespace {

bool is_lens(const Point& p) { return p.setting.kind == Kind::lens_model; }

void forget_errors(Chart& chart, bool of_lens_models) {
  for (Point& p : chart.points) {
    if (is_lens(p) != of_lens_models) continue;
    p.error.reset();
    p.stock_error.reset();
  }
}

/// Of the settings that this reference is for, against it; exact ones have the plain one's. Infinite: none.
double smallest_error(const Session& session, const core::StoredImage& reference,
                      bool of_lens_models) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Point& p : session.state.chart.points) {
    const bool is_other = p.setting.kind == Kind::exact && !p.setting.is_plain;
    if (p.state != State::done || is_lens(p) != of_lens_models || is_other) continue;
    const double rms = error_of(shown_picture(session.folder.file(p.picture)), reference).rms;
    if (rms > 0.0) smallest = std::min(smallest, rms);
  }
  return smallest;
}

/// One reference on its way.
class Convergence {
 public:
  Convergence(Session& session, Reference& reference, bool of_lens_models)
      : m_session(session), m_reference(reference), m_of_lens_models(of_lens_models),
        m_name(of_lens_models ? "reference of lens models" : "reference"),
        m_picture(picture_name(of_lens_models ? "reference-lens" : "reference")) {}

  void run() {
    if (m_reference.is_converged) return;
    m_last_s = 0.6 * m_reference.cpu_s;  // about what the last step of an earlier run took
    while (next()) {
    }
    std::string line = m_name + ": ";
    if (m_reference.steps.empty()) {
      line += "there is none: " + m_why;
    } else if (m_reference.is_converged) {
      line += "converged, it changes by " + error_text(m_reference.change);
    } else {
      line += "NOT converged (" + m_why + "): it changes by " + error_text(m_reference.change);
    }
    m_session.progress.say(line);
  }

 private:
  /// False if it ends here.
  bool next() {
    const int number = static_cast<int>(m_reference.steps.size());
    const auto step = reference_step(m_session.request, number, m_of_lens_models);
    const double limit = m_session.arguments.reference_limit;
    if (!step) return end("more samples are not possible");
    const double left = limit - m_reference.cpu_s;
    if (left <= 0.0 || (number > 0 && m_last_s * step->work > left)) {
      return end("the next step would pass the limit of " + tool::duration_text(limit));
    }
    const std::string next_picture = picture_name("reference-next");
    const Outcome outcome = m_session.render(step->options, next_picture, left);
    m_reference.cpu_s += outcome.cpu_s;
    m_last_s = outcome.cpu_s;
    if (outcome.status != 0) {
      return end(outcome.over_limit ? "it passed the limit of " + tool::duration_text(limit)
                                    : reason_of(outcome, "lentray"));
    }
    return take(*step, next_picture);
  }

  bool take(const ReferenceStep& step, const std::string& next_picture) {
    const ChartFolder& folder = m_session.folder;
    const bool is_first = m_reference.steps.empty();
    const std::string before =
        is_first ? m_session.chart().points.front().picture : m_reference.picture;
    const core::StoredImage now = shown_picture(folder.file(next_picture));
    m_reference.change = error_of(now, shown_picture(folder.file(before))).rms;
    fs::rename(folder.file(next_picture), folder.file(m_picture));
    m_reference.picture = m_picture;
    m_reference.options = step.options;
    m_reference.steps.emplace_back(step.what, m_reference.change);
    forget_errors(m_session.chart(), m_of_lens_models);
    m_reference.is_converged =
        !is_first &&
        is_converged(m_reference.change, smallest_error(m_session, now, m_of_lens_models));
    m_session.save();
    m_session.progress.step(
        m_name + ", " + step.what + ": changes by " + error_text(m_reference.change),
        m_reference.cpu_s, std::max(0.0, m_session.arguments.reference_limit - m_reference.cpu_s));
    return !m_reference.is_converged;
  }

  bool end(const std::string& why) {
    m_why = why;
    return false;
  }

  Session& m_session;
  Reference& m_reference;
  const bool m_of_lens_models;
  const std::string m_name, m_picture;
  double m_last_s = 0.0;
  std::string m_why{};
};

/// Butteraugli, as far as it is installed.
class Perception {
 public:
  explicit Perception(const Session& session) : m_session(session) {}

  std::optional<double> of(const std::string& reference, const std::string& picture) {
    if (m_missing) return std::nullopt;
    const Outcome said =
        m_session.runner.run({"butteraugli_main", m_session.folder.file(reference).string(),
                              m_session.folder.file(picture).string()});
    if (said.status == 127) {
      m_missing = true;
      m_session.progress.say(
          "butteraugli_main is not installed (Debian's libjxl-devtools): perceived errors are left "
          "out");
    }
    if (said.status != 0) return std::nullopt;
    return perceived_in(said.output);
  }

 private:
  const Session& m_session;
  bool m_missing = false;
};

/// What an eye sees of a lens sheet, as lentray-diff measures it.
class Sight {
 public:
  explicit Sight(const Session& session)
      : m_session(session), m_missing(!session.state.chart.is_sheet) {}

  std::optional<double> of(const std::string& reference, const std::string& picture) {
    if (m_missing) return std::nullopt;
    const ChartFolder& folder = m_session.folder;
    const std::string diff = m_session.arguments.diff.string();
    const fs::path figures = folder.own("seen.json");
    const Outcome outcome =
        m_session.runner.run({diff, "--seen", folder.file(reference).string(),
                              folder.file(picture).string(), "--json", figures.string()});
    if (outcome.status != 0) {
      m_missing = true;
      m_session.progress.say("what an eye sees of the sheet is left out: " +
                             reason_of(outcome, diff));
      return std::nullopt;
    }
    return tool::parse_json(tool::read_text(figures)).at("l_star").at("rms").get<double>();
  }

 private:
  const Session& m_session;
  bool m_missing;
};

/// Whether the error of `plain` is known and `p` has the same picture and reference.
bool has_picture_of(const Point& plain, const Point& p) {
  return &plain != &p && plain.error && !is_lens(p) && p.from_plain && p.from_plain->largest == 0.0;
}

/// All that one reference says of the points it is for.
void compare_with(Session& session, const Reference& reference, bool of_lens_models,
                  Perception& perception, Sight& sight) {
  if (reference.picture.empty()) return;
  const ChartFolder& folder = session.folder;
  std::optional<core::StoredImage> truth;
  for (Point& p : session.chart().points) {
    const bool is_new = p.state == State::done && is_lens(p) == of_lens_models && !p.error;
    const bool stock_is_new =
        is_lens(p) == of_lens_models && !p.stock_picture.empty() && !p.stock_error;
    if (!is_new && !stock_is_new) continue;
    if (const Point& plain = session.chart().points.front(); has_picture_of(plain, p)) {
      p.error = plain.error;
      p.difference = plain.difference;
      if (!stock_is_new) continue;
    }
    if (!truth) truth = shown_picture(folder.file(reference.picture));
    if (!p.error) {
      const core::StoredImage picture = shown_picture(folder.file(p.picture));
      p.error = error_of(picture, *truth);
      p.error->perceived = perception.of(reference.picture, p.picture);
      p.error->seen = sight.of(reference.picture, p.picture);
      p.difference = "pictures/" + p.setting.id + "-difference.png";
      core::write_stored(difference_of(picture, *truth), folder.file(p.difference));
    }
    if (stock_is_new) p.stock_error = error_of(shown_picture(folder.file(p.stock_picture)), *truth);
    session.save();
  }
}

void compare_with_plain(Session& session) {
  const ChartFolder& folder = session.folder;
  const Point& first = session.chart().points.front();
  const core::StoredImage plain = shown_picture(folder.file(first.picture));
  for (Point& p : session.chart().points) {
    if (p.state != State::done) continue;
    const bool needs_stock = !p.stock_picture.empty() && !p.from_stock;
    if (p.from_plain && !needs_stock) continue;
    const core::StoredImage picture = shown_picture(folder.file(p.picture));
    if (!p.from_plain) p.from_plain = error_of(picture, plain);
    if (needs_stock) p.from_stock = error_of(picture, shown_picture(folder.file(p.stock_picture)));
  }
  session.save();
}

}  // namespace

void make_references(Session& session) {
  Chart& chart = session.chart();
  Convergence(session, chart.reference, false).run();
  if (std::ranges::none_of(chart.points, is_lens)) {
    chart.lens_reference.reset();
    return;
  }
  if (!chart.lens_reference) chart.lens_reference.emplace();
  Convergence(session, *chart.lens_reference, true).run();
}

void compare_points(Session& session) {
  compare_with_plain(session);
  Perception perception(session);
  Sight sight(session);
  const Chart& chart = session.chart();
  compare_with(session, chart.reference, false, perception, sight);
  if (chart.lens_reference) {
    compare_with(session, *chart.lens_reference, true, perception, sight);
  }
}

std::vector<std::string> broken_promises(const Chart& chart) {
  std::vector<std::string> lines;
  for (const Point& p : chart.points) {
    if (p.setting.kind != Kind::exact || !p.from_plain || p.from_plain->largest == 0.0) continue;
    lines.push_back(p.setting.label + " changes the picture, by up to " +
                    error_text(p.from_plain->largest) + ": it must not");
  }
  return lines;
}

}  // namespace lentray::chart
