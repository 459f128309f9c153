#include "parser/options/said_options.h"

namespace lentray::parser {

SaidText said_text(const RenderOptions& options, std::span<const std::string> names) {
  SaidText out;
  const auto add = [&](const std::string& name) {
    const auto at = options.said.find(name);
    if (at == options.said.end()) return false;
    if (!out.text.empty()) out.text += ", ";
    out.text += at->second.text;
    if (!at->second.where.empty()) out.text += " in " + at->second.where;
    return true;
  };
  bool of_lens = false;
  for (const std::string& name : names) {
    out.count += add(name) ? 1 : 0;
    of_lens |= name.starts_with("Lens_") && !options.said.contains(name);
  }
  if (of_lens) add("Lens_Sheet");
  return out;
}

std::string with_said(const std::string& message, const SaidText& said) {
  return said.text.empty() ? message : message + " (" + said.text + ")";
}

}  // namespace lentray::parser
