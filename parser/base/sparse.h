// A value that most of its owners leave as it is made: nothing is stored until it is changed, and
// copies share it until one of them changes it. What is read is never changed: safe from any thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace lentray::parser {

template <typename T>
class Sparse {
 public:
  Sparse() = default;
  Sparse(T value) : m_held(new Held{std::move(value)}) {}
  Sparse(const Sparse& other) : m_held(other.m_held) {
    if (m_held) m_held->owners.fetch_add(1, std::memory_order_relaxed);
  }
  Sparse(Sparse&& other) noexcept : m_held(std::exchange(other.m_held, nullptr)) {}
  Sparse& operator=(Sparse other) noexcept {
    std::swap(m_held, other.m_held);
    return *this;
  }
  ~Sparse() {
    if (m_held && m_held->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete m_held;
  }

  const T& operator*() const { return m_held ? m_held->value : unchanged(); }
  const T* operator->() const { return &**this; }
  /// To be changed; the other copies keep theirs.
  T& edit() {
    if (!m_held)
      *this = Sparse(T{});
    else if (m_held->owners.load(std::memory_order_acquire) > 1)
      *this = Sparse(m_held->value);
    return m_held->value;
  }
  /// False: it is as it is made.
  bool is_stored() const { return m_held != nullptr; }

 private:
  struct Held {
    T value;
    std::atomic<std::uint32_t> owners{1};
  };
  static const T& unchanged() {
    static const T value{};
    return value;
  }
  Held* m_held = nullptr;
};

}  // namespace lentray::parser
