// What cannot be built of a description that was read without fault: a picture that is too small, a
// spline of too few points. The description's place goes with it.
#pragma once

#include <stdexcept>
#include <string>

#include "parser/source/source.h"

namespace lentray::parser {

class BuildError : public std::runtime_error {
 public:
  BuildError(const Location& where, const std::string& message)
      : std::runtime_error(message), m_where(where) {}
  const Location& where() const { return m_where; }

 private:
  Location m_where;
};

}  // namespace lentray::parser
