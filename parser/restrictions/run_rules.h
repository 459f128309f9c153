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

/// Throws OptionError if the picture's place is a link to where the rules permit no writing, and the user named its
/// folder at most: the link may have come with the scene.
void judge_picture(const RenderOptions& options, const std::string& picture);

}  // namespace lentray::parser
