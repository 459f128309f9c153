// A value that most of its owners leave as it is made: nothing is stored until it is changed, and
// copies share it until one of them changes it. What is read is never changed: safe from any thread.
#pragma once

#include <memory>

namespace lentray::parser {

template <typename T>
class Sparse {
 public:
  Sparse() = default;
  Sparse(T value) : m_value(std::make_shared<T>(std::move(value))) {}

  const T& operator*() const { return m_value ? *m_value : unchanged(); }
  const T* operator->() const { return &**this; }
  /// To be changed; the other copies keep theirs.
  T& edit() {
    if (!m_value) m_value = std::make_shared<T>();
    else if (m_value.use_count() > 1) m_value = std::make_shared<T>(*m_value);
    return *m_value;
  }
  /// False: it is as it is made.
  bool is_stored() const { return m_value != nullptr; }

 private:
  static const T& unchanged() {
    static const T value{};
    return value;
  }
  std::shared_ptr<T> m_value;
};

}  // namespace lentray::parser
