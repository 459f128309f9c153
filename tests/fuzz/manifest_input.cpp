#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/fuzz/input_file.h"
#include "tests/fuzz/text_input.h"
#include "tools/common/json_text.h"
#include "tools/lentray-batch/page_data.h"
#include "tools/lentray-batch/row.h"

namespace lentray::test {
namespace {

using Rows = std::map<std::string, batch::Row>;

/// A manifest of them.
std::string manifest_text(const Rows& rows) {
  std::string text;
  for (const auto& [name, row] : rows) text += tool::json_text(batch::json_of(row)) + "\n";
  return text;
}

void show_rows(const Rows& rows) {
  std::vector<batch::Row> shown;
  for (const auto& [name, row] : rows) shown.push_back(row);
  const std::vector<batch::Card> cards = batch::cards_of(shown);
  batch::summary_of(shown, cards);
  for (const batch::TextLimits& limits : batch::text_limits())
    tool::json_text(batch::page_data(shown, cards, {}, limits));
}

}  // namespace

std::string use_manifest(const std::uint8_t* data, std::size_t size) {
  const Rows rows = batch::rows_in(InputFile(data, size, ".jsonl").path());
  show_rows(rows);
  const std::string text = manifest_text(rows);
  const InputFile written(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(),
                          ".jsonl");
  if (manifest_text(batch::rows_in(written.path())) != text)
    throw std::logic_error("a manifest that was written is read differently: " + text);
  return rows.empty() ? "no rows" : "";
}

}  // namespace lentray::test
