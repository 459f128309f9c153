// lentray-chart: speed against accuracy of a scene's settings.
#include <algorithm>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/base/formed.h"
#include "core/base/ignored_error.h"
#include "core/base/joined.h"
#include "core/image/run_files.h"
#include "parser/files/watched_files.h"
#include "tools/common/child.h"
#include "tools/common/duration.h"
#include "tools/common/json_text.h"
#include "tools/common/machine.h"
#include "tools/common/own_folder.h"
#include "tools/common/process.h"
#include "tools/common/shell_words.h"
#include "tools/common/tool_main.h"
#include "tools/lentray-chart/arguments.h"
#include "tools/lentray-chart/charts.h"
#include "tools/lentray-chart/compare.h"
#include "tools/lentray-chart/front.h"
#include "tools/lentray-chart/measure.h"
#include "tools/lentray-chart/page.h"
#include "tools/lentray-chart/probe.h"
#include "tools/lentray-chart/table.h"

namespace lentray::chart {
namespace {

namespace fs = std::filesystem;

enum Status : int { kDone = 0, kError = 1, kNoneFits = 2, kStopped = 3 };

/// One run of the program.
class Charting {
 public:
  explicit Charting(const Arguments& arguments)
      : m_arguments(arguments), m_folder(arguments.out), m_progress(!arguments.options.verbose),
        m_session(arguments, m_folder, m_progress) {}

  Status run() {
    try {
      core::note_input(m_arguments.scene);
      prepare();
      for (const auto& [path, sum] : m_session.state.seen.files) core::note_input(path);
      render();
      return finish();
    } catch (const Stopped&) {
      if (m_session.state.key.empty()) throw;
      m_session.save();
      m_progress.say("lentray-chart: stopped; the same command goes on from here");
      return kStopped;
    }
  }

 private:
  Chart& chart() { return m_session.chart(); }

  /// A chart of another program, scene or options begins anew.
  std::string key() const {
    const auto sum = parser::file_checksum(m_arguments.lentray.string());
    if (!sum) {
      throw std::runtime_error("there is no program '" + m_arguments.lentray.string() + "'");
    }
    const nlohmann::json all{{"program", *sum},
                             {"version", tool::kVersion},
                             {"scene", fs::absolute(m_arguments.scene).lexically_normal().string()},
                             {"options", m_arguments.for_lentray}};
    return tool::json_text(all);
  }

  void prepare() {
    const std::string now = key();
    MatrixRequest& request = m_session.request;
    request.own = parser::read_options(m_arguments.for_lentray, parser::installed_sources());
    request.abilities = abilities_of(m_session);
    load(now);
    if (m_session.state.key.empty()) {
      probe_scene(m_session);
      m_session.state.key = now;
    }
    request.facts = m_session.state.facts;
    request.only = m_arguments.only;
    request.quick = m_arguments.quick;
    request.processors = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    describe();
    take_settings();
    forget_lost_pictures(m_session);
    find_stock(m_session);
    m_session.save();
    announce();
  }

  void load(const std::string& now) {
    std::optional<ChartState> known;
    std::string why;
    try {
      known = m_folder.load();
      if (!known) return;
    } catch (const std::runtime_error& error) {
      why = error.what();
    }
    if (why.empty() && known->key != now)
      why = "the scene's name, an option or the program is another one";
    if (why.empty()) why = tool::change_in(known->seen);
    if (why.empty()) {
      m_session.state = std::move(*known);
      return;
    }
    m_progress.say("the chart begins anew: " + why);
    m_folder.remove_pictures();
  }

  void describe() {
    const SceneFacts& facts = m_session.state.facts;
    const parser::RenderOptions& own = m_session.request.own;
    Chart& c = chart();
    std::vector<std::string> words{"lentray", m_arguments.scene};
    words.insert(words.end(), m_arguments.for_lentray.begin(), m_arguments.for_lentray.end());
    c.command = tool::shell_command(words);
    c.scene = m_arguments.scene;
    c.width = facts.width;
    c.height = facts.height;
    c.is_sheet = facts.is_sheet;
    c.machine = tool::processor_name() + ", " + std::to_string(m_session.request.processors) +
                (m_session.request.processors == 1 ? " thread" : " threads");
    c.noise = noise_of(facts, own.antialias && own.jitter && own.jitter_amount > 0.0);
  }

  /// Settings that are known keep their figures.
  void take_settings() {
    std::vector<Point> known = std::move(chart().points);
    chart().points.clear();
    const auto add = [&](const Setting& setting) {
      const auto at = std::ranges::find_if(known, [&](const Point& p) {
        return p.setting.id == setting.id && p.setting.options == setting.options;
      });
      if (at == known.end()) {
        chart().points.push_back(Point{setting});
      } else {
        chart().points.push_back(at->state == State::failed ? Point{setting} : std::move(*at));
        known.erase(at);
      }
    };
    for (const Setting& setting : settings_of(m_session.request)) add(setting);
    std::string matrix = m_arguments.quick ? "quick" : "all";
    for (const Kind kind : m_arguments.only) matrix += std::string(" ") + name_of(kind);
    if (m_session.state.matrix == matrix) {
      const std::vector<Point> rest = known;
      for (const Point& p : rest) {
        if (p.setting.kind == Kind::combined) add(p.setting);
      }
    }
    m_session.state.matrix = matrix;
  }

