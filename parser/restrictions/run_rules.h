// The one policy of a run with Restrict_IO=On: what its scene may read and write, by the user's own words. No word of
// the scene's, of its INI file or of a file that lies with it takes part. One thread.
#pragma once

#include <string>
#include <vector>

#include "parser/options/options.h"
#include "parser/restrictions/file_rules.h"

namespace lentray::parser {

/// `scene`: where the scene was found. What is wrong with povray.conf becomes warnings. With Permitted_Path= it is not
/// asked.
FileRules run_rules(const RenderOptions& options, const std::string& scene,
                    std::vector<std::string>& warnings);

/// Names of all files that the user's own words have the run write; of a frame those of its own. Empty ones: none.
std::vector<std::string> outputs_of(const RenderOptions& options);

/// Throws OptionError if a name of an output leads out of the current folder through a link in it.
void judge_output(const std::string& name);

/// With Restrict_IO=On: throws OptionError if an output leads out of the current folder through a link in it, or a
/// picture out of the folder that the user named: the link may have come with the scene. Text files there, which are
/// written in place, have no hard links either.
void judge_outputs(const RenderOptions& options);

}  // namespace lentray::parser
