// What passes have committed, kept outside so that a run that is cut off can be continued.
// Records are bytes, the passes' own, and come back in the order in which they were kept.
// Threads: one at a time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lentray::core {

class PassLedger {
 public:
  virtual ~PassLedger() = default;
  /// recall() and keep() are of that pass of the list now.
  virtual void begin(std::size_t pass) = 0;
  /// The next record that an earlier run kept; false: there are no more.
  virtual bool recall(std::string& record) = 0;
  virtual void keep(std::string_view record) = 0;
  /// All passes are done.
  virtual void finish() = 0;
};

}  // namespace lentray::core
