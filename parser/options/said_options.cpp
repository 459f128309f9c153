#include "parser/options/said_options.h"

#include <algorithm>

namespace lentray::parser {

std::size_t said_count(const RenderOptions& options, std::span<const std::string> names) {
  return static_cast<std::size_t>(std::ranges::count_if(
      names, [&](const std::string& name) { return options.said.contains(name); }));
}

std::string with_said(const std::string& message, const RenderOptions& options,
                      const std::vector<std::string>& names) {
  std::string list;
  const auto add = [&](const std::string& name) {
    const auto at = options.said.find(name);
    if (at == options.said.end()) return;
    const auto& [text, where] = at->second;
    // What the message says itself, and what is on the command line, is found without this.
    if (where.empty() && message.find(text) != std::string::npos) return;
    list += (list.empty() ? "" : ", ") + text + (where.empty() ? "" : " in " + where);
  };
  bool lacks_lens_data = false;
  for (const std::string& name : names) {
    add(name);
    lacks_lens_data |= name.starts_with("Lens_") && !options.said.contains(name);
  }
  if (lacks_lens_data) add("Lens_Sheet");
  return list.empty() ? message : message + " (" + list + ")";
}

}  // namespace lentray::parser
