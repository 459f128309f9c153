// What keywords are when they are functions: how expressions read them, and what those of floats
// do. The functions of floats come from core/function/float_functions.def. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>

#include "core/function/operation.h"
#include "parser/tokens/token.h"

namespace lentray::parser {

/// What a keyword takes and gives, if a pure function or a constant.
enum class FunctionKind : std::uint8_t {
  kNone,
  kOneFloat,    ///< of one float
  kTwoFloats,   ///< of two: atan2, div, mod, pow
  kFold,        ///< of any number, one after the other: min, max, bitwise_and ...
  kUnitVector,  ///< x, y, z, t, u, v
  kVector,      ///< the functions whose value is a vector
  kString       ///< those whose value is a string
};

struct FunctionWord {
  FunctionKind kind = FunctionKind::kNone;
  core::FunctionOp op = core::FunctionOp::kConstant;  ///< of floats: for core::apply()
  bool in_functions = false;  ///< user-defined functions have it, of more than constants
};

using FunctionWords = std::array<FunctionWord, static_cast<std::size_t>(Keyword::kEndOfKeywords)>;
extern const FunctionWords kFunctionWords;

inline const FunctionWord& function_word(Keyword word) {
  return kFunctionWords[static_cast<std::size_t>(word)];
}
inline FunctionKind function_kind(Keyword word) { return function_word(word).kind; }

/// Whether a function of floats has a value there, of one float for any b.
bool is_defined(core::FunctionOp op, double a, double b = 0.0);

}  // namespace lentray::parser
