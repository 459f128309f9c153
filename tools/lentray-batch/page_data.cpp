#include "tools/lentray-batch/page_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/lower_case.h"
#include "tools/common/json_fields.h"
#include "tools/common/page_text.h"

namespace lentray::batch {
namespace {

using nlohmann::json;
using tool::cut_text;
using tool::link_to;
using tool::put;

/// Browsers show these.
constexpr std::array<std::string_view, 6> kShown{".png", ".jpg", ".jpeg", ".gif", ".bmp", ".webp"};

bool is_shown_by_browsers(const std::string& file) {
  return std::ranges::count(kShown,
                            core::lower_case(std::filesystem::path(file).extension().string())) > 0;
}

constexpr std::array<std::string_view, 3> kStages{"running", "stopped", "finished"};

/// JSON has no infinity, and three digits are enough of a time.
void put_seconds(json& out, const char* name, double value) {
  if (std::isfinite(value) && value > 0.0) out[name] = std::round(value * 1e4) / 1e4;
}

void put_share(json& out, const char* name, double value) {
  if (std::isfinite(value)) out[name] = value;
}

void put_lines(json& out, const char* name, const std::vector<std::string>& lines, std::size_t most,
               std::size_t line) {
  if (lines.empty()) return;
  json& list = out[name] = json::array();
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
    list.push_back(cut_text(lines[i], line));
}

/// Rows share most of their files: each path is there once.
class Paths {
 public:
  explicit Paths(std::size_t line) : m_line(line) {}
  std::size_t operator()(const std::string& path) {
    const auto [at, is_new] = m_places.try_emplace(path, m_places.size());
    if (is_new) m_list.push_back(cut_text(path, m_line));
    return at->second;
  }
  json list() && { return std::move(m_list); }

