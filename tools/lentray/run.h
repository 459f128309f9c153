// One run of the program: a picture, or the frames of an animation one after another.
// Errors: as tools/lentray/picture_run.h. Frames that are done stay when a later one fails.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "parser/options/options.h"
#include "tools/lentray/message_form.h"
#include "tools/lentray/warnings.h"

namespace lentray::tool {

/// Exit statuses; 0 to 2 are POV-Ray's.
enum Status : int { kDone = 0, kUserError = 1, kAborted = 2, kInternalError = 3 };

/// `cancel` set from outside ends the run with kAborted and leaves no file behind.
/// `warnings`: what was not said when run() throws, the caller says.
Status run(const parser::RenderOptions& options, const std::atomic<bool>& cancel, MessageForm& form,
           Warnings& warnings);

}  // namespace lentray::tool
