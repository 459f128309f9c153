#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/lower_case.h"
#include "core/image/palette_size.h"
#include "parser/base/shown.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

struct ImageType {
  Keyword keyword;
  const char* extension;
};
constexpr ImageType kImageTypes[] = {
    {Keyword::kIff, "iff"},  {Keyword::kGif, "gif"}, {Keyword::kPot, "pot"},
    {Keyword::kSys, "sys"},  {Keyword::kTga, "tga"}, {Keyword::kPng, "png"},
    {Keyword::kPgm, "pgm"},  {Keyword::kPpm, "ppm"}, {Keyword::kJpeg, "jpg"},
    {Keyword::kTiff, "tif"}, {Keyword::kBmp, "bmp"}, {Keyword::kExr, "exr"},
    {Keyword::kHdr, "hdr"},
};

void find_image(Parser& parser, ImageDesc& image, const Location& where) {
  image.where = where;
  auto found = parser.find_to_open(image.name, where);
  if (!found && !std::filesystem::path(image.name).has_extension()) {
    found = parser.find_to_open(image.name + "." + image.type, where);
  }
  if (!found) parser.fail_at(where, "cannot find the image file '" + shown_name(image.name) + "'");
  image.path = std::move(*found);
}

/// Pictures are decoded as the scene stands where they are read; before 3.7 files that do not say what they are
/// stay as they are, and all of them before an assumed_gamma.
void set_decoding(const Parser& parser, ImageDesc& image) {
  using Decoding = ImageDesc::Decoding;
  const bool old = parser.language_version() < 370;
  image.working_gamma = parser.working_gamma().value_or(1.0);
  image.decoding = !old                     ? Decoding::kAll
                   : parser.working_gamma() ? Decoding::kMarked
                                            : Decoding::kNone;
}

int to_size(double x) { return static_cast<int>(std::clamp(x, 0.0, 2147483647.0)); }

void parse_image_function(Parser& parser, ImageDesc& image) {
  const Location where = parser.location();
  image.type = "function";
  const double width = parser.parse_float() + 0.5;
  parser.parse_comma();
  const double height = parser.parse_float() + 0.5;
  check_points(parser, where, width, height);
  image.where = where;
  image.function_width = to_size(width);
  image.function_height = to_size(height);
  if (!parser.at(Punct::kLeftCurly)) parser.fail_expected("{ after the size of the image");
  image.function = parser.parse_function_body();
}

/// That the picture has this entry in its palette; below 0 stock does not look. What is not read (IFF) is not known.
/// `known` keeps what the file has said once.
void check_entry(Parser& parser, const ImageDesc& image, std::optional<int>& known,
                 const char* word, const Location& where, int index) {
  if (image.type == "iff" || image.type == "sys") return;
  const std::string all = std::string(word) + " all is for the whole picture";
  if (!known)
    known =
        image.path.path.empty() ? 0 : core::palette_size(image.path.handle, image.type == "tga");
  const int size = *known;
  if (size == 0) {
    parser.fail_at(where, "expected all: " +
                              (image.path.path.empty() ? "the function" : "'" + image.name + "'") +
                              " has no palette of which this could be an entry; " + all);
  }
  if (index < size) return;
  parser.fail_at(where, "expected an entry of the palette of '" + image.name + "', 0 to " +
                            std::to_string(size - 1) + ", found " + std::to_string(index) + "; " +
                            all);
}

/// `filter all f`, `filter index, f` and the same of transmit.
void parse_transparency(Parser& parser, const ImageDesc& image, std::optional<int>& palette,
                        const char* word, std::optional<double>& all,
                        std::vector<std::pair<int, double>>& entries) {
  if (parser.accept(Keyword::kAll)) {
    all = parser.parse_float();
    entries.clear();  // those that were given before are among all
    return;
  }
  const Location where = parser.location();
  const int index = static_cast<int>(parser.parse_float() + 0.01);
  check_entry(parser, image, palette, word, where, index);
  parser.parse_comma();
  entries.emplace_back(index, parser.parse_float());
}

}  // namespace

