#include "tools/lentray-batch/row.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/common/json_fields.h"
#include "tools/common/json_text.h"
#include "tools/session/seen_json.h"

namespace lentray::batch {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 4> kStates{"done", "failed", "skipped", "waiting"};

State state_named(const std::string& name) {
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (kStates[i] == name) return static_cast<State>(i);
  }
  throw std::invalid_argument("no state of a row: " + name);
}

bool names_places_below(const Row& row) {
  return is_below(row.name) && is_below(row.picture) && std::ranges::all_of(row.views, is_below) &&
         (!row.verdict || (is_below(row.verdict->stock) && is_below(row.verdict->difference)));
}

}  // namespace

bool is_below(const std::string& name) {
  const std::filesystem::path path = name;
  return path.is_relative() && std::ranges::find(path, "..") == path.end();
}

std::string_view name_of(State state) { return kStates.at(static_cast<std::size_t>(state)); }

static void to_json(json& out, State state) { out = name_of(state); }
static void from_json(const json& from, State& state) {
  state = state_named(from.get<std::string>());
}

static void json_members(auto& io, tool::Of<Verdict> auto& v) {
  io.always("grade", v.grade);
  io.given("note", v.note);
  io.given("psnr", v.psnr);
  io.given("beyond_1", v.beyond_1);
  io.given("beyond_2", v.beyond_2);
  io.given("largest", v.largest);
  io.given("block_rms", v.block_rms);
  io.given("bias", v.bias);
  io.given("noise_rms", v.noise_rms);
  io.given("noise_bias", v.noise_bias);
  io.given("noise_cpu_s", v.noise_cpu);
  io.given("stock_cpu_s", v.stock_cpu);
  io.given("stock_wall_s", v.stock_wall);
  io.given("stock", v.stock);
  io.given("difference", v.difference);
  io.given("lens_grades", v.lens_grades);
  io.given("view_grades", v.view_grades);
}

static void json_members(auto& io, tool::Of<Row> auto& r) {
  io("name", r.name);
  io("source", r.source);
  io("state", r.state);
  io.given("frame", r.frame);
  io.given("band", r.band);
  io.given("reason", r.reason);
  io.given("lacks_room", r.lacks_room);
  io.given("command", r.command);
  io.given("status", r.status);
  io.given("messages", r.messages);
  io.given("warnings", r.warnings);
  io.given("kinds", r.kinds);
  io.given("picture", r.picture);
  io.given("width", r.width);
  io.given("height", r.height);
  io.given("bytes", r.bytes);
  io.given("picture_file", r.picture_file);
  io.given("views", r.views);
  io.given("lens_pixels", r.lens_pixels);
  io.given("left_out", r.left_out);
  io.given("wall_s", r.wall);
  io.given("cpu_s", r.cpu);
  io.given("reading_s", r.reading);
  io.given("building_s", r.building);
  io.given("rendering_s", r.rendering);
  io.given("writing_s", r.writing);
  io.given("memory", r.memory);
  io.always("attempts", r.attempts);
  io.given("limits", r.limits);
  io.given("finished", r.finished);
  io.given("verdict", r.verdict);
  io.given("key", r.key);
  json_members(io, r.seen);
}

json json_of(const Row& row) { return row; }

Row row_of(const json& from) try { return from.get<Row>(); } catch (const json::exception& error) {
  throw std::invalid_argument(error.what());
}

std::map<std::string, Row> rows_in(const std::filesystem::path& path, bool* is_cut) {
  std::map<std::string, Row> rows;
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    if (is_cut != nullptr) *is_cut = file.eof();
    const json parsed = tool::json_if_any(line);
    if (parsed.is_discarded()) continue;
    try {
      Row row = row_of(parsed);
      if (names_places_below(row)) rows[row.name] = std::move(row);
    } catch (const std::invalid_argument&) {
      // No row of ours.
    }
  }
  return rows;
}

}  // namespace lentray::batch
