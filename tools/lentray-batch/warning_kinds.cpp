#include "tools/lentray-batch/warning_kinds.h"

#include <algorithm>

namespace lentray::batch {

void note_kind(KindsFound& found, std::string_view line) {
  constexpr std::string_view kBegin = "warning: ";
  if (!line.starts_with(kBegin)) return;
  line.remove_prefix(kBegin.size());
  for (const WarningKind& kind : kWarningKinds) {
    if (!line.starts_with(kind.word)) continue;
    const std::string_view rest = line.substr(kind.word.size());
    if (!rest.starts_with(": ")) continue;
    std::string& text = found[std::string(kind.word)];
    text += (text.empty() ? "" : "\n") + std::string(rest.substr(2));
  }
}

void add_kinds(KindsFound& found, const KindsFound& more) {
  found.insert(more.begin(), more.end());
}

std::size_t warnings_of(const KindsFound& found) {
  std::size_t count = 0;
  for (const auto& [word, text] : found)
    count += 1 + static_cast<std::size_t>(std::ranges::count(text, '\n'));
  return count;
}

std::string text_of(const std::map<std::string, std::size_t>& counts, std::size_t sheets) {
  std::string text;
  for (const WarningKind& kind : kWarningKinds) {
    const auto at = counts.find(std::string(kind.word));
    if (at == counts.end()) continue;
    text += text.empty() ? std::to_string(at->second) + " of " + std::to_string(sheets) +
                               (sheets == 1 ? " sheet " : " sheets ")
                         : ", " + std::to_string(at->second) + " ";
    text += at->second == 1 ? kind.one : kind.many;
  }
  return text;
}

}  // namespace lentray::batch
