// What libraries made and want back by a function of theirs.
#pragma once

#include <memory>

namespace lentray::core {

template <class T, auto release>
struct Releases {
  void operator()(T* what) const { release(what); }
};
template <class T, auto release>
using Owned = std::unique_ptr<T, Releases<T, release>>;

}  // namespace lentray::core
