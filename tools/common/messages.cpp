#include "tools/common/messages.h"

#include <sstream>

#include "parser/base/shown.h"

namespace lentray::tool {

std::string one_line(std::string_view text, std::size_t longest) {
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.remove_suffix(1);
  std::string out = parser::shown_name(text.substr(0, 4 * longest));
  if (out.size() <= longest) return out;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0) == 0x80)
    --end;  // not within a UTF-8 character
  return out.substr(0, end) + "...";
}

std::string last_error(std::string_view output) {
  std::istringstream lines{std::string(output)};
  std::string found, last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    last = line;
    const std::size_t error = line.find("rror: ");
    if (error != std::string::npos) found = line.substr(error + 6);
  }
  return one_line(found.empty() ? last : found);
}

}  // namespace lentray::tool
