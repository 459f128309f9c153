// Where reading a scene ends with a message instead of going on for ever: far beyond what scenes
// need, within what machines have. docs/language.md names the values.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lentray::parser {

struct Limits {
  std::uint64_t turns = 10'000'000'000;      ///< of loops, calls of macros and includes, in all
  std::size_t array_elements = 100'000'000;  ///< of one array
  std::size_t string_bytes = 100'000'000;    ///< of one string
  std::size_t nesting = 10'000;              ///< macros and includes within each other
  std::size_t array_depth = 1'000;           ///< arrays in arrays
  std::size_t nested = 1'000'000;          ///< objects or textures in each other; see most_levels()
  std::size_t layers = 10'000;             ///< of one texture
  std::size_t function_depth = 200;        ///< functions calling functions
  std::size_t function_operands = 10'000;  ///< in the text of one function
  double object_parts = 1e8;               ///< in one object or look, each as often as it is used
  double function_terms = 1e6;             ///< of one sum or product
  double function_calls = 1e6;             ///< that one value of a function takes
};

}  // namespace lentray::parser
