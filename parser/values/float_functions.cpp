#include "parser/values/float_functions.h"

#include <initializer_list>

#include "parser/values/arithmetic.h"

namespace lentray::parser {
namespace {

constexpr FunctionWords function_words() {
  FunctionWords words{};
  const auto of = [&words](Keyword word) -> FunctionWord& {
    return words[static_cast<std::size_t>(word)];
  };
#define LENTRAY_FLOAT_FUNCTION(name, arity, in_functions, undefined, value) \
  of(Keyword::name) = {FunctionKind::arity, core::FunctionOp::name, in_functions};
#include "core/function/float_functions.def"
#undef LENTRAY_FLOAT_FUNCTION
  const auto set = [&of](FunctionKind kind, std::initializer_list<Keyword> keywords) {
    for (const Keyword word : keywords) of(word).kind = kind;
  };
  set(FunctionKind::kUnitVector,
      {Keyword::kX, Keyword::kY, Keyword::kZ, Keyword::kT, Keyword::kU, Keyword::kV});
  set(FunctionKind::kVector,
      {Keyword::kVcross, Keyword::kVnormalize, Keyword::kVrotate, Keyword::kVaxisRotate});
  set(FunctionKind::kString,
      {Keyword::kStr, Keyword::kVstr, Keyword::kConcat, Keyword::kChr, Keyword::kDatetime,
       Keyword::kSubstr, Keyword::kStrupr, Keyword::kStrlwr});
  return words;
}

}  // namespace

constexpr FunctionWords kFunctionWords = function_words();

bool is_defined(core::FunctionOp op, double a, double b) {
  switch (op) {
#define LENTRAY_FLOAT_FUNCTION(name, arity, in_functions, undefined, value) \
  case core::FunctionOp::name:                                              \
    return !(undefined);
#include "core/function/float_functions.def"
#undef LENTRAY_FLOAT_FUNCTION
    default: return true;
  }
}

}  // namespace lentray::parser
