// What stock's pictures of one scene differ from each other, where they depend on the order of its work
// (core/image/compare.h has the rule): the same pictures with blocks of 8 and of 256 pixels, and with two threads.
// Errors: std::runtime_error. Threads: any number.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "tools/lentray-diff/arguments.h"
#include "tools/lentray-diff/stock.h"

namespace lentray::diff {

/// Of lentray's statistics of the scene.
bool has_noise(AskNoise asked, const nlohmann::json& statistics);

using StockRender = std::function<core::StoredImage(const StockOptions&)>;
/// Three, each by another order of work.
std::vector<core::StoredImage> in_other_orders(const StockRender& render,
                                               const StockOptions& options);

}  // namespace lentray::diff
