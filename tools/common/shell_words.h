// Words for a POSIX shell. Pure functions.
#pragma once

#include <string>
#include <vector>

namespace lentray::tool {

inline void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// As the shell reads it back: in single quotes where the shell would act upon a character.
std::string shell_word(const std::string& word);
/// Words with a blank between them, each as shell_word() has it.
std::string shell_command(const std::vector<std::string>& words);

}  // namespace lentray::tool
