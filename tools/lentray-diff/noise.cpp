#include "tools/lentray-diff/noise.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "tools/lentray-diff/parallel.h"

namespace lentray::diff {

namespace {

/// Members of the statistics of scenes whose light depends on the order in stock.
constexpr std::array kSources{"radiosity", "photons", "subsurface"};

std::vector<StockOptions> other_orders(const StockOptions& options) {
  std::vector<StockOptions> orders(3, options);
  orders[0].block = 8;
  orders[1].block = 256;
  orders[2].threads = 2;
  for (std::size_t i = 0; i < orders.size() && !options.keep.empty(); ++i)
    orders[i].keep = options.keep / ("order" + std::to_string(i + 1));
  return orders;
}

}  // namespace

bool has_noise(AskNoise asked, const nlohmann::json& statistics) {
  if (asked != AskNoise::where_it_is) return asked == AskNoise::always;
  return std::ranges::any_of(kSources, [&](const char* key) { return statistics.contains(key); });
}

std::vector<core::StoredImage> in_other_orders(const StockRender& render,
                                               const StockOptions& options) {
  const std::vector<StockOptions> orders = other_orders(options);
  std::vector<core::StoredImage> pictures(orders.size());
  in_parallel(static_cast<std::uint32_t>(orders.size()), options.processes,
              [&](std::uint32_t i) { pictures[i] = render(orders[i]); });
  return pictures;
}

}  // namespace lentray::diff
