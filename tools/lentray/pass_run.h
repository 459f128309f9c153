// The passes of a picture (core/pass/pass_list.h) before its film: with the options' threads, kept in a
// file beside the picture (tools/lentray/pass_file.h), gone on with by +C. One thread.
#pragma once

#include <atomic>
#include <string>

#include "core/pass/pass_list.h"
#include "core/scene/scene.h"
#include "parser/options/options.h"
#include "tools/lentray/identity.h"

namespace lentray::tool {

struct PassSetup {
  const parser::RenderOptions& options;
  const core::Scene& scene;
  const std::string& picture;  ///< the file; empty: there is none, and nothing is kept
  const Identity& identity;
  const std::atomic<bool>& cancel;
  core::Progress* progress = nullptr;  ///< of passes and film together; or null
  double film_work = 0.0;              ///< camera rays
};

/// What became of them.
struct PassesDone {
  bool is_whole = true;   ///< false: cancelled
  std::string kept_in{};  ///< of cancelled ones: the file to go on with; empty: there is none
  std::string trouble{};  ///< why what is done could not be kept, as a sentence; empty: nothing
};

/// Throws what passes throw, and parser::OptionError where what was begun is of something else.
PassesDone run_passes(core::PassList& passes, const PassSetup& setup);

}  // namespace lentray::tool
