#include "tools/lentray-batch/row.h"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace lentray::batch {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kStates{"done", "failed", "skipped"};

State state_named(const std::string& name) {
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (kStates[i] == name) return static_cast<State>(i);
  }
  throw std::invalid_argument("no state of a row: " + name);
}

/// Members are left out where they are as a new row has them.
template <typename T>
void put_if_given(json& out, const char* name, const T& value) {
  if (value != T{}) out[name] = value;
}

template <typename T>
void take(const json& from, const char* name, T& value) {
  if (const auto at = from.find(name); at != from.end()) value = at->get<T>();
}

template <typename T>
void take_optional(const json& from, const char* name, std::optional<T>& value) {
  if (const auto at = from.find(name); at != from.end()) value = at->get<T>();
}

json to_json(const Verdict& v) {
  json out{{"grade", v.grade}};
  put_if_given(out, "note", v.note);
  if (v.psnr) out["psnr"] = *v.psnr;
  put_if_given(out, "beyond_1", v.beyond_1);
  put_if_given(out, "beyond_2", v.beyond_2);
  put_if_given(out, "largest", v.largest);
  put_if_given(out, "block_rms", v.block_rms);
  put_if_given(out, "bias", v.bias);
  if (v.noise_rms) out["noise_rms"] = *v.noise_rms;
  if (v.noise_bias) out["noise_bias"] = *v.noise_bias;
  put_if_given(out, "noise_cpu_s", v.noise_cpu);
  put_if_given(out, "stock_cpu_s", v.stock_cpu);
  put_if_given(out, "stock_wall_s", v.stock_wall);
  put_if_given(out, "stock", v.stock);
  put_if_given(out, "difference", v.difference);
  put_if_given(out, "lens_grades", v.lens_grades);
  put_if_given(out, "view_grades", v.view_grades);
  return out;
}

Verdict verdict_of(const json& from) {
  Verdict v;
  take(from, "grade", v.grade);
  take(from, "note", v.note);
  take_optional(from, "psnr", v.psnr);
  take_optional(from, "noise_rms", v.noise_rms);
  take_optional(from, "noise_bias", v.noise_bias);
  take(from, "beyond_1", v.beyond_1);
  take(from, "beyond_2", v.beyond_2);
  take(from, "largest", v.largest);
  take(from, "block_rms", v.block_rms);
  take(from, "bias", v.bias);
  take(from, "noise_cpu_s", v.noise_cpu);
  take(from, "stock_cpu_s", v.stock_cpu);
  take(from, "stock_wall_s", v.stock_wall);
  take(from, "stock", v.stock);
  take(from, "difference", v.difference);
  take(from, "lens_grades", v.lens_grades);
  take(from, "view_grades", v.view_grades);
  return v;
}

}  // namespace

std::string_view name_of(State state) { return kStates.at(static_cast<std::size_t>(state)); }

json to_json(const Row& r) {
  json out{{"name", r.name}, {"source", r.source}, {"state", name_of(r.state)}};
  if (r.frame) out["frame"] = *r.frame;
  put_if_given(out, "band", r.band);
  put_if_given(out, "reason", r.reason);
  put_if_given(out, "lacks_room", r.lacks_room);
  put_if_given(out, "command", r.command);
  put_if_given(out, "status", r.status);
  put_if_given(out, "messages", r.messages);
  put_if_given(out, "warnings", r.warnings);
  put_if_given(out, "picture", r.picture);
  put_if_given(out, "width", r.width);
  put_if_given(out, "height", r.height);
  put_if_given(out, "bytes", r.bytes);
  put_if_given(out, "views", r.views);
  put_if_given(out, "lens_pixels", r.lens_pixels);
  put_if_given(out, "left_out", r.left_out);
  put_if_given(out, "wall_s", r.wall);
  put_if_given(out, "cpu_s", r.cpu);
  put_if_given(out, "reading_s", r.reading);
  put_if_given(out, "building_s", r.building);
  put_if_given(out, "rendering_s", r.rendering);
  put_if_given(out, "writing_s", r.writing);
  put_if_given(out, "memory", r.memory);
  out["attempts"] = r.attempts;
  put_if_given(out, "limits", r.limits);
  put_if_given(out, "finished", r.finished);
  if (r.verdict) out["verdict"] = to_json(*r.verdict);
  put_if_given(out, "key", r.key);
  json& files = out["files"] = json::object();
  for (const auto& [path, stamp] : r.files) files[path] = {stamp.size, stamp.modified, stamp.sum};
  put_if_given(out, "missing", r.missing);
  return out;
}

Row row_of(const json& from) try {
  Row r;
  from.at("name").get_to(r.name);
  from.at("source").get_to(r.source);
  r.state = state_named(from.at("state").get<std::string>());
  take_optional(from, "frame", r.frame);
  take(from, "band", r.band);
  take(from, "reason", r.reason);
  take(from, "lacks_room", r.lacks_room);
  take(from, "command", r.command);
  take(from, "status", r.status);
  take(from, "messages", r.messages);
  take(from, "warnings", r.warnings);
  take(from, "picture", r.picture);
  take(from, "width", r.width);
  take(from, "height", r.height);
  take(from, "bytes", r.bytes);
  take(from, "views", r.views);
  take(from, "lens_pixels", r.lens_pixels);
  take(from, "left_out", r.left_out);
  take(from, "wall_s", r.wall);
  take(from, "cpu_s", r.cpu);
  take(from, "reading_s", r.reading);
  take(from, "building_s", r.building);
  take(from, "rendering_s", r.rendering);
  take(from, "writing_s", r.writing);
  take(from, "memory", r.memory);
  take(from, "attempts", r.attempts);
  take(from, "limits", r.limits);
  take(from, "finished", r.finished);
  if (const auto at = from.find("verdict"); at != from.end()) r.verdict = verdict_of(*at);
  take(from, "key", r.key);
  if (const auto files = from.find("files"); files != from.end()) {
    for (const auto& [path, stamp] : files->items()) {
      r.files[path] = {stamp.at(0).get<std::uint64_t>(), stamp.at(1).get<std::int64_t>(),
                       stamp.at(2).get<std::uint64_t>()};
    }
  }
  take(from, "missing", r.missing);
  return r;
} catch (const json::exception& error) {
  throw std::invalid_argument(error.what());
}

}  // namespace lentray::batch
