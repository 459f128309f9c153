// The samples of a picture from a file, in as many bytes as they have there: 8 or 16 bits, or float.
// Whatever keeps them, they are read as floats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace lentray::core {

/// Floats until store() says otherwise.
class Samples {
 public:
  class Reference {
   public:
    Reference(Samples& all, std::size_t i) : m_all(all), m_i(i) {}
    operator float() const { return std::as_const(m_all)[m_i]; }
    Reference& operator=(float value) {
      m_all.set(m_i, value);
      return *this;
    }
    Reference& operator=(const Reference& other) { return *this = static_cast<float>(other); }
    Reference& operator+=(float value) { return *this = *this + value; }

   private:
    Samples& m_all;
    std::size_t m_i;
  };

  Samples() = default;
  Samples(std::vector<float> values) : m_values(std::move(values)) {}

  std::size_t size() const {
    return std::visit([](const auto& values) { return values.size(); }, m_values);
  }
  bool empty() const { return size() == 0; }
  float operator[](std::size_t i) const {
    switch (m_values.index()) {
      case 1: return std::get<1>(m_values)[i];
      case 2: return std::get<2>(m_values)[i];
      default: return std::get<0>(m_values)[i];
    }
  }
  Reference operator[](std::size_t i) { return {*this, i}; }
  /// Integers keep the whole part.
  void set(std::size_t i, float value) {
    std::visit(
        [&](auto& values) { values[i] = static_cast<std::decay_t<decltype(values[0])>>(value); },
        m_values);
  }

  /// `count` zeros, stored as `Value`: std::uint8_t, std::uint16_t or float.
  template <typename Value>
  std::vector<Value>& store(std::size_t count) {
    return m_values.emplace<std::vector<Value>>(count);
  }
  template <typename Value>
  std::vector<Value>& store(std::vector<Value> values) {
    return m_values.emplace<std::vector<Value>>(std::move(values));
  }
  template <typename Value>
  bool is_stored_as() const {
    return std::holds_alternative<std::vector<Value>>(m_values);
  }
  /// All of them, which are stored as that.
  template <typename Value>
  std::vector<Value> take() {
    return std::move(std::get<std::vector<Value>>(m_values));
  }
  /// `count` zeros, of that many bits: 8 or 16; 32 are floats.
  void store_bits(int bits, std::size_t count) {
    if (bits == 8) return void(store<std::uint8_t>(count));
    if (bits == 16) return void(store<std::uint16_t>(count));
    assign(count, 0.0f);
  }
  /// `work` gets the vector of all, of whatever type.
  template <typename Work>
  void visit(const Work& work) {
    std::visit(work, m_values);
  }
  template <typename Work>
  void visit(const Work& work) const {
    std::visit(work, m_values);
  }
  void resize(std::size_t count) {
    std::visit([&](auto& values) { values.resize(count); }, m_values);
  }
  void assign(std::size_t count, float value) { m_values.emplace<0>(count, value); }

 private:
  std::variant<std::vector<float>, std::vector<std::uint8_t>, std::vector<std::uint16_t>> m_values;
};

}  // namespace lentray::core
