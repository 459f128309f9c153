// lentray-merge: bands of a picture, rendered apart, become the picture.
#include "tools/common/tool_main.h"
#include "tools/lentray-merge/arguments.h"
#include "tools/lentray-merge/join.h"

namespace lentray::merge {
namespace {

int merge(const Arguments& arguments) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < arguments.parts.size(); ++i) {
    parts.push_back({arguments.parts[i]});
    if (!arguments.rows.empty()) parts.back().rows = arguments.rows[i];
  }
  join(parts, arguments.out);
  return 0;
}

}  // namespace
}  // namespace lentray::merge

int main(int count, char** words) {
  using namespace lentray::merge;
  return lentray::tool::tool_main({"lentray-merge"}, count, words, parse_arguments, usage, merge);
}
