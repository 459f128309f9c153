// How deep and how large what a description holds is, so that reading can stop before anything that
// goes through it runs out of stack or time. Measured once, when its statement has been read.
#pragma once

#include <algorithm>
#include <cstddef>

namespace lentray::parser {

struct Nesting {
  std::size_t depth = 1;  ///< descriptions within each other, this one included
  double parts = 1.0;     ///< in it, each as often as it is used

  void hold(const Nesting& inner) {
    depth = std::max(depth, inner.depth + 1);
    parts += inner.parts;
  }
};

}  // namespace lentray::parser
