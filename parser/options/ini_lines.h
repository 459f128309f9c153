// Lines of an INI file on their way to one, each of an option that asks for what there is again.
// Errors: none. Any number of threads, each with lines of its own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace lentray::parser {

class IniLines {
 public:
  /// As it stands, without quotes around it.
  void line(std::string_view name, std::string_view value);
  /// In the quotes with which it is read as it is.
  void add(std::string_view name, const std::string& value);
  template <typename Value>
  requires std::is_arithmetic_v<Value>
  void add(std::string_view name, Value value) {
    if constexpr (std::is_same_v<Value, bool>)
      line(name, value ? "On" : "Off");
    else
      line(name, text_of(static_cast<double>(value)));
  }
  template <typename Value>
  void add(std::string_view name, const std::optional<Value>& value) {
    if (value) add(name, *value);
  }
  /// Whether all of them are read again as what they were.
  bool are_held() const { return m_are_held; }
  std::string take() { return std::move(m_text); }

  /// Shortest text that is read as the same number.
  static std::string text_of(double value);

 private:
  std::string m_text;
  bool m_are_held = true;
};

}  // namespace lentray::parser
