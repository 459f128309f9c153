// lentray-print: integral images on paper, and pages that measure lens sheets.
#include <iostream>

#include "tools/common/tool_main.h"
#include "tools/lentray-print/arguments.h"
#include "tools/lentray-print/commands.h"

namespace lentray::print {
namespace {

int print(const Arguments& arguments) {
  const Report report = run_command(arguments);
  for (const std::string& line : report.lines) std::cout << line << '\n';
  for (const std::string& warning : report.warnings)
    std::cerr << "lentray-print: warning: " << warning << std::endl;
  return 0;
}

}  // namespace
}  // namespace lentray::print

int main(int count, char** words) {
  using namespace lentray::print;
  return lentray::tool::tool_main({"lentray-print"}, count, words, parse_arguments, usage, print);
}
