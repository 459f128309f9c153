// lentray-views: views, quilts and moving pictures of integral images, and the way back.
#include <exception>
#include <iostream>

#include "parser/base/shown.h"
#include "tools/common/standard_streams.h"
#include "tools/common/version.h"
#include "tools/lentray-views/arguments.h"
#include "tools/lentray-views/tasks.h"

namespace lentray::views {
namespace {

enum Status : int { kDone = 0, kError = 1 };

int run_main(const std::vector<std::string>& words) {
  try {
    const Arguments arguments = parse_arguments(words);
    if (arguments.help) {
      std::cout << usage();
    } else if (arguments.version) {
      std::cout << "lentray-views " << tool::kVersion << "\n";
    } else {
      const Report report = do_task(arguments);
      std::cout << report.said;
      for (const std::string& warning : report.warnings) {
        std::cerr << "lentray-views: warning: " << warning << "\n";
      }
    }
    return kDone;
  } catch (const std::bad_alloc&) {
    std::cerr << "lentray-views: there is not enough memory for these pictures\n";
  } catch (const std::exception& e) {
    std::cerr << "lentray-views: " << parser::shown_text(e.what()) << "\n";
  }
  return kError;
}

}  // namespace
}  // namespace lentray::views

int main(int count, char** words) {
  lentray::tool::hold_standard_streams();
  const int status = lentray::views::run_main(std::vector<std::string>(words + 1, words + count));
  return lentray::tool::finish_standard_output("lentray-views", status);
}
