// What a file of POV-Ray's includes declares, by a reader of its own: comments and strings are
// passed over, `#declare` and `#macro` looked for, blocks counted. Knows nothing of the parser.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lentray::test {

struct IncludeNames {
  std::vector<std::string> macros;  ///< in order, once each; not those that macros define
  std::vector<std::string>
      identifiers;  ///< of #declare, also inside macros; macros that are undefined again
};

IncludeNames declared_names(std::string_view sdl);

/// True if `word` stands in the text as a word of its own.
bool has_word(std::string_view text, std::string_view word);

}  // namespace lentray::test
