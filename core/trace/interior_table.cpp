#include "core/trace/interior_table.h"

#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

constexpr std::size_t kSlots = 64, kMostStacks = 1 << 16;

}  // namespace

InteriorTable::InteriorTable() { clear(); }

void InteriorTable::clear() {
  m_stacks.assign(1, {{0, nullptr, true}, 0, InteriorsId::kOpen, InteriorsId::kOpen, true});
  m_slots.assign(kSlots, InteriorsId::kOpen);
}

bool InteriorTable::forget_if_large() {
  if (m_stacks.size() < kMostStacks) return false;
  clear();
  return true;
}

/// Where that stack is, or a free slot for it.
InteriorsId& InteriorTable::slot(InteriorsId id, const InteriorEntry& entry) {
  const std::size_t mask = m_slots.size() - 1;
  std::size_t i = mixed(entry.key + (std::uint64_t{static_cast<std::uint32_t>(id)} << 32)) & mask;
  while (m_slots[i] != InteriorsId::kOpen &&
         !(around(m_slots[i]) == id && is_entry(m_slots[i], entry))) {
    i = (i + 1) & mask;
  }
  return m_slots[i];
}

void InteriorTable::grow_slots() {
  m_slots.assign(2 * m_slots.size(), InteriorsId::kOpen);
  for (std::uint32_t i = 1; i < m_stacks.size(); ++i) {
    slot(m_stacks[i].around, m_stacks[i].entry) = InteriorsId{i};
  }
}

InteriorsId InteriorTable::find(InteriorsId id, const InteriorEntry& entry) {
  if (2 * m_stacks.size() >= m_slots.size()) grow_slots();
  InteriorsId& found = slot(id, entry);
  if (found == InteriorsId::kOpen) {
    found = InteriorsId{static_cast<std::uint32_t>(m_stacks.size())};
    m_stacks.push_back(
        {entry, stack(id).size + 1, id, InteriorsId::kOpen, stack(id).hollow && entry.hollow});
  }
  m_stacks[static_cast<std::uint32_t>(id)].latest = found;
  return found;
}

InteriorsId InteriorTable::remove_among(InteriorsId id, std::uintptr_t key) {
  InteriorsId outermost = InteriorsId::kOpen;
  for (InteriorsId i = id; i != InteriorsId::kOpen; i = around(i)) {
    if (back(i).key == key) outermost = i;
  }
  if (outermost == InteriorsId::kOpen) return id;
  m_above.clear();
  for (InteriorsId i = id; i != outermost; i = around(i)) m_above.push_back(i);
  InteriorsId left = around(outermost);
  for (auto i = m_above.rbegin(); i != m_above.rend(); ++i) {
    const InteriorEntry entry = back(*i);
    left = push(left, entry);
  }
  return left;
}

}  // namespace lentray::core
