// A blend map: values in ascending order, each with what holds there; between two of them the
// blend. Looked up exactly as stock does: below the first the first holds, from the last on the
// last; of equal values the first is met from below and the last from above; a value equal to an
// entry's is that entry alone. Values are single precision, as in stock.
// Source: reference manual 3.7, "Color Maps"; compared with stock by image.patterns.
#pragma once

#include <algorithm>
#include <cstddef>
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
    double highest = -1e300;
    for (auto& [value, item] : entries) {
      const double rounded = single(value);
      m_values.push_back(rounded);
      // Entries out of order: the first that reaches a value counts, so search their maxima.
      m_reach.push_back(highest = std::max(highest, rounded));
      m_items.push_back(std::move(item));
    }
  }

  Place find(double value) const {
    const std::size_t last = m_values.size() - 1;
    if (value >= m_values[last]) return at(last);
    if (!(m_reach[0] < value)) return at(0);
    const std::size_t i = first_reaching(value);
    if (i > last || value == m_values[i]) return at(std::min(i, last));
    return {&m_items[i - 1], &m_items[i],
            (value - m_values[i - 1]) / (m_values[i] - m_values[i - 1])};
  }

  const std::vector<Item>& items() const { return m_items; }
  const std::vector<double>& values() const { return m_values; }

 private:
  Place at(std::size_t i) const { return {&m_items[i], &m_items[i], 0.0}; }
  std::size_t first_reaching(double value) const {
    return static_cast<std::size_t>(std::lower_bound(m_reach.begin(), m_reach.end(), value) -
                                    m_reach.begin());
  }
  std::vector<double> m_values, m_reach;
  std::vector<Item> m_items;
};

}  // namespace lentray::core
