#include "parser/options/paper.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/joined.h"
#include "parser/options/ini.h"

namespace lentray::parser {
namespace {

struct Paper {
  std::string_view name;
  double width, height;
};
constexpr Paper kPapers[] = {
    {"A0", 841.0, 1189.0},   {"A1", 594.0, 841.0},      {"A2", 420.0, 594.0},
    {"A3", 297.0, 420.0},    {"A3+", 329.0, 483.0},     {"A4", 210.0, 297.0},
    {"A5", 148.0, 210.0},    {"A6", 105.0, 148.0},      {"letter", 215.9, 279.4},
    {"legal", 215.9, 355.6}, {"tabloid", 279.4, 431.8}, {"postcard", 105.0, 148.0},
};

std::optional<Extent> paper_named(std::string_view name) {
  const std::size_t mark = name.rfind('-');
  const std::string_view way = mark == std::string_view::npos ? "" : name.substr(mark + 1);
  const bool lies = same_word(way, "landscape");
  if (!way.empty() && !lies && !same_word(way, "portrait")) return std::nullopt;
  const auto paper = std::ranges::find_if(
      kPapers, [&](const Paper& p) { return same_word(p.name, name.substr(0, mark)); });
  if (paper == std::end(kPapers)) return std::nullopt;
  return lies ? Extent{paper->height, paper->width} : Extent{paper->width, paper->height};
}

}  // namespace

Extent paper_extent(const GivenOption& given) {
  if (const auto named = paper_named(given.value)) return *named;
  if (given.value.find('x') == std::string::npos) {
    refuse(given, "the name of a paper (-landscape lays it on its side) or its size is expected: " +
                      paper_names() + ", or 200x100mm");
  }
  return extent_mm(given);
}

std::string paper_names() { return core::joined(kPapers, ", ", &Paper::name); }

}  // namespace lentray::parser
