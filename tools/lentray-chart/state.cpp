#include "tools/lentray-chart/state.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "parser/files/watched_files.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"

namespace lentray::chart {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json json_of(const std::optional<Error>& e) {
  if (!e) return nullptr;
  json out{{"rms", e->rms}, {"share", e->share}, {"largest", e->largest}};
  out["psnr"] = e->rms > 0.0 ? json(e->psnr) : json(nullptr);  // infinite
  out["perceived"] = e->perceived ? json(*e->perceived) : json(nullptr);
  return out;
}

std::optional<Error> error_in(const json& j) {
  if (j.is_null()) return std::nullopt;
  Error e;
  j.at("rms").get_to(e.rms);
  j.at("share").get_to(e.share);
  j.at("largest").get_to(e.largest);
  const json& psnr = j.at("psnr");
  e.psnr = psnr.is_null() ? std::numeric_limits<double>::infinity() : psnr.get<double>();
  if (!j.at("perceived").is_null()) e.perceived = j.at("perceived").get<double>();
  return e;
}

json json_of(const Point& p) {
  return {{"id", p.setting.id},
          {"label", p.setting.label},
          {"kind", name_of(p.setting.kind)},
          {"options", p.setting.options},
          {"is_plain", p.setting.is_plain},
          {"state", static_cast<int>(p.state)},
          {"reason", p.reason},
          {"cpu_s", p.cpu_s},
          {"picture", p.picture},
          {"difference", p.difference},
          {"error", json_of(p.error)},
          {"from_plain", json_of(p.from_plain)},
          {"from_stock", json_of(p.from_stock)},
          {"stock_runs", p.stock_runs},
          {"stock_error", json_of(p.stock_error)},
          {"stock_picture", p.stock_picture}};
}

Point point_in(const json& j) {
  Point p;
  j.at("id").get_to(p.setting.id);
  j.at("label").get_to(p.setting.label);
  const auto kind = kind_named(j.at("kind").get<std::string>());
  if (!kind) throw std::runtime_error("unknown kind");
  p.setting.kind = *kind;
  j.at("options").get_to(p.setting.options);
  j.at("is_plain").get_to(p.setting.is_plain);
  const int state = j.at("state").get<int>();
  if (state < 0 || state > static_cast<int>(State::failed)) throw std::runtime_error("bad state");
  p.state = static_cast<State>(state);
  j.at("reason").get_to(p.reason);
  j.at("cpu_s").get_to(p.cpu_s);
  j.at("picture").get_to(p.picture);
  j.at("difference").get_to(p.difference);
  p.error = error_in(j.at("error"));
  p.from_plain = error_in(j.at("from_plain"));
  p.from_stock = error_in(j.at("from_stock"));
  j.at("stock_runs").get_to(p.stock_runs);
  p.stock_error = error_in(j.at("stock_error"));
  j.at("stock_picture").get_to(p.stock_picture);
  return p;
}

json json_of(const Reference& r) {
  return {{"options", r.options}, {"picture", r.picture}, {"change", r.change},
          {"cpu_s", r.cpu_s},     {"steps", r.steps},     {"is_converged", r.is_converged}};
}

Reference reference_in(const json& j) {
  Reference r;
  j.at("options").get_to(r.options);
  j.at("picture").get_to(r.picture);
  j.at("change").get_to(r.change);
  j.at("cpu_s").get_to(r.cpu_s);
  j.at("steps").get_to(r.steps);
  j.at("is_converged").get_to(r.is_converged);
  return r;
}

json json_of(const SceneFacts& f) {
  return {{"width", f.width},
          {"height", f.height},
          {"is_sheet", f.is_sheet},
          {"lens_model", f.lens_model},
          {"area_lights", f.area_lights},
          {"media", f.media},
          {"focal_blur", f.focal_blur},
          {"radiosity_count", f.radiosity_count},
          {"radiosity_bounces", f.radiosity_bounces},
          {"radiosity_error", f.radiosity_error},
          {"photon_gather", f.photon_gather},
          {"photon_count", f.photon_count},
          {"subsurface_samples", f.subsurface_samples},
          {"objects", f.objects},
          {"depth", f.depth},
          {"max_trace_level", f.max_trace_level},
          {"quality_levels", f.quality_levels}};
}

SceneFacts facts_in(const json& j) {
  SceneFacts f;
  j.at("width").get_to(f.width);
  j.at("height").get_to(f.height);
  j.at("is_sheet").get_to(f.is_sheet);
  j.at("lens_model").get_to(f.lens_model);
  j.at("area_lights").get_to(f.area_lights);
  j.at("media").get_to(f.media);
  j.at("focal_blur").get_to(f.focal_blur);
  j.at("radiosity_count").get_to(f.radiosity_count);
  j.at("radiosity_bounces").get_to(f.radiosity_bounces);
  j.at("radiosity_error").get_to(f.radiosity_error);
  j.at("photon_gather").get_to(f.photon_gather);
  j.at("photon_count").get_to(f.photon_count);
  j.at("subsurface_samples").get_to(f.subsurface_samples);
  j.at("objects").get_to(f.objects);
  j.at("depth").get_to(f.depth);
  j.at("max_trace_level").get_to(f.max_trace_level);
  j.at("quality_levels").get_to(f.quality_levels);
  return f;
}

json json_of(const Chart& c) {
  json points = json::array();
  for (const Point& p : c.points) points.push_back(json_of(p));
  return {{"scene", c.scene},
          {"command", c.command},
          {"width", c.width},
          {"height", c.height},
          {"is_sheet", c.is_sheet},
          {"machine", c.machine},
          {"noise", c.noise},
          {"reference", json_of(c.reference)},
          {"lens_reference", c.lens_reference ? json_of(*c.lens_reference) : json(nullptr)},
          {"points", points},
          {"stock", c.stock},
          {"stock_reason", c.stock_reason}};
}

Chart chart_in(const json& j) {
  Chart c;
  j.at("scene").get_to(c.scene);
  j.at("command").get_to(c.command);
  j.at("width").get_to(c.width);
  j.at("height").get_to(c.height);
  j.at("is_sheet").get_to(c.is_sheet);
  j.at("machine").get_to(c.machine);
  j.at("noise").get_to(c.noise);
  c.reference = reference_in(j.at("reference"));
  if (!j.at("lens_reference").is_null()) c.lens_reference = reference_in(j.at("lens_reference"));
  for (const json& p : j.at("points")) c.points.push_back(point_in(p));
  j.at("stock").get_to(c.stock);
  j.at("stock_reason").get_to(c.stock_reason);
  return c;
}

[[noreturn]] void fail(const fs::path& place, int error) {
  throw std::runtime_error("cannot write into the folder '" + place.string() +
                           "': " + std::strerror(error));
}

}  // namespace

