#include "tools/common/page_text.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "parser/base/shown.h"
#include "tools/common/json_text.h"
#include "tools/common/page_sources.h"

namespace lentray::tool {

using nlohmann::json;

std::string html_text(const std::string& text) {
  std::string safe;
  for (const char c : parser::shown_bytes(text)) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      default: safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe;
}

std::string script_text(const json& data) {
  const std::string text = json_text(data, -1, true);
  std::string safe;
  safe.reserve(text.size() + text.size() / 64);
  for (const char c : text) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

std::string link_to(const std::string& file, const std::filesystem::path& folder) {
  static constexpr std::string_view kDigits = "0123456789ABCDEF";
  static constexpr std::string_view kPlain =
      "-._~/0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  std::filesystem::path path(file);
  if (path.is_absolute())
    path = path.lexically_relative(std::filesystem::absolute(folder).lexically_normal());
  const std::string from = path.generic_string();
  std::string link = from.starts_with("../") ? "" : "./";
  for (const char c : from) {
    const auto byte = static_cast<unsigned char>(c);
    if (kPlain.find(c) != std::string_view::npos) {
      link += c;
    } else {
      link += '%';
      link += kDigits[byte >> 4];
      link += kDigits[byte & 15u];
    }
  }
  return link;
}

std::string base64(const std::string& bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63u];
    }
  }
  return text;
}

std::string cut_text(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  for (int i = 0; i < 3 && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u; ++i)
    --end;
  return text.substr(0, end) + "\xE2\x80\xA6";
}

std::string filled(std::string_view frame,
                   const std::vector<std::pair<std::string_view, std::string_view>>& parts) {
  std::string out;
  for (const auto& [name, text] : parts) {
    const std::string mark = "{{" + std::string(name) + "}}";
    const std::size_t at = frame.find(mark);
    out.append(frame.substr(0, at)).append(text);
    frame.remove_prefix(at + mark.size());
  }
  return out.append(frame);
}

std::string page_of(const PageParts& parts) {
  return filled(kFrameHtml, {{"generator", parts.generator},
                             {"title", parts.title},
                             {"shared style", kStyleCss},
                             {"style", parts.style},
                             {"body", parts.body},
                             {"data", parts.data},
                             {"shared script", kScriptJs},
                             {"script", parts.script}});
}

std::size_t bytes_of_frame() { return kFrameHtml.size() + kStyleCss.size() + kScriptJs.size(); }

}  // namespace lentray::tool
