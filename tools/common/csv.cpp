#include "tools/common/csv.h"

#include "core/base/formed.h"

namespace lentray::tool {

std::string number_text(double value) { return core::formed("%.12g", value); }

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += c;
    out += c;
  }
  return out + '"';
}

}  // namespace lentray::tool
