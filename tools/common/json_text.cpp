#include "tools/common/json_text.h"

#include <algorithm>
#include <utility>

#include "parser/base/utf8.h"

namespace lentray::tool {

using nlohmann::json;

namespace {

bool is_ascii(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Of all strings, keys too.
void replace(json& value, std::string (*made)(std::string_view)) {
  if (value.is_string()) {
    auto& text = value.get_ref<std::string&>();
    if (!is_ascii(text)) text = made(text);
  } else if (value.is_array()) {
    for (json& part : value) replace(part, made);
  } else if (value.is_object()) {
    const bool is_plain = std::ranges::all_of(
        value.items(), [](const auto& member) { return is_ascii(member.key()); });
    if (!is_plain) {
      json renamed = json::object();
      for (auto& [key, part] : value.items()) renamed[made(key)] = std::move(part);
      value = std::move(renamed);
    }
    for (json& part : value) replace(part, made);
  }
}

bool is_deeper(const json& value, std::size_t levels) {
  if (!value.is_structured()) return false;
  return levels == 0 || std::ranges::any_of(value, [levels](const json& part) {
           return is_deeper(part, levels - 1);
         });
}

}  // namespace

std::string json_text(json value, int indent, bool ascii) {
  replace(value, parser::utf8_of_bytes);
  // Indented text grows with the square of the depth.
  constexpr std::size_t kMostIndented = 1'000;
  return value.dump(is_deeper(value, kMostIndented) ? -1 : indent, ' ', ascii);
}

json parse_json(std::string_view text) {
  json value = json::parse(text);
  replace(value, parser::bytes_of_utf8);
  return value;
}

json json_if_any(std::string_view text) {
  json value = json::parse(text, nullptr, false);
  if (!value.is_discarded()) replace(value, parser::bytes_of_utf8);
  return value;
}

}  // namespace lentray::tool
