// An allocator for lists of many megabytes: it asks the system for large pages, which take far less
// time to come by than thousands of small ones. Where there are none it is like any other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace lentray::parser {

inline constexpr std::size_t kLargePage = std::size_t{1} << 21;

/// Asks for them where memory is held and not used yet.
inline void use_large_pages(void* memory, std::size_t bytes) {
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kLargePage - 1) / kLargePage * kLargePage;
  const std::uintptr_t last = (begin + bytes) / kLargePage * kLargePage;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

template <typename T>
struct LargePages {
  using value_type = T;
  LargePages() = default;
  template <typename U>
  LargePages(const LargePages<U>&) {}

  static constexpr std::size_t kLarge = 2 * kLargePage;

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kLarge) return static_cast<T*>(::operator new(bytes));
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    void* memory = std::aligned_alloc(kLargePage, whole);
    if (!memory) throw std::bad_alloc();
    use_large_pages(memory, whole);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    if (count * sizeof(T) < kLarge) ::operator delete(memory);
    else std::free(memory);
  }
  bool operator==(const LargePages&) const { return true; }
};

}  // namespace lentray::parser
