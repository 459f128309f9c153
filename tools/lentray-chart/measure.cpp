#include "tools/lentray-chart/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/base/formed.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"
#include "tools/common/repeats.h"
#include "tools/lentray-chart/errors.h"

namespace lentray::chart {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// True if the point is to be run in that round, counted from 0.
bool is_due(const Session& session, const Point& p, std::size_t round) {
  if (p.state == State::failed) return false;
  if (p.cpu_s.size() > round) return false;
  return round == 0 ||
         static_cast<int>(round) < repeats_for(p.seconds(), session.arguments.repeats);
}

bool stock_is_due(const Session& session, const Point& p, std::size_t round) {
  const Chart& chart = session.state.chart;
  if (chart.stock.empty() || chart.is_sheet || !stock_has(p.setting)) return false;
  if (p.state != State::done || p.stock_runs.size() > round) return false;
  if (round == 0) return true;
  return static_cast<int>(round) <
             repeats_for(tool::median_of(p.stock_runs), session.arguments.repeats) &&
         p.stock_runs.size() == round;
}

void run_point(Session& session, Point& p) {
  const std::string picture = picture_name(p.setting.id);
  const Outcome outcome = session.render(p.setting.options, picture);
  if (outcome.status != 0) {
    p.state = State::failed;
    p.reason = reason_of(outcome, session.arguments.lentray.string());
    if (p.setting.is_plain) {
      throw std::runtime_error("lentray cannot render the scene: " + p.reason);
    }
    session.progress.tell(p.setting.label + ": failed: " + p.reason);
    return;
  }
  p.state = State::done;
  p.cpu_s.push_back(outcome.cpu_s);
  p.picture = picture;
  if (!p.setting.is_plain) return;
  std::error_code ignored;
  fs::copy_file(session.folder.own("statistics.json"), session.folder.own("plain.json"),
                fs::copy_options::overwrite_existing, ignored);
}

void run_stock(Session& session, Point& p) {
  const fs::path figures = session.folder.own("stock.json");
  const std::string prefix = "pictures/" + p.setting.id;
  std::vector<std::string> options = p.setting.options;
  options.insert(options.end(), {"--stock-alone", "--json=" + figures.string(),
                                 "--output=" + session.folder.file(prefix).string()});
  const Outcome outcome = session.diff(options);
  if (outcome.status != 0) {
    session.chart().stock_reason = reason_of(outcome, session.arguments.diff.string());
    session.chart().stock.clear();
    session.progress.say("stock POV-Ray is left out: " + session.chart().stock_reason);
    return;
  }
  p.stock_runs.push_back(
      tool::parse_json(tool::read_text(figures)).at("stock_cpu_s").get<double>());
  p.stock_picture = prefix + "-stock.png";
}

/// Processor time that is spent and that is still to come, as far as it is known.
std::pair<double, double> spent_and_left(const Session& session, std::size_t rounds) {
  double spent = 0.0, left = 0.0, mean = 0.0;
  int timed = 0;
  for (const Point& p : session.state.chart.points) {
    for (const double t : p.cpu_s) spent += t;
    for (const double t : p.stock_runs) spent += t;
    if (p.cpu_s.empty()) continue;
    mean += p.seconds();
    ++timed;
  }
  if (timed > 0) mean /= timed;
  for (const Point& p : session.state.chart.points) {
    if (p.state == State::failed) continue;
    const double one = p.cpu_s.empty() ? mean : p.seconds();
    const auto wanted = std::min<std::size_t>(
        rounds, static_cast<std::size_t>(repeats_for(one, session.arguments.repeats)));
    if (wanted > p.cpu_s.size()) left += one * static_cast<double>(wanted - p.cpu_s.size());
  }
  return {spent, left};
}

std::string line_of(const Session& session, const Point& p, std::size_t round) {
  const auto number = static_cast<std::size_t>(&p - session.state.chart.points.data()) + 1;
  const std::string line = "[round " + std::to_string(round + 1) + ", " + std::to_string(number) +
                           "/" + std::to_string(session.state.chart.points.size()) + "] " +
                           p.setting.label;
  return p.cpu_s.empty() ? line : line + core::formed(": %.3g s", p.cpu_s.back());
}

}  // namespace

int repeats_for(double seconds, int wanted) {
  if (seconds < 10.0) return wanted;
  return seconds < 60.0 ? std::min(wanted, 2) : 1;
}

