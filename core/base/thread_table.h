// A table of what a pure function gave lately, one a thread. A thread gets it when it first asks: a
// thread that never asks has no memory for it. (As a thread_local object it would be cleared, and so
// take memory, whenever a thread starts.)
//
// Table: all its bytes 0 is a table without entries; trivially destructible.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace lentray::core {

namespace thread_table {

/// Bytes that are 0, aligned, until the thread ends. Throws std::bad_alloc.
template <class Table>
[[gnu::noinline]] Table* made() {
  struct Free {
    void operator()(void* bytes) const { std::free(bytes); }
  };
  thread_local std::unique_ptr<void, Free> bytes;
  std::size_t room = sizeof(Table) + alignof(Table);
  bytes.reset(std::calloc(1, room));  // large ones are pages that are taken when they are written
  if (!bytes) throw std::bad_alloc();
  void* at = bytes.get();
  return static_cast<Table*>(std::align(alignof(Table), sizeof(Table), at, room));
}

}  // namespace thread_table

/// The calling thread's.
template <class Table>
[[gnu::always_inline]] inline Table& table_of_thread() {
  static_assert(std::is_trivially_destructible_v<Table>);
  thread_local constinit Table* table = nullptr;
  if (!table) [[unlikely]]
    table = thread_table::made<Table>();
  return *table;
}

}  // namespace lentray::core
