#include "parser/options/output_options.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

#include "parser/options/option_values.h"
#include "parser/options/options.h"

namespace lentray::parser::output_option {
namespace {

struct DitherWord {
  std::string_view word;
  core::DitherMethod method;
};
constexpr DitherWord kMethods[] = {
    {"B2", core::DitherMethod::bayer2}, {"B3", core::DitherMethod::bayer3},
    {"B4", core::DitherMethod::bayer4}, {"D1", core::DitherMethod::line},
    {"D2", core::DitherMethod::plane},  {"FS", core::DitherMethod::floyd_steinberg}};

struct TypeWord {
  std::string_view word;
  core::FileType type;
};
/// Stock knows the letters alone and takes PNG for P, TIFF for T; those words are ours. The first
/// word of a type is the one that is written.
constexpr TypeWord kTypes[] = {{"N", core::FileType::png},
                               {"PNG", core::FileType::png},
                               {"TIFF", core::FileType::tiff},
                               {"TIF", core::FileType::tiff},
                               {"E", core::FileType::exr},
                               {"EXR", core::FileType::exr},
                               {"T", core::FileType::targa},
                               {"TGA", core::FileType::targa},
                               {"C", core::FileType::compressed_targa},
                               {"J", core::FileType::jpeg},
                               {"JPG", core::FileType::jpeg},
                               {"JPEG", core::FileType::jpeg},
                               {"P", core::FileType::ppm},
                               {"PPM", core::FileType::ppm},
                               {"B", core::FileType::bmp},
                               {"BMP", core::FileType::bmp},
                               {"H", core::FileType::radiance},
                               {"HDR", core::FileType::radiance}};

constexpr int kFloatBits = 32;

void set_bits(RenderOptions& o, const GivenOption& g, std::string_view digits) {
  std::from_chars(digits.data(), digits.data() + digits.size(), o.bits);
  if (o.bits != kFloatBits)
    o.bits = static_cast<int>(cut_whole(o, part_of(g, std::string(digits)), 5, 16));
}

}  // namespace

void bits(RenderOptions& o, const GivenOption& g) { set_bits(o, g, g.value); }

void dither_method(RenderOptions& o, const GivenOption& g) {
  for (const auto& [word, method] : kMethods) {
    if (!same_word(word, g.value)) continue;
    o.dither_type = method;
    return;
  }
  refuse(g, "unknown way of dithering: there are B2, B3, B4, D1, D2 and FS");
}

void dither(RenderOptions& o, const GivenOption& g) {
  if (g.sign != 0 && !g.value.empty()) dither_method(o, g);
  o.dither = truth(o, g);
}

void type(RenderOptions& o, const GivenOption& g) {
  std::string_view text = g.value;
  const std::size_t letters =
      std::find_if(text.begin(), text.end(), [](unsigned char c) { return !std::isalpha(c); }) -
      text.begin();
  std::string_view word = text.substr(0, letters);
  const std::string_view digits = text.substr(letters);
  if (!word.empty()) {
    if (same_word(word, "Ng") || same_word(word, "Pg")) {
      o.grayscale = true;
      word = word.substr(0, 1);
    }
    const auto* row = std::find_if(std::begin(kTypes), std::end(kTypes),
                                   [&](const TypeWord& t) { return same_word(t.word, word); });
    if (row == std::end(kTypes)) {
      refuse(g,
             "unknown output type: there are N (PNG), P (PPM), T and C (Targa), J (JPEG), B (BMP), "
             "E (OpenEXR), "
             "H (Radiance) and TIFF; g for grey stands behind N and P");
    }
    o.type = row->type;
    o.type_given = !g.from_defaults;
  }
  if (!digits.empty()) set_bits(o, g, digits);
}

void to_file(RenderOptions& o, const GivenOption& g) {
  if (g.sign == 0) {
    o.output_to_file = truth(o, g);
    return;
  }
  o.output_to_file = g.sign == '+';
  type(o, g);
}

void write_type(const RenderOptions& o, std::string_view name, IniLines& out) {
  out.line(name, std::ranges::find(kTypes, o.type, &TypeWord::type)->word);
}

void write_dither_method(const RenderOptions& o, std::string_view name, IniLines& out) {
  out.line(name, std::ranges::find(kMethods, o.dither_type, &DitherWord::method)->word);
}

}  // namespace lentray::parser::output_option