  void announce() {
    std::map<std::string, int> counts;
    for (const Point& p : chart().points) ++counts[name_of(p.setting.kind)];
    const std::string kinds = core::joined(counts, ", ", [](const auto& kind) {
      return kind.first + " " + std::to_string(kind.second);
    });
    m_progress.tell(chart().scene + ", " + std::to_string(chart().width) + " x " +
                    std::to_string(chart().height) + ": " + std::to_string(chart().points.size()) +
                    " settings (" + kinds + "), " + std::to_string(m_arguments.repeats) +
                    (m_arguments.repeats == 1 ? " round" : " rounds") + ", a reference within " +
                    tool::duration_text(m_arguments.reference_limit));
    if (!chart().noise.empty()) m_progress.tell("pictures have noise: " + chart().noise);
  }

  void render() {
    measure(m_session, 0, 0);
    make_references(m_session);
    compare_points(m_session);
    const bool crossed = std::ranges::any_of(
        chart().points, [](const Point& p) { return p.setting.kind == Kind::combined; });
    if (wants(m_arguments, Kind::combined) && !crossed) {
      for (const Setting& s : combined_settings(chart().points, m_arguments.quick)) {
        chart().points.push_back(Point{s});
      }
      measure(m_session, 0, 0);
    }
    if (m_arguments.repeats > 1) measure(m_session, 1, m_arguments.repeats - 1);
    compare_points(m_session);
    if (chart().is_sheet) compare_sheet_with_stock(m_session);
  }

  /// The choice for the budget is rendered once more; that it holds is seen before it is recommended.
  Choice confirmed(double budget) {
    constexpr int kTries = 3;
    Choice choice = choose_by_budget(chart(), budget);
    for (int i = 0; i < kTries && choice.point != nullptr; ++i) {
      Point& point = chart().points[static_cast<std::size_t>(choice.point - chart().points.data())];
      measure_again(m_session, point);
      const bool holds = point.state == State::done && point.cpu_s.back() <= 1.1 * budget;
      derive(chart());
      choice = choose_by_budget(chart(), budget);
      if (holds && choice.point == &point) break;
    }
    return choice;
  }

  Status print(const char* asked, const Choice& choice) {
    if (choice.point == nullptr) {
      std::cout << asked << ": " << choice.reason << "\n";
      return kNoneFits;
    }
    const Point& p = *choice.point;
    std::cout << asked << ": " << p.setting.label
              << core::formed(" (%.3g s, error %.3g/255)\n  ", p.seconds(), p.error->rms)
              << choice.command << "\n";
    return kDone;
  }

  Status finish() {
    derive(chart());
    std::optional<Choice> by_budget, by_error;
    if (m_arguments.budget) by_budget = confirmed(*m_arguments.budget);
    if (m_arguments.error) by_error = choose_by_error(chart(), *m_arguments.error);
    m_session.save();
    tool::write_whole(m_folder.file("chart.csv"), csv_of(chart()));
    PageOptions options;
    options.folder = m_folder.out();
    tool::write_whole(m_folder.file("index.html"), page(chart(), options));
    std::cout << front_table(chart());
    Status status = kDone;
    try {
      tool::write_whole(m_folder.file("chart.svg"), chart_svg(chart()));
      tool::write_whole(m_folder.file("chart.png"), chart_png(chart()));
    } catch (const std::runtime_error& error) {  // no gnuplot: the page says it as well
      m_progress.say(std::string("lentray-chart: no chart.svg and chart.png: ") + error.what());
    }
    for (const std::string& line : broken_promises(chart())) {
      m_progress.say("lentray-chart: " + line);
      status = kError;
    }
    if (chart().reference.picture.empty()) status = kError;
    if (by_budget) {
      const std::string asked = "within " + tool::duration_text(*m_arguments.budget);
      status = worse(status, print(asked.c_str(), *by_budget));
    }
    if (by_error) {
      const std::string asked = "error at most " + error_text(*m_arguments.error);
      status = worse(status, print(asked.c_str(), *by_error));
    }
    std::cout << m_folder.file("chart.csv").string() << "\n"
              << m_folder.file("index.html").string() << std::endl;
    return status;
  }

  static Status worse(Status a, Status b) { return a == kDone ? b : a; }

  const Arguments& m_arguments;
  const ChartFolder m_folder;
  const Progress m_progress;
  Session m_session;
};

/// What a chart makes takes no place of something else.
void refuse_foreign(const fs::path& out) {
  tool::refuse_foreign_page(out / "index.html", "lentray-chart");
  for (const char* name : {"chart.csv", "chart.svg", "chart.png"}) {
    tool::refuse_foreign(out / name, "lentray-chart", [&](const fs::path&) {
      return fs::exists(out / ".lentray-chart", core::ignored_error());
    });
  }
}

int chart(const Arguments& arguments) {
  tool::hold_signals();
  if (parser::read_options(arguments.for_lentray, parser::installed_sources()).restrict_io)
    tool::refuse_links(arguments.out);
  refuse_foreign(arguments.out);
  try {
    return Charting(arguments).run();
  } catch (const Stopped&) {
    std::cerr << "lentray-chart: stopped; the same command begins again" << std::endl;
    return kStopped;
  }
}

}  // namespace
}  // namespace lentray::chart

int main(int count, char** words) {
  using namespace lentray::chart;
  return lentray::tool::tool_main({"lentray-chart"}, count, words, parse_arguments, usage, chart);
}
