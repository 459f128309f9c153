// Which members a description has, so that they can be visited by name.
//
// LENTRAY_FIELDS(Type, a, b, c) lists them. A list that lacks a member does not compile: it opens
// the type in a structured binding, whose number of names must be the type's number of members.
#pragma once

namespace lentray::parser {

/// Fields<T>::visit(value, f) calls f("name", value.name) for each member, in the list's order.
template <typename T>
struct Fields;

template <typename T>
concept HasFields = requires(const T& value) {
  Fields<T>::visit(value, [](const char*, const auto&) {});
};

}  // namespace lentray::parser

// One level expands four times, four levels 256 times: enough for any description.
#define LENTRAY_EXPAND(...) \
  LENTRAY_EXPAND3(LENTRAY_EXPAND3(LENTRAY_EXPAND3(LENTRAY_EXPAND3(__VA_ARGS__))))
#define LENTRAY_EXPAND3(...) \
  LENTRAY_EXPAND2(LENTRAY_EXPAND2(LENTRAY_EXPAND2(LENTRAY_EXPAND2(__VA_ARGS__))))
#define LENTRAY_EXPAND2(...) \
  LENTRAY_EXPAND1(LENTRAY_EXPAND1(LENTRAY_EXPAND1(LENTRAY_EXPAND1(__VA_ARGS__))))
#define LENTRAY_EXPAND1(...) __VA_ARGS__
#define LENTRAY_PARENTHESES ()
#define LENTRAY_VISIT_NEXT(name, ...) \
  visitor_(#name, value_.name);       \
  __VA_OPT__(LENTRAY_VISIT_AGAIN LENTRAY_PARENTHESES(__VA_ARGS__))
#define LENTRAY_VISIT_AGAIN() LENTRAY_VISIT_NEXT

#define LENTRAY_FIELDS(Type, ...)                                                                  \
  template <>                                                                                      \
  struct Fields<Type> {                                                                            \
    static void check(const Type& value_) { [[maybe_unused]] const auto& [__VA_ARGS__] = value_; } \
    template <typename Visitor>                                                                    \
    static void visit(const Type& value_, Visitor&& visitor_) {                                    \
      LENTRAY_EXPAND(LENTRAY_VISIT_NEXT(__VA_ARGS__))                                              \
    }                                                                                              \
  };