 private:
  std::size_t m_line;
  std::map<std::string, std::size_t> m_places{};
  json m_list = json::array();
};

json verdict_data(const Row& row, const PageOptions& options, const TextLimits& limits) {
  const Verdict& v = *row.verdict;
  json out{{"grade", v.grade}};
  put(out, "note", cut_text(v.note, limits.line));
  if (v.psnr && std::isfinite(*v.psnr)) out["psnr"] = *v.psnr;
  put_share(out, "beyond_1", v.beyond_1);
  put_share(out, "beyond_2", v.beyond_2);
  put_share(out, "largest", v.largest);
  if (v.noise_rms) {
    put_share(out, "block_rms", v.block_rms);
    put_share(out, "bias", v.bias);
    put_share(out, "noise_rms", *v.noise_rms);
    put_share(out, "noise_bias", v.noise_bias.value_or(0.0));
    put_seconds(out, "noise_cpu", v.noise_cpu);
  }
  put_seconds(out, "stock_cpu", v.stock_cpu);
  put_seconds(out, "stock_wall", v.stock_wall);
  if (row.cpu > 0.0 && v.stock_cpu > 0.0) out["ratio"] = v.stock_cpu / row.cpu;
  if (!v.stock.empty()) out["stock"] = link_to(v.stock, options.folder);
  if (!v.difference.empty()) out["difference"] = link_to(v.difference, options.folder);
  put(out, "stock_shown", is_shown_by_browsers(v.stock));
  put(out, "difference_shown", is_shown_by_browsers(v.difference));
  put(out, "lens_grades", v.lens_grades);
  put(out, "view_grades", v.view_grades);
  return out;
}

void put_picture(json& out, const Row& row, const PageOptions& options, const TextLimits& limits) {
  if (!row.picture.empty()) {
    out["href"] = link_to(row.picture, options.folder);
    out["file"] = cut_text(row.picture, limits.line);
    put(out, "shown", is_shown_by_browsers(row.picture));
  }
  put(out, "width", row.width);
  put(out, "height", row.height);
  put(out, "bytes", row.bytes);
  if (std::isfinite(row.lens_pixels)) put(out, "lens_pixels", row.lens_pixels);
  put(out, "view_count", row.views.size());
  for (std::size_t i = 0; i < std::min(row.views.size(), limits.words); ++i) {
    out["views"].push_back(link_to(row.views[i], options.folder));
  }
}

void put_files(json& out, const Row& row, const TextLimits& limits, Paths& paths) {
  put(out, "file_count", row.seen.files.size());
  put(out, "missing_count", row.seen.missing.size());
  std::size_t left = limits.files;
  for (const auto& [path, stamp] : row.seen.files) {
    if (left-- == 0) break;
    out["files"].push_back(paths(path));
  }
  left = limits.files;
  for (const std::string& path : row.seen.missing) {
    if (left-- == 0) break;
    out["missing"].push_back(paths(path));
  }
}

void put_kinds(json& out, const KindsFound& kinds, const TextLimits& limits) {
  for (const WarningKind& kind : kWarningKinds) {
    const auto at = kinds.find(std::string(kind.word));
    if (at != kinds.end()) out["kinds"][at->first] = cut_text(at->second, limits.line);
  }
}

json row_data(const Row& row, const PageOptions& options, const TextLimits& limits, Paths& paths) {
  json out{{"state", name_of(row.state)}};
  if (row.frame) out["frame"] = *row.frame;
  put(out, "source", cut_text(row.source, limits.line));
  put(out, "reason", cut_text(row.reason, limits.line));
  put_lines(out, "command", row.command, limits.words, limits.line);
  put(out, "command_words", row.command.size());
  put(out, "status", row.status);
  put_lines(out, "messages", row.messages, limits.messages, limits.line);
  put(out, "message_count", row.messages.size());
  put(out, "warnings", row.warnings);
  put_kinds(out, row.kinds, limits);
  put_picture(out, row, options, limits);
  put_lines(out, "left_out", row.left_out, limits.words, limits.line);
  put_seconds(out, "wall", row.wall);
  put_seconds(out, "cpu", row.cpu);
  put_seconds(out, "reading", row.reading);
  put_seconds(out, "building", row.building);
  put_seconds(out, "rendering", row.rendering);
  put_seconds(out, "writing", row.writing);
  put(out, "memory", row.memory);
  if (row.attempts != 1) out["attempts"] = row.attempts;
  put(out, "finished", cut_text(row.finished, limits.line));
  if (row.verdict) out["verdict"] = verdict_data(row, options, limits);
  put_files(out, row, limits, paths);
  return out;
}

json card_data(const Card& card, const TextLimits& limits) {
  json out{{"name", cut_text(card.name, limits.line)},
           {"rows", card.rows},
           {"state", name_of(card.state)}};
  put(out, "animation", card.is_animation);
  put(out, "warnings", card.warnings);
  put(out, "others", card.others);
  put_kinds(out, card.kinds, limits);
  put_seconds(out, "time", card.time);
  put(out, "slow", card.is_slow);
  put(out, "left_out", card.has_left_out);
  put(out, "grade", card.grade);
  put(out, "differs", is_differing(card));
  if (card.ratio) out["ratio"] = *card.ratio;
  return out;
}

json summary_data(const Summary& sum, const PageOptions& options) {
  json out{{"cards", sum.cards},
           {"done", sum.done},
           {"failed", sum.failed},
           {"skipped", sum.skipped},
           {"waiting", sum.waiting},
           {"made", sum.made},
           {"warned", sum.warned},
           {"kinds", sum.kinds},
           {"kinds_text", text_of(sum.kinds, sum.done)},
           {"slow", sum.slow},
           {"differing", sum.differing},
           {"compared", sum.is_compared},
           {"grades", sum.grades},
           {"memory", sum.memory},
           {"stage", kStages.at(static_cast<std::size_t>(options.stage))},
           {"restricted", options.restricts},
           {"expected", options.expected_rows}};
  put_seconds(out, "cpu", sum.cpu);
  put_seconds(out, "wall", options.wall);
  if (sum.median_ratio) out["median_ratio"] = *sum.median_ratio;
  return out;
}

}  // namespace

const std::vector<TextLimits>& text_limits() {
  static const std::vector<TextLimits> all{{400, 2000, 200, 400},
                                           {80, 600, 60, 100},
                                           {20, 300, 40, 20},
                                           {4, 200, 20, 0},
                                           {1, 100, 0, 0}};
  return all;
}

json page_data(const std::vector<Row>& rows, const std::vector<Card>& cards,
               const PageOptions& options, const TextLimits& limits) {
  json out;
  out["title"] = options.title;
  out["summary"] = summary_data(summary_of(rows, cards), options);
  out["summary"]["row_count"] = rows.size();
  Paths paths(limits.line);
  json& list = out["rows"] = json::array();
  for (const Row& row : rows) list.push_back(row_data(row, options, limits, paths));
  json& card_list = out["cards"] = json::array();
  for (const Card& card : cards) card_list.push_back(card_data(card, limits));
  out["paths"] = std::move(paths).list();
  return out;
}

}  // namespace lentray::batch
