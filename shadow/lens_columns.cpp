#include "shadow/lens_columns.h"

#include <algorithm>

namespace lentray::shadow {

std::vector<Strip> lenses_of(std::uint32_t width, const camera::LensSheet* sheet) {
  std::vector<Strip> lenses;
  for (std::uint32_t k = 0; k < width; ++k) {
    const bool next =
        k > 0 && sheet != nullptr && sheet->column(k).lens != sheet->column(k - 1).lens;
    if (k == 0 || next) lenses.push_back({k, k});
    lenses.back().end = k + 1;
  }
  return lenses;
}

ColumnLists lists_of_strips(const std::vector<Strip>& lenses, std::uint32_t width,
                            std::uint32_t left, bool joined) {
  std::uint32_t widest = 0;
  for (const Strip& lens : lenses) widest = std::max(widest, lens.end - lens.begin);
  ColumnLists lists;
  for (std::uint64_t at = 0; at < widest; at += width) {
    for (const Strip& lens : lenses) {
      const std::uint64_t begin = lens.begin + at;
      const std::uint64_t end = std::min<std::uint64_t>(lens.end, begin + width);
      for (std::uint64_t k = std::max<std::uint64_t>(begin, left); k < end; ++k) {
        lists.columns.push_back(static_cast<std::uint32_t>(k));
      }
      if (!joined) lists.end_list();
    }
    lists.end_list();
  }
  return lists;
}

}  // namespace lentray::shadow
