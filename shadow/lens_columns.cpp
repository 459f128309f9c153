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

std::vector<std::vector<std::uint32_t>> columns_by_view(std::size_t width,
                                                        const camera::LensSheet* sheet) {
  std::vector<std::vector<std::uint32_t>> views;
  for (const Strip& lens : lenses_of(static_cast<std::uint32_t>(width), sheet)) {
    for (std::uint32_t k = lens.begin; k < lens.end; ++k) {
      const std::size_t view = sheet == nullptr ? 0 : k - lens.begin;
      if (view >= views.size()) views.resize(view + 1);
      views[view].push_back(k);
    }
  }
  return views;
}

std::vector<Strip> strips_of_lenses(std::size_t width, const camera::LensSheet* sheet,
                                    std::uint32_t strip_width) {
  const std::vector<Strip> lenses = lenses_of(static_cast<std::uint32_t>(width), sheet);
  std::uint32_t widest = 0;
  for (const Strip& lens : lenses) widest = std::max(widest, lens.end - lens.begin);
  std::vector<Strip> strips;
  for (std::uint64_t at = 0; at < widest; at += strip_width) {
    for (const Strip& lens : lenses) {
      const std::uint64_t begin = lens.begin + at;
      if (begin >= lens.end) continue;
      const std::uint64_t end = std::min<std::uint64_t>(lens.end, begin + strip_width);
      strips.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    }
  }
  return strips;
}

}  // namespace lentray::shadow
