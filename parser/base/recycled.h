// An allocator for small things of one kind that come and go by the thousand: what is given back is
// kept for the next, some thousands of them at most. One list a thread; memory may be given back on
// another. With the address sanitizer it is plain allocation, or uses of what was freed would go
// unseen.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace lentray::parser {

#if defined(__has_feature)
#define LENTRAY_HAS_FEATURE(x) __has_feature(x)
#else
#define LENTRAY_HAS_FEATURE(x) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || LENTRAY_HAS_FEATURE(address_sanitizer)
template <typename T>
using Recycled = std::allocator<T>;
#else
template <typename T>
class Recycled {
 public:
  using value_type = T;
  Recycled() = default;
  template <typename U>
  Recycled(const Recycled<U>&) {}

  T* allocate(std::size_t count) {
    Kept& spares = kept();
    Spare* spare = spares.first;
    if (count != 1 || !spare) return static_cast<T*>(::operator new(count * sizeof(T)));
    spares.first = spare->next;
    --spares.count;
    return reinterpret_cast<T*>(spare);
  }
  void deallocate(T* memory, std::size_t count) {
    Kept& spares = kept();
    if (count != 1 || spares.count == kMost) return ::operator delete(memory);
    spares.first = new (static_cast<void*>(memory)) Spare{spares.first};
    ++spares.count;
  }
  bool operator==(const Recycled&) const { return true; }

 private:
  struct Spare {
    Spare* next;
  };
  static constexpr std::size_t kMost = 4096;
  struct Kept {
    Spare* first = nullptr;
    std::size_t count = 0;
    ~Kept() {
      while (first) {
        Spare* next = first->next;
        ::operator delete(first);
        first = next;
      }
    }
  };
  static_assert(sizeof(T) >= sizeof(Spare) && alignof(T) <= alignof(std::max_align_t));

  static Kept& kept() {
    static thread_local Kept all;
    return all;
  }
};
#endif

/// As std::make_shared.
template <typename T, typename... Arguments>
std::shared_ptr<T> make_recycled(Arguments&&... arguments) {
  return std::allocate_shared<T>(Recycled<T>(), std::forward<Arguments>(arguments)...);
}

}  // namespace lentray::parser
