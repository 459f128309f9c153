#include "tools/lentray-chart/state.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "core/base/ignored_error.h"
#include "parser/base/shown.h"
#include "tools/common/json_fields.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"
#include "tools/session/seen_json.h"

namespace lentray::chart {

namespace fs = std::filesystem;
using nlohmann::json;

static void to_json(json& out, Kind kind) { out = name_of(kind); }
static void from_json(const json& from, Kind& kind) {
  const auto known = kind_named(from.get<std::string>());
  if (!known) throw std::runtime_error("unknown kind");
  kind = *known;
}

static void to_json(json& out, State state) { out = static_cast<int>(state); }
static void from_json(const json& from, State& state) {
  const int number = tool::whole_of<int>(from);
  if (number < 0 || number > static_cast<int>(State::failed)) throw std::runtime_error("bad state");
  state = static_cast<State>(number);
}

static void json_members(auto& io, tool::Of<Error> auto& e) {
  io("rms", e.rms);
  io("share", e.share);
  io("largest", e.largest);
  io("psnr", e.psnr);
  io("perceived", e.perceived);
  io("seen", e.seen);
}

static void json_members(auto& io, tool::Of<Point> auto& p) {
  io("id", p.setting.id);
  io("label", p.setting.label);
  io("kind", p.setting.kind);
  io("options", p.setting.options);
  io("is_plain", p.setting.is_plain);
  io("state", p.state);
  io("reason", p.reason);
  io("cpu_s", p.cpu_s);
  io("picture", p.picture);
  io("difference", p.difference);
  io("error", p.error);
  io("from_plain", p.from_plain);
  io("from_stock", p.from_stock);
  io("stock_runs", p.stock_runs);
  io("stock_error", p.stock_error);
  io("stock_picture", p.stock_picture);
}

static void json_members(auto& io, tool::Of<Reference> auto& r) {
  io("options", r.options);
  io("picture", r.picture);
  io("change", r.change);
  io("cpu_s", r.cpu_s);
  io("steps", r.steps);
  io("is_converged", r.is_converged);
}

static void json_members(auto& io, tool::Of<SceneFacts> auto& f) {
  io("width", f.width);
  io("height", f.height);
  io("is_sheet", f.is_sheet);
  io("lens_model", f.lens_model);
  io("area_lights", f.area_lights);
  io("media", f.media);
  io("focal_blur", f.focal_blur);
  io("radiosity_count", f.radiosity_count);
  io("radiosity_bounces", f.radiosity_bounces);
  io("radiosity_error", f.radiosity_error);
  io("photon_gather", f.photon_gather);
  io("photon_count", f.photon_count);
  io("subsurface_samples", f.subsurface_samples);
  io("objects", f.objects);
  io("depth", f.depth);
  io("max_trace_level", f.max_trace_level);
  io("quality_levels", f.quality_levels);
}

static void json_members(auto& io, tool::Of<Chart> auto& c) {
  io("scene", c.scene);
  io("command", c.command);
  io("width", c.width);
  io("height", c.height);
  io("is_sheet", c.is_sheet);
  io("machine", c.machine);
  io("noise", c.noise);
  io("reference", c.reference);
  io("lens_reference", c.lens_reference);
  io("points", c.points);
  io("stock", c.stock);
  io("stock_reason", c.stock_reason);
}

static void json_members(auto& io, tool::Of<ChartState> auto& state) {
  io("key", state.key);
  io("matrix", state.matrix);
  json_members(io, state.seen);
  io("facts", state.facts);
  io("chart", state.chart);
}

std::string text_of(const ChartState& state) { return tool::json_text(state, 1) + "\n"; }

ChartState state_of(const std::string& text) {
  try {
    return tool::parse_json(text).get<ChartState>();
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("this is no state of a chart: ") + error.what());
  }
}

ChartFolder::ChartFolder(const fs::path& out)
    : OwnFolder(fs::absolute(out).lexically_normal(), "lentray-chart"),
      m_out(fs::absolute(out).lexically_normal()) {
  tool::make_folder(m_out / "pictures", m_out);
}

fs::path ChartFolder::file(const std::string& relative) const {
  const fs::path name = fs::path(relative).lexically_normal();
  if (name.is_absolute() || (!name.empty() && *name.begin() == ".."))
    throw std::runtime_error("the chart's state names a file elsewhere: '" +
                             parser::shown_name(relative) + "'");
  return m_out / name;
}

std::optional<ChartState> ChartFolder::load() const {
  if (!fs::exists(own("state.json"), core::ignored_error())) return std::nullopt;
  return state_of(tool::read_text(own("state.json")));
}

void ChartFolder::save(const ChartState& state) const {
  tool::write_whole(own("state.json"), text_of(state));
}

void ChartFolder::remove_pictures() const {
  std::error_code error;
  for (fs::directory_iterator at(m_out / "pictures", error), end; !error && at != end;
       at.increment(error)) {
    if (at->path().extension() == ".png") fs::remove(at->path(), core::ignored_error());
  }
}

}  // namespace lentray::chart
