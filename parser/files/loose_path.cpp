#include "parser/files/loose_path.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/trimmed.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

bool same_letters(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(),
                                            [&](char x, char y) { return lower(x) == lower(y); });
}

std::vector<std::string> components(const std::string& name) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= name.size()) {
    const std::size_t end = std::min(name.find_first_of("/\\", begin), name.size());
    std::string part(core::trimmed(std::string_view(name).substr(begin, end - begin), " "));
    if (!part.empty() && part != ".") parts.push_back(std::move(part));
    begin = end + 1;
  }
  return parts;
}

std::optional<fs::path> entry(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (name == ".." || fs::exists(folder / name, error)) return folder / name;
  std::optional<fs::path> best;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path found = it->path();
    if (same_letters(found.filename().string(), name) && (!best || found < *best)) best = found;
  }
  return best;
}

}  // namespace

std::optional<std::string> find_loosely(const std::string& folder, const std::string& name) {
  std::vector<std::string> parts = components(name);
  if (parts.empty()) return std::nullopt;
  const bool absolute = name[0] == '/' || name[0] == '\\' || (name.size() > 1 && name[1] == ':');
  if (absolute) parts.erase(parts.begin(), parts.end() - 1);
  fs::path path = folder.empty() ? fs::path(".") : fs::path(folder);
  for (const std::string& part : parts) {
    const auto next = entry(path, part);
    if (!next) return std::nullopt;
    path = *next;
  }
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  return path.string();
}

}  // namespace lentray::parser
