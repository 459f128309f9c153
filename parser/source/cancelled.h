// What ends the reading of a scene because somebody asked it to stop (ParserOptions::cancel).
#pragma once

#include <exception>

namespace lentray::parser {

class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "reading the scene was stopped"; }
};

}  // namespace lentray::parser
