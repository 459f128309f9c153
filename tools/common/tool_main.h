// main() of a program: streams, help and version, and errors as a line on standard error.
#pragma once

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "parser/base/shown.h"
#include "tools/common/standard_streams.h"
#include "tools/common/version.h"

namespace lentray::tool {

struct Program {
  const char* name;
  int error = 1;             ///< status of what was thrown
  bool needs_words = false;  ///< without words it shows its help and fails
};

/// `work(parse(words))` is the exit status, unless the words ask for help or the version.
template <class Parse, class Usage, class Work>
int tool_main(const Program& program, int count, char** arguments, Parse parse, Usage usage,
              Work work) {
  hold_standard_streams();
  const std::vector<std::string> words(arguments + 1, arguments + count);
  const auto has = [&words](const char* word) { return std::ranges::count(words, word) > 0; };
  const auto run = [&]() -> int {
    const bool lacks_words = program.needs_words && words.empty();
    if (lacks_words || has("--help") || has("-?")) {
      std::fputs(usage().c_str(), stdout);
      return lacks_words ? program.error : 0;
    }
    if (has("--version")) {
      std::printf("%s %s\n", program.name, kVersion);
      return 0;
    }
    try {
      return work(parse(words));
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", program.name, parser::shown_text(error.what()).c_str());
      return program.error;
    }
  };
  return finish_standard_output(program.name, run());
}

}  // namespace lentray::tool
