// An error: what an earlier run kept for a later one cannot be used.
#pragma once

#include <stdexcept>

namespace lentray::core {

/// A record that is none of the pass's own, though it came back whole.
struct DamagedRecord : std::runtime_error {
  DamagedRecord()
      : std::runtime_error(
            "what was kept of a pass before the picture is damaged; without +C it is begun anew") {}
};

}  // namespace lentray::core
