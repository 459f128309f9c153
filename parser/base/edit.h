// Changing what is shared: a description is never changed while somebody else refers to it.
#pragma once

#include <memory>

#include "parser/base/recycled.h"

namespace lentray::parser {

/// What `shared` points to, to be changed: itself if nobody else refers to it, else a copy that `shared`
/// refers to from now on. It must have been made as a T that is not constant. One thread.
template <typename T>
T& edit(std::shared_ptr<const T>& shared) {
  if (shared.use_count() != 1) shared = make_recycled<T>(*shared);
  return const_cast<T&>(*shared);
}

}  // namespace lentray::parser
