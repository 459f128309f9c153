// The members of a struct as those of a JSON object, listed once for writing and reading:
//
//   static void json_members(auto& io, tool::Of<Size> auto& size) { io("width", size.width); ... }
//
// The list stands beside the struct's namespace, outside of unnamed ones, before its first use; nlohmann::json takes
// and gives such structs then. An optional that is empty is null, and so is what is infinite.
// Errors: nlohmann::json::exception. Threads: any number.
#pragma once

#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <utility>

namespace lentray::tool {

template <class T, class Struct>
concept Of = std::same_as<std::remove_const_t<T>, Struct>;

/// Left out where it says nothing.
template <class T>
void put(nlohmann::json& out, const char* name, const T& value) {
  if (value != T{}) out[name] = value;
}

template <class T>
concept Whole = std::integral<T> && !std::same_as<T, bool>;

/// A number as it is in T. nlohmann::json's own conversion of a fraction is undefined where T does not hold it.
template <Whole T>
T whole_of(const nlohmann::json& from) {
  using nlohmann::json;
  if (from.is_number_float()) {
    const double value = from.get<double>();
    constexpr double kEnd = 2.0 * static_cast<double>(std::numeric_limits<T>::max() / 2 + 1);
    constexpr double kFirst = static_cast<double>(std::numeric_limits<T>::min());
    if (value >= kFirst && value < kEnd) return static_cast<T>(value);
  } else if (from.is_number_unsigned()) {
    if (std::in_range<T>(from.get<std::uint64_t>())) return from.get<T>();
  } else if (!from.is_number_integer() || std::in_range<T>(from.get<std::int64_t>())) {
    return from.get<T>();
  }
  throw json::out_of_range::create(406, from.dump() + " is out of range", &from);
}

/// The same of a member of a struct, be it a number, a map of them or anything else.
template <class T>
T value_of(const nlohmann::json& from) {
  if constexpr (Whole<T>) {
    return whole_of<T>(from);
  } else if constexpr (requires { requires Whole<typename T::mapped_type>; }) {
    T out;
    for (const auto& [name, value] : from.items())
      out[name] = whole_of<typename T::mapped_type>(value);
    return out;
  } else {
    return from.get<T>();
  }
}

class JsonWriter {
 public:
  explicit JsonWriter(nlohmann::json& out) : m_out(out) {}
  template <class T>
  void operator()(const char* name, const T& value) {
    m_out[name] = value;
  }
  /// The same; where it is missing a reader leaves the member as it is.
  template <class T>
  void always(const char* name, const T& value) {
    m_out[name] = value;
  }
  /// As put() has it.
  template <class T>
  void given(const char* name, const T& value) {
    put(m_out, name, value);
  }

 private:
  nlohmann::json& m_out;
};

class JsonReader {
 public:
  explicit JsonReader(const nlohmann::json& from) : m_from(from) {}
  template <class T>
  void operator()(const char* name, T& value) {
    const nlohmann::json& there = m_from.at(name);
    if constexpr (std::is_same_v<T, double>) {
      if (there.is_null()) return void(value = std::numeric_limits<double>::infinity());
    }
    value = value_of<T>(there);
  }
  template <class T>
  void always(const char* name, T& value) {
    if (m_from.contains(name)) (*this)(name, value);
  }
  template <class T>
  void given(const char* name, T& value) {
    always(name, value);
  }

 private:
  const nlohmann::json& m_from;
};

template <class T>
concept Listed = requires(T& value, JsonReader& io) {
  json_members(io, value);
};

}  // namespace lentray::tool

template <lentray::tool::Listed T>
struct nlohmann::adl_serializer<T, void> {
  static void to_json(json& out, const T& value) {
    lentray::tool::JsonWriter io(out);
    json_members(io, value);
  }
  static void from_json(const json& from, T& value) {
    lentray::tool::JsonReader io(from);
    json_members(io, value);
  }
};

template <class T>
struct nlohmann::adl_serializer<std::optional<T>, void> {
  static void to_json(json& out, const std::optional<T>& value) {
    out = value ? json(*value) : json(nullptr);
  }
  static void from_json(const json& from, std::optional<T>& value) {
    if (from.is_null()) {
      value.reset();
    } else {
      value = lentray::tool::value_of<T>(from);
    }
  }
};
