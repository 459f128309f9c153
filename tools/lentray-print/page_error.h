// What cannot be printed as it was asked for, worded for the user.
#pragma once

#include <stdexcept>

namespace lentray::print {

class PageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lentray::print
