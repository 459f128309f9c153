// Shadow testers by the name of their cache, as `Shadow_Cache=` takes it.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/trace/shadow_tester.h"

namespace lentray::shadow {

/// auto, off, last, depth, tree, neighbourhood, grid, cascade: in this order.
const std::vector<std::string_view>& tester_names();

/// Throws std::invalid_argument with the list of names for one that is not there.
/// Letter case does not matter.
std::unique_ptr<core::ShadowTesterFactory> make_tester_factory(std::string_view name);

}  // namespace lentray::shadow
