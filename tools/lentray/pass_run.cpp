#include "tools/lentray/pass_run.h"

#include <optional>

#include "core/render/frame.h"
#include "tools/lentray/pass_file.h"

namespace lentray::tool {

PassesDone run_passes(core::PassList& passes, const PassSetup& setup) {
  PassesDone out;
  std::optional<PassFile> file;
  if (!passes.is_empty() && !setup.picture.empty()) {
    file.emplace(setup.picture, setup.identity);
    if (setup.options.continues) file->go_on();
  }
  out.is_whole = passes.run({.threads = core::frame_threads({.threads = setup.options.threads}),
                             .levels = setup.scene.deepest(),
                             .cancel = &setup.cancel,
                             .progress = setup.progress,
                             .film_work = setup.film_work,
                             .ledger = file ? &*file : nullptr});
  if (file && !out.is_whole && file->write()) out.kept_in = file->part();
  if (file) out.trouble = file->trouble();
  return out;
}

}  // namespace lentray::tool
