// Words for a POSIX shell. Pure functions.
#pragma once

#include <string>
#include <vector>

namespace lentray::tool {

/// As the shell reads it back: in single quotes where the shell would act upon a character.
std::string shell_word(const std::string& word);
/// Words with a blank between them, each as shell_word() has it.
std::string shell_command(const std::vector<std::string>& words);

}  // namespace lentray::tool
