// Plain values as the bytes of a text, one behind another, and back. Bytes are of this machine's kind. Pure
// functions.
#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace lentray::core {

template <class T>
void append_bytes(const T& value, std::string& out) {
  static_assert(std::is_trivially_copyable_v<T>);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A value from the front of `bytes`, which loses it; false if there is no whole one.
template <class T>
bool take_bytes(std::string_view& bytes, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() < sizeof value) return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return true;
}

}  // namespace lentray::core
