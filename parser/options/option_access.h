// How a row of parser/options/options_table.h sets what an option stands for, and writes the line of an INI
// file that asks for it again: once for every kind of member.
// Errors: OptionError. Any number of threads, each with options of its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "parser/options/length.h"
#include "parser/options/option_values.h"
#include "parser/options/options.h"
#include "parser/options/options_table.h"

namespace lentray::parser {

/// A text that a template takes.
template <int N>
struct Word {
  char text[N]{};
  constexpr Word(const char (&t)[N]) { std::copy_n(t, N, text); }
};

/// The part of the options that has this member.
template <typename Part, typename Value>
auto& part_with(auto& o, Value Part::*) {
  if constexpr (std::is_same_v<Part, AnimationOptions>) {
    return o.animation;
  } else if constexpr (std::is_same_v<Part, SceneOverrides>) {
    return o.overrides;
  } else if constexpr (std::is_same_v<Part, RadiosityOverrides>) {
    return o.overrides.radiosity;
  } else if constexpr (std::is_same_v<Part, PhotonOverrides>) {
    return o.overrides.photons;
  } else if constexpr (std::is_same_v<Part, MediaSettings>) {
    return o.overrides.media;
  } else if constexpr (std::is_base_of_v<Part, camera::LensRequest>) {
    return o.lens;
  } else if constexpr (std::is_same_v<Part, ViewOptions>) {
    return o.views;
  } else {
    return o;
  }
}
template <auto member>
auto& field(auto& o) {
  return part_with(o, member).*member;
}
template <typename T>
struct ValueOf {
  using type = T;
};
template <typename T>
struct ValueOf<std::optional<T>> {
  using type = T;
};
/// Its type, of an optional the type within.
template <auto member>
using FieldValue = typename ValueOf<
    std::remove_cvref_t<decltype(field<member>(std::declval<RenderOptions&>()))>>::type;

template <auto member>
void write_field(const RenderOptions& o, std::string_view name, IniLines& out) {
  out.add(name, field<member>(o));
}
/// Nothing for 0, which says that there is none.
template <auto member>
void write_positive(const RenderOptions& o, std::string_view name, IniLines& out) {
  if (field<member>(o) > 0) out.add(name, field<member>(o));
}

template <auto member>
inline constexpr OptionAccess kFlag{
    [](RenderOptions& o, const GivenOption& g) { field<member>(o) = truth(o, g); },
    write_field<member>};

/// As in stock, `Include_Header=` says that there is none.
template <auto member>
inline constexpr OptionAccess kText{[](RenderOptions& o, const GivenOption& g) {
                                      if (g.value.empty() && g.sign != 0)
                                        refuse(g, "a name is expected");
                                      field<member>(o) = g.value;
                                    },
                                    write_field<member>};

/// A whole number of that range; `write` as above.
template <auto member, std::int64_t least, std::int64_t most, auto write = write_field<member>>
inline constexpr OptionAccess kWhole{
    [](RenderOptions& o, const GivenOption& g) {
      field<member>(o) = static_cast<FieldValue<member>>(whole_number(g, least, most));
    },
    write};

/// One of stock's own options, which is cut to the range.
template <auto member, auto least, auto most, auto write = write_field<member>>
inline constexpr OptionAccess kCut{
    [](RenderOptions& o, const GivenOption& g) {
      if constexpr (std::is_floating_point_v<FieldValue<member>>)
        field<member>(o) = cut_number(o, g, least, most);
      else
        field<member>(o) = static_cast<FieldValue<member>>(cut_whole(o, g, least, most));
    },
    write};

template <auto member>
inline constexpr OptionAccess kPositive{
    [](RenderOptions& o, const GivenOption& g) { field<member>(o) = positive(g); },
    write_field<member>};

template <auto member>
inline constexpr OptionAccess kLengthMm{
    [](RenderOptions& o, const GivenOption& g) { field<member>(o) = positive_length_mm(g); },
    write_field<member>};

/// A number that `good` is true of.
template <auto member, bool (*good)(double), Word expected>
inline constexpr OptionAccess kNumber{[](RenderOptions& o, const GivenOption& g) {
                                        const double x = number(g);
                                        if (!good(x)) refuse(g, expected.text);
                                        field<member>(o) = x;
                                      },
                                      write_field<member>};

}  // namespace lentray::parser
