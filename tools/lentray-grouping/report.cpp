#include "tools/lentray-grouping/report.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/base/formed.h"
#include "tools/common/csv.h"
#include "tools/common/gnuplot.h"
#include "tools/common/inline_svg.h"
#include "tools/common/page_text.h"

namespace lentray::grouping {

using tool::csv_field;
using tool::html_text;

namespace {

std::string padded(std::string text) {
  text.resize(std::max<std::size_t>(text.size() + 1, 14), ' ');
  return text;
}

std::string figure(double value) { return core::formed("%.6g", value); }
std::string percent(double part) { return core::formed("%.1f %%", 100.0 * part); }

std::string short_name(const std::string& scene) {
  return std::filesystem::path(scene).stem().string();
}

const Trial* find(const Group& group, const std::string& order, const std::string& cache) {
  const auto at = std::find_if(group.begin(), group.end(), [&](const Trial& t) {
    return t.order == order && t.cache == cache;
  });
  return at == group.end() ? nullptr : &*at;
}

template <class Name>
std::vector<std::string> distinct(const Group& group, Name name) {
  std::vector<std::string> names;
  for (const Trial& t : group) {
    if (std::find(names.begin(), names.end(), name(t)) == names.end()) names.push_back(name(t));
  }
  return names;
}

std::vector<std::string> caches_of(const Group& group) {
  return distinct(group, [](const Trial& t) { return t.cache; });
}

/// A line an order, a column a cache.
template <class Value>
std::string bars(const Group& group, Value value) {
  std::string out = "order";
  for (const std::string& cache : caches_of(group)) out += "\t" + cache;
  out += "\n";
  for (const std::string& order : distinct(group, [](const Trial& t) { return t.order; })) {
    out += order;
    for (const std::string& cache : caches_of(group)) {
      out += "\t" + figure(value(*find(group, order, cache)));
    }
    out += "\n";
  }
  return out;
}

std::string bar_chart(const Group& group, const std::string& title, const std::string& data) {
  const std::size_t caches = caches_of(group).size();
  std::string script =
      tool::gnuplot_preamble("svg", 620, 380) + "set datafile separator '\\t'\nset title '" +
      title + "' noenhanced\nset style data histogram\nset style fill solid 0.8\nset grid y\n" +
      "set yrange [0:*]\nset xtics rotate by -30 noenhanced\n"
      "set key outside right noenhanced\nplot ";
  for (std::size_t i = 0; i < caches; ++i) {
    script += std::string(i > 0 ? ", " : "") + "'data' using " + std::to_string(i + 2) +
              ":xtic(1) title columnheader";
  }
  return tool::gnuplot(script + "\n", data);
}

/// Time against what equation 1 counts, and its line.
std::string cost_chart(const Group& group, const std::string& title) {
  const CostFit fit = fit_cost(group);
  std::string data;
  for (const Trial& t : group) {
    data += figure(static_cast<double>(t.tests) * 1e-6) + "\t" + figure(t.median()) + "\t" +
            t.order + " " + t.cache + "\n";
  }
  const std::string script =
      tool::gnuplot_preamble("svg", 620, 380) + "set datafile separator '\\t'\nset title '" +
      title + "' noenhanced\nset xlabel 'tests for shadow rays, millions'\nset ylabel 'CPU, s'\n" +
      "set grid\nset xrange [0:*]\nset yrange [0:*]\nset key outside right\n" +
      "plot 'data' using 1:2 with points pointtype 7 title 'measured', " +
      core::formed("%.9g", fit.rest) + " + " + core::formed("%.9g", fit.per_test * 1e6) +
      "*x title 'equation 1'\n";
  return tool::gnuplot(script, data);
}

struct Column {
  const char* name;
  std::string (*text)(const Trial&);
};

constexpr Column kColumns[] = {
    {"order", [](const Trial& t) { return t.order; }},
    {"cache", [](const Trial& t) { return t.cache; }},
    {"CPU s", [](const Trial& t) { return core::formed("%.3f", t.median()); }},
    {"least", [](const Trial& t) { return core::formed("%.3f", t.least()); }},
    {"most", [](const Trial& t) { return core::formed("%.3f", t.most()); }},
    {"tests/ray", [](const Trial& t) { return core::formed("%.2f", t.tests_a_ray()); }},
    {"hits/blocked", [](const Trial& t) { return percent(t.hits_of_blocked()); }},
    {"hits/bound", [](const Trial& t) { return percent(t.hits_of_most()); }},
    {"mean run", [](const Trial& t) { return core::formed("%.1f", t.mean_run()); }},
    {"longest", [](const Trial& t) { return std::to_string(t.longest_run); }},
    {"picture", [](const Trial& t) { return std::string(t.same_picture ? "same" : "DIFFERS"); }},
};

std::string heading(const Group& group) {
  const Trial& t = group.front();
  return short_name(t.scene) + (t.size.empty() ? "" : " of size " + t.size) + ", " + t.accelerator +
         ": " + std::to_string(t.rays) + " shadow rays, " + std::to_string(t.blocked) +
         " blocked, at most " + std::to_string(t.most_hits) + " hits";
}

std::string gain_text(const Gain& g) {
  return "cache " + g.cache + ", Cm/Ch " + core::formed("%.1f", g.miss_cost) + ": columns save " +
         percent(g.time) + " of the time of " + g.against + ", " + percent(g.tests) +
         " of its tests (equation 2: " + percent(g.equation2) + ")";
}

/// The gains of all groups against Cm/Ch; empty where there are fewer than two.
std::string gain_chart(const std::vector<Trial>& trials) {
  std::string data;
  std::size_t count = 0;
  for (const Group& group : groups_of(trials)) {
    for (const Gain& g : gains_of(group)) {
      if (g.cache == "off") continue;
      ++count;
      data += figure(g.miss_cost) + "\t" + figure(100.0 * g.time) + "\t" + figure(100.0 * g.tests) +
              "\t" + figure(100.0 * g.equation2) + "\n";
    }
  }
  if (count < 2) return {};
  const std::string script =
      tool::gnuplot_preamble("svg", 900, 420) +
      "set datafile separator '\\t'\nset xlabel 'Cm/Ch, tests'\nset ylabel 'columns save, %'\n"
      "set logscale x\nset grid\nset key outside right\n"
      "plot 'data' using 1:2 with points pointtype 7 title 'time', "
      "'data' using 1:3 with points pointtype 5 title 'tests (equation 1)', "
      "'data' using 1:4 with points pointtype 4 pointsize 1.5 title 'equation 2'\n";
  return "<section class=\"box\"><h2>What columns save against rows and views</h2>\n" +
         tool::inline_svg(tool::gnuplot(script, data), {"gains", "What columns save, over Cm/Ch"}) +
         "</section>\n";
}

/// Who was fastest, and how far auto is from it; empty where nothing was timed.
std::string fastest_text(const Group& group) {
  const auto less = [](const Trial& a, const Trial& b) { return a.median() < b.median(); };
  const Trial& best = *std::min_element(group.begin(), group.end(), less);
  if (!(best.median() > 0.0)) return "";
  std::string text = "fastest: " + best.order + ", " + best.cache + ", " +
                     core::formed("%.3f", best.median()) + " s (" +
                     core::formed("%.3f", best.least()) + " to " +
                     core::formed("%.3f", best.most()) + ")";
  if (const Trial* decided = find(group, "auto", "auto"); decided && decided != &best) {
    text += "; auto, auto takes " + percent(decided->median() / best.median() - 1.0) + " more";
  }
  return text;
}

std::string table_html(const Group& group) {
  std::string out = "<div class=\"wide\"><table class=\"sorts\"><thead><tr>";
  const auto tag = [](const char* name, std::size_t column) {
    return std::string("<") + name + (column < 2 ? " class=\"is-text\">" : ">");
  };
  for (std::size_t i = 0; i < std::size(kColumns); ++i) {
    out += tag("th", i) + kColumns[i].name + "</th>";
  }
  out += "</tr></thead><tbody>\n";
  for (const Trial& t : group) {
    out += "<tr>";
    for (std::size_t i = 0; i < std::size(kColumns); ++i) {
      out += tag("td", i) + html_text(kColumns[i].text(t)) + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

/// `number` sets its charts apart from those of other groups.
std::string group_html(const Group& group, std::size_t number) {
  const auto chart = [&](const char* name, const char* label, const std::string& svg) {
    return "<div>" +
           tool::inline_svg(svg, {name + std::to_string(number), label + (": " + heading(group))}) +
           "</div>\n";
  };
  std::string out = "<section class=\"box\"><h2>" + html_text(heading(group)) + "</h2>\n" +
                    table_html(group) + "<p>" + html_text(fastest_text(group)) + "</p>\n";
  for (const Gain& g : gains_of(group)) out += "<p>" + html_text(gain_text(g)) + "</p>\n";
  const auto bar = [&](const char* name, const char* title, double (*value)(const Trial&)) {
    return chart(name, title, bar_chart(group, title, bars(group, value)));
  };
  out += "<div class=\"charts\">\n" +
         bar("time", "CPU, s (median)", [](const Trial& t) { return t.median(); }) +
         bar("hits", "hits / upper bound", [](const Trial& t) { return t.hits_of_most(); }) +
         bar("tests", "tests a shadow ray", [](const Trial& t) { return t.tests_a_ray(); }) +
         chart("cost", "time and equation 1", cost_chart(group, "time and equation 1"));
  return out + "</div></section>\n";
}

}  // namespace

std::vector<Group> groups_of(const std::vector<Trial>& trials) {
  std::vector<Group> groups;
  for (const Trial& t : trials) {
    if (groups.empty() || groups.back().front().scene != t.scene ||
        groups.back().front().size != t.size ||
        groups.back().front().accelerator != t.accelerator) {
      groups.emplace_back();
    }
    groups.back().push_back(t);
  }
  return groups;
}

CostFit fit_cost(const Group& group) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Trial& t : group) {
    const auto tests = static_cast<double>(t.tests);
    n += 1.0;
    x += tests;
    y += t.median();
    xx += tests * tests;
    xy += tests * t.median();
  }
  const double spread = n * xx - x * x;
  CostFit fit;
  if (spread > 0.0) fit.per_test = (n * xy - x * y) / spread;
  fit.rest = (y - fit.per_test * x) / n;
  return fit;
}

std::vector<Gain> gains_of(const Group& group) {
  std::vector<Gain> out;
  const auto saved = [](double less, double more) { return more > 0.0 ? 1.0 - less / more : 0.0; };
  const auto count = [](std::uint64_t n) { return static_cast<double>(n); };
  for (const std::string& cache : caches_of(group)) {
    const Trial* const columns = find(group, "columns", cache);
    for (const char* order : {"rows", "views"}) {
      const Trial* const other = find(group, order, cache);
      if (!columns || !other) continue;
      Gain g;
      g.cache = cache;
      g.against = order;
      g.miss_cost = 0.5 * (columns->miss_cost() + other->miss_cost());
      g.time = saved(columns->median(), other->median());
      g.tests = saved(count(columns->tests), count(other->tests));
      // (2): Ct = N Cm - Nh Cm; Cm goes out of the quotient.
      g.equation2 = saved(count(columns->rays - columns->hits), count(other->rays - other->hits));
      out.push_back(g);
    }
  }
  return out;
}

std::string csv_of(const std::vector<Trial>& trials) {
  std::string out =
      "scene,size,order,cache,accelerator,cpu_s,cpu_least_s,cpu_most_s,shadow_rays,blocked,hits,"
      "pairs,"
      "most_hits,hits_of_blocked,hits_of_most,tests,tests_a_ray,miss_cost,runs,mean_run,"
      "longest_run,same_picture\n";
  for (const Trial& t : trials) {
    for (const std::string& text : {t.scene, t.size, t.order, t.cache, t.accelerator}) {
      out += csv_field(text) + ",";
    }
    out += figure(t.median()) + "," + figure(t.least()) + "," + figure(t.most()) + "," +
           std::to_string(t.rays) + "," + std::to_string(t.blocked) + "," + std::to_string(t.hits) +
           "," + std::to_string(t.pairs) + "," + std::to_string(t.most_hits) + "," +
           figure(t.hits_of_blocked()) + "," + figure(t.hits_of_most()) + "," +
           std::to_string(t.tests) + "," + figure(t.tests_a_ray()) + "," + figure(t.miss_cost()) +
           "," + std::to_string(t.runs) + "," + figure(t.mean_run()) + "," +
           std::to_string(t.longest_run) + "," + (t.same_picture ? "yes" : "no") + "\n";
  }
  return out;
}

std::string gains_csv_of(const std::vector<Trial>& trials) {
  std::string out =
      "scene,size,accelerator,cache,against,miss_cost,blocked_part,hits_columns,hits_other,"
      "saved_tests,saved_equation2,saved_time\n";
  for (const Group& group : groups_of(trials)) {
    const Trial& t = group.front();
    for (const Gain& g : gains_of(group)) {
      for (const std::string& text : {t.scene, t.size, t.accelerator, g.cache, g.against}) {
        out += csv_field(text) + ",";
      }
      const std::string columns = figure(find(group, "columns", g.cache)->hits_of_blocked());
      out += figure(g.miss_cost) + "," +
             figure(static_cast<double>(t.blocked) / static_cast<double>(t.rays)) + "," + columns +
             "," + figure(find(group, g.against, g.cache)->hits_of_blocked()) + "," +
             figure(g.tests) + "," + figure(g.equation2) + "," + figure(g.time) + "\n";
    }
  }
  return out;
}

std::string table_of(const std::vector<Trial>& trials) {
  std::string out;
  for (const Group& group : groups_of(trials)) {
    out += heading(group) + "\n";
    for (const Column& c : kColumns) out += padded(c.name);
    out += "\n";
    for (const Trial& t : group) {
      for (const Column& c : kColumns) out += padded(c.text(t));
      out += "\n";
    }
    if (const std::string text = fastest_text(group); !text.empty()) out += text + "\n";
    for (const Gain& g : gains_of(group)) out += gain_text(g) + "\n";
    out += "\n";
  }
  return out;
}

std::string html_of(const std::vector<Trial>& trials, const std::string& command) {
  const std::string title = "Pixel orders and shadow caches";
  std::string body = "<header class=\"head\"><h1>" + title + "</h1>\n<code class=\"command\">" +
                     html_text(command) + "</code></header>\n<main>\n";
  std::size_t number = 0;
  for (const Group& group : groups_of(trials)) body += group_html(group, ++number);
  body += gain_chart(trials) + "</main>\n";
  return tool::page_of(
      {.generator = "lentray-grouping", .title = title, .style = {}, .body = body, .script = {}});
}

}  // namespace lentray::grouping
