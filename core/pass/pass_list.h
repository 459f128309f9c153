// The passes of a picture, one after the other, before its film (core/render/frame.h).
//   PassList passes;
//   passes.add(some_pass);
//   if (!passes.run(options)) return;              // cancelled
//   render_frame(..., passes.film_progress());
// One thread calls.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/pass/pass.h"

namespace lentray::core {

struct PassOptions {
  unsigned threads = 1;
  std::size_t levels = 0;                     ///< Scene::deepest()
  const std::atomic<bool>* cancel = nullptr;  ///< set from outside to stop soon
  Progress* progress = nullptr;               ///< hears of passes and film as one work
  double film_work = 0.0;                     ///< of the film, as Pass::work()
  PassLedger* ledger = nullptr;               ///< keeps what is committed, and continues from it
};

class PassList {
 public:
  /// The pass must outlive the list.
  void add(Pass& pass) { m_passes.push_back(&pass); }
  bool is_empty() const { return m_passes.empty(); }
  /// False if it was cancelled: then results are not whole. Without passes it does nothing.
  bool run(const PassOptions& options);
  /// The listener for the progress of rendering, which counts as the last part of passes and rendering together;
  /// null without PassOptions::progress.
  Progress* film_progress();
  /// Of passes that have ended.
  const std::vector<PassReport>& reports() const { return m_reports; }

 private:
  std::vector<Pass*> m_passes;
  Progress* m_listener = nullptr;
  std::optional<PassProgress> m_progress;
  std::vector<PassReport> m_reports;
};

}  // namespace lentray::core