std::string change_in(const FilesRead& files) {
  for (const auto& [path, sum] : files.read) {
    const auto now = parser::file_checksum(path);
    if (!now) return path + " is gone";
    if (*now != sum) return path + " has changed";
  }
  for (const std::string& path : files.missing) {
    std::error_code error;
    if (fs::exists(path, error)) return path + " has come to be";
  }
  return "";
}

std::string text_of(const ChartState& state) {
  const json all{{"key", state.key},
                 {"matrix", state.matrix},
                 {"read", state.files.read},
                 {"missing", state.files.missing},
                 {"facts", json_of(state.facts)},
                 {"chart", json_of(state.chart)}};
  return tool::json_text(all, 1) + "\n";
}

ChartState state_of(const std::string& text) {
  try {
    const json all = tool::parse_json(text);
    ChartState state;
    all.at("key").get_to(state.key);
    all.at("matrix").get_to(state.matrix);
    all.at("read").get_to(state.files.read);
    all.at("missing").get_to(state.files.missing);
    state.facts = facts_in(all.at("facts"));
    state.chart = chart_in(all.at("chart"));
    return state;
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("this is no state of a chart: ") + error.what());
  }
}

ChartFolder::ChartFolder(const fs::path& out)
    : m_out(fs::absolute(out).lexically_normal()), m_own(m_out / ".lentray-chart") {
  for (const fs::path& folder : {m_own, m_out / "pictures"}) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail(m_out, error.value());
  }
  m_lock = ::open((m_own / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (m_lock < 0) fail(m_out, errno);
  if (::flock(m_lock, LOCK_EX | LOCK_NB) != 0) {
    ::close(m_lock);
    throw std::runtime_error("another lentray-chart works in '" + m_out.string() + "'");
  }
}

ChartFolder::~ChartFolder() { ::close(m_lock); }

std::optional<ChartState> ChartFolder::load() const {
  std::error_code error;
  if (!fs::exists(own("state.json"), error)) return std::nullopt;
  return state_of(tool::read_text(own("state.json")));
}

void ChartFolder::save(const ChartState& state) const {
  tool::write_whole(own("state.json"), text_of(state));
}

void ChartFolder::remove_pictures() const {
  std::error_code error;
  for (fs::directory_iterator at(m_out / "pictures", error), end; !error && at != end;
       at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() == ".png") fs::remove(at->path(), ignored);
  }
}

}  // namespace lentray::chart
