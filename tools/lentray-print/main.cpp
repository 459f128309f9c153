// lentray-print: integral images on paper, and pages that measure lens sheets.
#include <exception>
#include <iostream>

#include "parser/base/shown.h"
#include "tools/common/standard_streams.h"
#include "tools/common/version.h"
#include "tools/lentray-print/arguments.h"
#include "tools/lentray-print/commands.h"

namespace lentray::print {
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
      std::cout << "lentray-print " << tool::kVersion << std::endl;
      return kDone;
    }
    const Report report = run_command(arguments);
    for (const std::string& line : report.lines) std::cout << line << '\n';
    for (const std::string& warning : report.warnings)
      std::cerr << "lentray-print: warning: " << warning << std::endl;
    return kDone;
  } catch (const std::exception& e) {
    std::cerr << "lentray-print: " << parser::shown_text(e.what()) << std::endl;
    return kError;
  }
}

}  // namespace
}  // namespace lentray::print

int main(int count, char** words) {
  lentray::tool::hold_standard_streams();
  const int status = lentray::print::run_main(std::vector<std::string>(words + 1, words + count));
  return lentray::tool::finish_standard_output("lentray-print", status);
}
