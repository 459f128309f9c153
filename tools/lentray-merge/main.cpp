// lentray-merge: bands of a picture, rendered apart, become the picture.
#include <exception>
#include <iostream>

#include "parser/base/shown.h"
#include "tools/common/standard_streams.h"
#include "tools/common/version.h"
#include "tools/lentray-merge/arguments.h"
#include "tools/lentray-merge/join.h"

namespace lentray::merge {
namespace {

enum Status : int { kDone = 0, kError = 1 };

int run_main(const std::vector<std::string>& words) {
  try {
    const Arguments arguments = parse_arguments(words);
    if (arguments.help) {
      std::cout << usage();
      return kDone;
    }
    if (arguments.version) {
      std::cout << "lentray-merge " << tool::kVersion << std::endl;
      return kDone;
    }
    std::vector<Part> parts;
    for (std::size_t i = 0; i < arguments.parts.size(); ++i) {
      parts.push_back({arguments.parts[i]});
      if (!arguments.rows.empty()) parts.back().rows = arguments.rows[i];
    }
    join(parts, arguments.out);
    return kDone;
  } catch (const std::exception& e) {
    std::cerr << "lentray-merge: " << parser::shown_text(e.what()) << std::endl;
    return kError;
  }
}

}  // namespace
}  // namespace lentray::merge

int main(int count, char** words) {
  lentray::tool::hold_standard_streams();
  const int status = lentray::merge::run_main(std::vector<std::string>(words + 1, words + count));
  return lentray::tool::finish_standard_output("lentray-merge", status);
}
