#include "parser/base/utf8.h"

namespace lentray::parser {
namespace {

unsigned char byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

/// Of the characters U+EF80 to U+EFFF: 0xEE 0xBE 0x80 to 0xEE 0xBF 0xBF.
bool is_byte_character(std::string_view text, std::size_t at) {
  return byte_at(text, at) == 0xEE && (byte_at(text, at + 1) & 0xFE) == 0xBE &&
         (byte_at(text, at + 2) & 0xC0) == 0x80;
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t at) {
  const unsigned char first = byte_at(text, at), second = byte_at(text, at + 1);
  if (at >= text.size()) return 0;
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xC2   ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, at + i) & 0xC0) != 0x80) return 0;
  }
  // Longer than need be, a half of a pair of UTF-16, beyond the last character.
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0)) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90)) return 0;
  return length;
}

std::string utf8_of_bytes(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size());
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = utf8_length(bytes, at);
    if (length > 0 && !is_byte_character(bytes, at)) {
      out.append(bytes.substr(at, length));
      at += length;
      continue;
    }
    const unsigned char byte = byte_at(bytes, at++);
    out += '\xEE';
    out += static_cast<char>(0xBE | (byte >> 6 & 1));
    out += static_cast<char>(0x80 | (byte & 0x3F));
  }
  return out;
}

std::string bytes_of_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    if (is_byte_character(text, at)) {
      out += static_cast<char>(0x80 | (byte_at(text, at + 1) & 1) << 6 |
                               (byte_at(text, at + 2) & 0x3F));
      at += 3;
    } else {
      out += text[at++];
    }
  }
  return out;
}

}  // namespace lentray::parser
