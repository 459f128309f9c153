#include "tools/lentray-chart/page_data.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/formed.h"
#include "tools/common/json_fields.h"
#include "tools/common/page_text.h"
#include "tools/lentray-chart/charts.h"

namespace lentray::chart {
namespace {

using nlohmann::json;
using tool::put;
constexpr std::size_t kMostText = 4000;  ///< bytes of a reason or a command

/// JSON has no infinity, and four digits are enough.
void put_number(json& out, const char* name, double value) {
  if (std::isfinite(value)) out[name] = std::strtod(core::formed("%.5g", value).c_str(), nullptr);
}

/// Equal pictures have no "psnr".
void put_error(json& out, const char* name, const std::optional<Error>& error) {
  if (!error || !std::isfinite(error->rms)) return;
  json& one = out[name];
  put_number(one, "rms", error->rms);
  put_number(one, "psnr", error->psnr);
  put_number(one, "share", error->share);
  put_number(one, "largest", error->largest);
  if (error->perceived) put_number(one, "perceived", *error->perceived);
  if (error->seen) put_number(one, "seen", *error->seen);
}

void put_place(json& out, const char* name, const std::optional<std::size_t>& place) {
  if (place) out[name] = *place;
}

void put_link(json& out, const char* name, const std::string& file, const PageOptions& options) {
  if (!file.empty()) out[name] = tool::link_to(file, options.folder);
}

json point_data(const Chart& chart, const Point& p, const PointPictures& pictures,
                const PageOptions& options) {
  json out{{"id", p.setting.id},
           {"label", tool::cut_text(p.setting.label, kMostText)},
           {"kind", name_of(p.setting.kind)},
           {"state", name_of(p.state)},
           {"options", p.setting.options}};
  put(out, "plain", p.setting.is_plain);
  put(out, "reason", tool::cut_text(p.reason, kMostText));
  put(out, "command", tool::cut_text(p.command, kMostText));
  if (p.state == State::done) {
    put_number(out, "seconds", p.seconds());
    put_number(out, "least", p.least());
    put_number(out, "most", p.most());
    out["runs"] = p.cpu_s.size();
  }
  put_error(out, "error", p.error);
  put_error(out, "from_plain", p.from_plain);
  put_error(out, "from_stock", p.from_stock);
  put_error(out, "stock_error", p.stock_error);
  if (p.stock_cpu_s) put_number(out, "stock_seconds", *p.stock_cpu_s);
  put(out, "front", p.on_front);
  put(out, "blurred", !p.told_apart);
  put(out, "dominated_by", p.dominated_by);
  put(out, "choosable", can_be_chosen(p));
  put(out, "lens", p.setting.kind == Kind::lens_model && chart.lens_reference.has_value());
  put_place(out, "picture", pictures.picture);
  put_place(out, "difference", pictures.difference);
  put_place(out, "stock", pictures.stock);
  put(out, "problem", pictures.problem);
  put_link(out, "picture_href", p.picture, options);
  put_link(out, "difference_href", p.difference, options);
  put_link(out, "stock_href", p.stock_picture, options);
  return out;
}

}  // namespace

bool can_be_chosen(const Point& p) {
  return p.is_known() && std::isfinite(p.error->rms) && p.setting.kind != Kind::lens_model;
}

json page_data(const Chart& chart, const PageOptions& options, const PagePictures& pictures) {
  json out{{"command", chart.command},
           {"width", chart.width},
           {"height", chart.height},
           {"finished", options.is_finished},
           {"pictures", pictures.jpegs}};
  put_place(out, "reference", pictures.reference);
  put_place(out, "lens_reference", pictures.lens_reference);
  put_link(out, "reference_href", chart.reference.picture, options);
  json& points = out["points"] = json::array();
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    points.push_back(point_data(chart, chart.points[i], pictures.points[i], options));
  }
  return out;
}

}  // namespace lentray::chart
