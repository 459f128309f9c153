#include "tools/lentray-batch/table.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/formed.h"
#include "core/base/joined.h"
#include "tools/lentray-batch/page_cards.h"

namespace lentray::batch {
namespace {

std::string number(const char* how, double value) { return core::formed(how, value); }

/// Cells of a table end at "|".
std::string cell(std::string text) {
  std::ranges::replace(text, '|', '/');
  return text;
}

std::string line(const Row& row) {
  const Verdict& v = *row.verdict;
  const bool compared = v.grade != "fails";
  std::string out = "| " + cell(row.name) + " | " + v.grade + " | ";
  if (compared) out += v.psnr ? number("%.1f", *v.psnr) : "equal";
  out += " | ";
  if (compared) out += number("%.2f %%", 100.0 * v.beyond_1);
  out += " | ";
  if (v.noise_rms) out += number("%.2f", v.block_rms) + ", " + number("%.2f", *v.noise_rms);
  out += " | ";
  if (v.noise_rms)
    out += number("%.2f", v.bias) + ", " + number("%.2f", v.noise_bias.value_or(0.0));
  return out + " | " + cell(row.left_out.empty() ? row.reason : core::joined(row.left_out)) +
         " |\n";
}

std::string counts(const std::vector<std::pair<std::string, int>>& rows, const std::string& head) {
  std::string out = "\n| " + head + " | scenes |\n|---|---:|\n";
  for (const auto& [what, count] : rows)
    out += "| " + what + " | " + std::to_string(count) + " |\n";
  return out;
}

}  // namespace

std::string table(const std::vector<Row>& rows, const std::string& command,
                  const std::string& stock) {
  std::map<std::string, int> grades, lacking;
  std::vector<std::string> without;
  int compared = 0, size_known = 0;
  std::string lines, size;
  for (const Row& row : rows) {
    if (!row.verdict || row.verdict->grade.empty()) {
      without.push_back(row.name);
      continue;
    }
    ++compared;
    ++grades[row.verdict->grade];
    for (const std::string& feature : row.left_out) ++lacking[feature];
    if (row.width > 0 && size_known++ == 0)
      size = std::to_string(row.width) + " x " + std::to_string(row.height);
    lines += line(row);
  }
  std::string out =
      "# Existing scenes\n\nWritten by `" + command + "`; do not edit.\n\nScenes of that folder, " +
      size + ", rendered by stock POV-Ray " + stock +
      " and by lentray in the same run.\nGrades: "
      "[compare.md](compare.md); *differs* is short of close, *fails* means no picture.\nOf " +
      std::to_string(rows.size()) + " scenes " + std::to_string(compared) +
      " are compared; the others (named at the end) are parts of a scene, or stock has no\npicture "
      "of them.\n";
  std::vector<std::pair<std::string, int>> list;
  for (const std::string_view grade : kGrades) list.emplace_back(grade, grades[std::string(grade)]);
  out += counts(list, "grade");
  list.assign(lacking.begin(), lacking.end());
  std::ranges::stable_sort(list, std::greater(), &std::pair<std::string, int>::second);
  if (!list.empty())
    out +=
        "\nWhat lentray does not render yet, and says so, by the number of scenes that use it:\n" +
        counts(list, "");
  out +=
      "\nBeyond: share of the pixels that differ by more than 1/255. Blocks, bias: by how much "
      "means of 16 x 16\n"
      "pixels and of all differ from stock's, and S, by how much stock's own do; in 1/255, where "
      "stock's noise counts.\n\n"
      "| scene | grade | PSNR dB | beyond | blocks, S | bias, S | not rendered yet |\n"
      "|---|---|---:|---:|---:|---:|---|\n" +
      lines;
  if (!without.empty()) out += "\nNot compared: " + core::joined(without) + ".\n";
  return out;
}

}  // namespace lentray::batch
