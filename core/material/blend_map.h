// A blend map: values in ascending order, each with what holds there; between two of them the
// blend. Below the first the first holds, from the last on the
// last; of equal values the first is met from below and the last from above; a value equal to an
// entry's is that entry alone. Values are single precision.
// Copies share the entries: a map that many pigments have is held once.
// Source: reference manual 3.7, "Color Maps"; compared with stock by tests/image/patterns_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/pattern/single.h"

namespace lentray::core {

template <typename Item>
class BlendMap {
 public:
  /// Where a value falls: `fraction` of the way from `before` to `after`, the same entry at ends.
  struct Place {
    const Item* before;
    const Item* after;
    double fraction;
  };

  explicit BlendMap(std::vector<std::pair<double, Item>> entries) {
    auto made = std::make_shared<Entries>();
    made->values.reserve(entries.size());
    made->reach.reserve(entries.size());
    made->items.reserve(entries.size());
    double highest = -1e300;
    for (auto& [value, item] : entries) {
      const double rounded = single(value);
      made->values.push_back(rounded);
      made->reach.push_back(highest = std::max(highest, rounded));
      made->items.push_back(std::move(item));
    }
    m_entries = std::move(made);
  }

  Place find(double value) const {
    const std::vector<double>& values = m_entries->values;
    const std::vector<double>& reach = m_entries->reach;
    const std::vector<Item>& items = m_entries->items;
    const auto at = [&](std::size_t i) { return Place{&items[i], &items[i], 0.0}; };
    const std::size_t last = values.size() - 1;
    if (value >= values[last]) return at(last);
    if (!(reach[0] < value)) return at(0);
    const auto i = static_cast<std::size_t>(std::lower_bound(reach.begin(), reach.end(), value) -
                                            reach.begin());
    if (i > last || value == values[i]) return at(std::min(i, last));
    return {&items[i - 1], &items[i], (value - values[i - 1]) / (values[i] - values[i - 1])};
  }

  const std::vector<Item>& items() const { return m_entries->items; }
  const std::vector<double>& values() const { return m_entries->values; }

 private:
  struct Entries {
    std::vector<double> values;
    /// The greatest so far: of entries out of order the first that reaches a value counts.
    std::vector<double> reach;
    std::vector<Item> items;
  };
  std::shared_ptr<const Entries> m_entries;
};

/// Height and slope of a point of a slope_map.
struct SlopePoint {
  double height = 0.0, slope = 0.0;
};

}  // namespace lentray::core
