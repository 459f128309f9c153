#include "tools/lentray-print/paper.h"

#include "core/base/joined.h"
#include "parser/options/ini.h"

namespace lentray::print {
namespace {

struct Paper {
  std::string_view name;
  double width, height;
};
constexpr Paper kPapers[] = {
    {"A0", 841.0, 1189.0},   {"A1", 594.0, 841.0},      {"A2", 420.0, 594.0},
    {"A3", 297.0, 420.0},    {"A3+", 329.0, 483.0},     {"A4", 210.0, 297.0},
    {"A5", 148.0, 210.0},    {"A6", 105.0, 148.0},      {"letter", 215.9, 279.4},
    {"legal", 215.9, 355.6}, {"tabloid", 279.4, 431.8},
};

}  // namespace

std::optional<parser::Extent> paper_named(std::string_view name) {
  for (const Paper& paper : kPapers) {
    if (parser::same_word(paper.name, name)) return parser::Extent{paper.width, paper.height};
  }
  return std::nullopt;
}

std::string paper_names() { return core::joined(kPapers, ", ", &Paper::name); }

}  // namespace lentray::print