std::shared_ptr<ImageDesc> parse_image_source(Parser& parser) {
  auto image = std::make_shared<ImageDesc>();
  // POV-Ray 1 wrote the orientation of the image first.
  if (parser.at_expression()) {
    parser.parse_vector();
    parser.parse_comma();
    if (parser.language_version() >= 150)
      parser.warn("the orientation of an image has no meaning any more");
  }
  const Location where = parser.location();
  const Keyword word =
      parser.peek().kind == TokenKind::kKeyword ? parser.peek().keyword : Keyword::kNone;
  const auto type = std::find_if(std::begin(kImageTypes), std::end(kImageTypes),
                                 [&](const ImageType& t) { return t.keyword == word; });
  if (type != std::end(kImageTypes)) {
    parser.next();
    image->type = type->extension;
    image->name = parser.parse_path();
  } else if (parser.accept(Keyword::kFunction)) {
    parse_image_function(parser, *image);
    return image;
  } else {
    if (parser.at(Punct::kRightCurly)) parser.fail_expected("an image file");
    image->name = parser.parse_path();
    const std::string extension = std::filesystem::path(image->name).extension().string();
    image->type = extension.empty() ? "png" : core::lower_case(extension.substr(1));
  }
  find_image(parser, *image, where);
  set_decoding(parser, *image);
  for (;;) {
    if (parser.accept(Keyword::kGamma)) {
      image->gamma = parser.accept(Keyword::kSrgb) ? -1.0 : parser.parse_float();
    } else if (parser.accept(Keyword::kPremultiplied)) {
      image->premultiplied = parser.parse_bool();
    } else {
      return image;
    }
  }
}

bool accept_image_modifier(Parser& parser, ImageDesc& image) {
  if (parser.accept(Keyword::kMapType, image.map_type) ||
      parser.accept(Keyword::kInterpolate, image.interpolate))
    return true;
  if (parser.accept(Keyword::kOnce)) {
    image.once = true;
  } else if (parser.accept(Keyword::kUseColor)) {
    image.use = ImageDesc::Use::kColour;
  } else if (parser.accept(Keyword::kUseIndex)) {
    image.use = ImageDesc::Use::kIndex;
  } else if (parser.accept(Keyword::kUseAlpha)) {
    image.use = ImageDesc::Use::kAlpha;
  } else if (parser.accept(Keyword::kRepeat)) {
    image.repeat = parse_uv(parser);
    if (image.repeat.u <= 0.0 || image.repeat.v <= 0.0) {
      parser.fail("the repeat of an image must be greater than 0 both ways");
    }
  } else if (parser.accept(Keyword::kOffset)) {
    image.offset = parse_uv(parser);
  } else {
    return false;
  }
  return true;
}

/// As stock, image_map takes only the numbers there are; the other uses of pictures take any.
void check_numbers(Parser& parser, const ImageDesc& image) {
  const auto is_one_of = [](int number, std::initializer_list<int> known) {
    return std::find(known.begin(), known.end(), number) != known.end();
  };
  if (!is_one_of(image.interpolate, {0, 2, 3, 4}))
    parser.fail("interpolate of an image_map is 2, 3 or 4");
  if (!is_one_of(image.map_type, {0, 1, 2, 5}))
    parser.fail("map_type of an image_map is 0, 1, 2 or 5");
}

std::shared_ptr<const ImageDesc> parse_image_map(Parser& parser) {
  parser.expect(Punct::kLeftCurly);
  auto image = parse_image_source(parser);
  std::optional<int> palette;
  for (;;) {
    if (accept_image_modifier(parser, *image)) {
      check_numbers(parser, *image);
      continue;
    }
    if (parser.accept(Keyword::kFilter) || parser.accept(Keyword::kAlpha)) {
      parse_transparency(parser, *image, palette, "filter", image->filter_all, image->filters);
    } else if (parser.accept(Keyword::kTransmit)) {
      parse_transparency(parser, *image, palette, "transmit", image->transmit_all,
                         image->transmits);
    } else {
      break;
    }
  }
  end_block(parser,
            "one of interpolate, map_type, once, use_color, use_index, use_alpha, "
            "repeat, offset, filter, transmit");
  return image;
}

std::shared_ptr<const ImageDesc> parse_bump_map(Parser& parser, double& amount) {
  parser.expect(Punct::kLeftCurly);
  auto image = parse_image_source(parser);
  for (;;) {
    if (accept_image_modifier(parser, *image)) continue;
    if (!parser.accept(Keyword::kBumpSize)) break;
    amount = parser.parse_float();
  }
  end_block(parser,
            "one of interpolate, map_type, once, use_color, use_index, use_alpha, "
            "repeat, offset, bump_size");
  return image;
}

}  // namespace lentray::parser
