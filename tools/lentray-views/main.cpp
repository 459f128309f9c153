// lentray-views: views, quilts and moving pictures of integral images, and the way back.
#include <iostream>

#include "tools/common/tool_main.h"
#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/tasks.h"

namespace lentray::views {
namespace {

int run(const Arguments& arguments) {
  try {
    const Report report = do_task(arguments);
    std::cout << report.said;
    for (const std::string& warning : report.warnings) {
      std::cerr << "lentray-views: warning: " << warning << "\n";
    }
    return 0;
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("there is not enough memory for these pictures");
  }
}

}  // namespace
}  // namespace lentray::views

int main(int count, char** words) {
  using namespace lentray::views;
  return lentray::tool::tool_main({"lentray-views"}, count, words, parse_arguments, usage, run);
}
