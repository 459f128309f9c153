#include "tools/lentray-chart/table.h"

#include <algorithm>

#include "core/base/formed.h"
#include "tools/common/csv.h"
#include "tools/common/shell_words.h"

namespace lentray::chart {
namespace {

std::string number(double value) { return core::formed("%.6g", value); }

/// rms, psnr, share, largest
std::string figures(const std::optional<Error>& e) {
  if (!e) return ",,,";
  return number(e->rms) + "," + number(e->psnr) + "," + number(e->share) + "," + number(e->largest);
}

std::string row(const Point& p) {
  const auto yes = [](bool value) { return std::string(value ? "yes" : "no"); };
  std::string out;
  for (const std::string& text :
       {p.setting.id, std::string(name_of(p.setting.kind)), p.setting.label,
        tool::shell_command(p.setting.options), std::string(name_of(p.state)), p.reason}) {
    out += tool::csv_field(text) + ",";
  }
  const bool timed = !p.cpu_s.empty();
  for (const double seconds : {p.seconds(), p.least(), p.most()}) {
    out += (timed ? number(seconds) : "") + ",";
  }
  out += std::to_string(p.cpu_s.size()) + "," + figures(p.error) + "," +
         (p.error && p.error->perceived ? number(*p.error->perceived) : "") + "," +
         (p.error && p.error->seen ? number(*p.error->seen) : "") + "," + yes(p.told_apart) + "," +
         yes(p.on_front) + "," + tool::csv_field(p.dominated_by) + ",";
  out += (p.from_plain ? number(p.from_plain->rms) + "," + number(p.from_plain->largest) : ",");
  out += "," + (p.stock_cpu_s ? number(*p.stock_cpu_s) : "") + "," +
         (p.stock_error ? number(p.stock_error->rms) : "") + "," + figures(p.from_stock) + ",";
  return out + tool::csv_field(p.picture) + "," + tool::csv_field(p.command) + "\n";
}

void add_row(std::string& out, const std::vector<std::string>& cells) {
  constexpr int kWidths[] = {9, 9, 8, 9};
  for (std::size_t i = 0; i < 4; ++i) out += core::formed("%*s  ", kWidths[i], cells[i].c_str());
  out += cells[4] + "\n";
}

std::string front_of(const Chart& chart, bool lens_models) {
  std::vector<const Point*> front;
  for (const Point& p : chart.points) {
    const bool is_lens = p.setting.kind == Kind::lens_model;
    if (p.on_front && is_lens == lens_models) front.push_back(&p);
  }
  if (front.empty()) return "";
  std::ranges::stable_sort(front, {}, [](const Point* p) { return p->seconds(); });
  std::string out = lens_models ? "Lens models, against the truest one:\n"
                                : "Settings that no other one beats in time and error:\n";
  add_row(out, {"CPU s", "rms /255", "PSNR dB", "perceived", "setting"});
  for (const Point* p : front) {
    const Error& e = *p->error;
    add_row(out,
            {core::formed("%.3f", p->seconds()), core::formed("%.3f", e.rms),
             core::formed("%.1f", e.psnr), e.perceived ? core::formed("%.3f", *e.perceived) : "-",
             p->setting.label + (p->told_apart ? "" : " (error not distinguished)")});
  }
  return out;
}

}  // namespace

std::string csv_of(const Chart& chart) {
  std::string out =
      "id,kind,label,options,state,reason,cpu_s,cpu_least_s,cpu_most_s,repeats,rms,psnr,share,"
      "largest,perceived,seen,told_apart,on_front,dominated_by,from_plain_rms,from_plain_largest,"
      "stock_cpu_s,stock_rms,from_stock_rms,from_stock_psnr,from_stock_share,from_stock_largest,"
      "picture,command\n";
  for (const Point& p : chart.points) out += row(p);
  return out;
}

std::string front_table(const Chart& chart) {
  return front_of(chart, false) + front_of(chart, true);
}

}  // namespace lentray::chart
