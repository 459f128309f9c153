// Continuing pictures (+C): what of a run's pictures is there already. One thread.
#pragma once

#include <optional>
#include <string>

#include "tools/session/identity.h"

namespace lentray::tool {

/// Whether a picture there can be continued later: a regular file, or nothing yet. Empty and "-" are no
/// files.
bool is_file_place(const std::string& picture);

/// Whether the picture is finished. Throws parser::OptionError if what was begun there is of something
/// else. `identity`: the picture's, without what its scene saw; `scene`: its file, empty if that can be read once
/// only.
bool is_finished(const std::string& picture, const Identity& identity, const std::string& scene);

/// The moment that a picture in the making is of: what `now` said to its scene. Empty: nothing was asked.
std::optional<double> moment_of(const std::string& picture);

}  // namespace lentray::tool