void forget_lost_pictures(Session& session) {
  const auto is_lost = [&](const std::string& name) {
    return name.empty() || !is_picture(session.folder.file(name));
  };
  for (Point& p : session.chart().points) {
    if (p.state == State::done && is_lost(p.picture)) p = Point{p.setting};
    if (!p.stock_picture.empty() && is_lost(p.stock_picture)) {
      p.stock_picture.clear();
      p.stock_runs.clear();
      p.stock_error.reset();
      p.from_stock.reset();
    }
    if (p.error && !p.difference.empty() && is_lost(p.difference)) p.error.reset();
  }
  if (is_lost(session.chart().reference.picture)) session.chart().reference = {};
  std::optional<Reference>& of_lens_models = session.chart().lens_reference;
  if (of_lens_models && is_lost(of_lens_models->picture)) of_lens_models.reset();
}

void measure(Session& session, int first, int last) {
  std::vector<Point>& points = session.chart().points;
  for (int round = first; round <= last; ++round) {
    const auto r = static_cast<std::size_t>(round);
    for (Point& p : points) {
      const bool due = is_due(session, p, r);
      if (due) run_point(session, p);
      const bool with_stock = stock_is_due(session, p, r);
      if (with_stock) run_stock(session, p);
      if (!due && !with_stock) continue;
      session.save();
      const auto [spent, left] = spent_and_left(session, static_cast<std::size_t>(last) + 1);
      session.progress.step(line_of(session, p, r), spent, left);
    }
  }
}

void measure_again(Session& session, Point& point) {
  run_point(session, point);
  session.save();
}

void find_stock(Session& session) {
  Chart& chart = session.chart();
  const bool is_compared_sheet = chart.is_sheet && chart.points.front().from_stock;
  chart.stock.clear();
  if (!is_compared_sheet) chart.stock_reason.clear();
  if (!session.arguments.with_stock) {
    chart.stock_reason = "it was not asked for (--no-stock)";
    return;
  }
  const std::string& program = session.arguments.povray;
  const Outcome said = session.runner.run({program, "--version"});
  const std::string label = "POV-Ray ";
  const std::size_t at = said.output.find(label + "3.");
  if (said.status == 127 || at == std::string::npos) {
    chart.stock_reason = said.status == 127 ? "cannot start '" + program + "': is it installed?"
                                            : "'" + program + "' is no POV-Ray 3";
    session.progress.say("stock POV-Ray is left out: " + chart.stock_reason);
    return;
  }
  const std::size_t begin = at + label.size();
  chart.stock = said.output.substr(begin, said.output.find_first_of(" \n", begin) - begin);
}

void compare_sheet_with_stock(Session& session) {
  Chart& chart = session.chart();
  Point& plain = chart.points.front();
  if (chart.stock.empty() || plain.from_stock || plain.state != State::done) return;
  if (session.request.own.antialias && session.state.facts.lens_model != "paraxial") {
    chart.stock_reason =
        "stock antialiases no mesh_camera, which this lens model needs; lentray-diff compares the "
        "sheet with the mean of many pictures";
    session.progress.tell("stock POV-Ray is left out: " + chart.stock_reason);
    return;
  }
  const fs::path figures = session.folder.own("stock.json");
  const double limit = std::max(60.0, 100.0 * plain.seconds());
  const Outcome outcome =
      session.diff({"--ours=" + session.folder.file(plain.picture).string(),
                    "--statistics=" + session.folder.own("plain.json").string(), "--no-pictures",
                    "--json=" + figures.string(), "--time-limit=" + std::to_string(limit)});
  if (outcome.status > 1) {
    chart.stock_reason = "of the sheet: " + reason_of(outcome, session.arguments.diff.string());
    session.progress.say("stock POV-Ray is left out: " + chart.stock_reason);
    return;
  }
  const json all = tool::parse_json(tool::read_text(figures));
  const json& whole = all.at("whole");
  Error e;
  e.psnr = std::numeric_limits<double>::infinity();
  if (!whole.at("psnr").is_null()) {
    whole.at("psnr").get_to(e.psnr);
    e.rms = 255.0 * std::pow(10.0, -e.psnr / 20.0);
  }
  whole.at("beyond_1").get_to(e.share);
  whole.at("largest").get_to(e.largest);
  plain.from_stock = e;
  plain.stock_runs = {all.at("stock_cpu_s").get<double>()};
  chart.stock_reason =
      "stock renders a lens sheet view by view, so only your own options are held against it: " +
      whole.at("grade").get<std::string>() + " (" + all.at("way").get<std::string>() + ")";
  session.progress.tell("stock POV-Ray, " + chart.stock_reason);
  session.save();
}

}  // namespace lentray::chart
