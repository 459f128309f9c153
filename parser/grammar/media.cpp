#include "parser/descriptions/media.h"

#include "parser/grammar/helpers.h"
#include "parser/grammar/nesting.h"
#include "parser/grammar/pattern.h"

namespace lentray::parser {
namespace {

class DensityTarget final : public ColourTarget<DensityDesc, DensityMapDesc> {
 public:
  DensityTarget(DensityDesc& density, MaterialContext& context)
      : ColourTarget("density", density, density.pattern, density.density_map, context) {}

  void read_list(Parser& parser, int count) override {
    set_map(parse_item_list<DensityMapDesc>(
        parser, count, Keyword::kDensity,
        [] { return Ref<DensityDesc>(std::make_shared<DensityDesc>()); },
        [&] { return parse_density(parser, m_context); }));
  }

  void read_item(Parser& parser) override {
    set_map(map_of<DensityMapDesc>(parse_density_body(parser, m_context)));
  }

  bool accept_own_modifier(Parser& parser) override {
    return accept_either_map(parser, Keyword::kDensityMap, parse_density_map);
  }
};

void parse_samples(Parser& parser, MediaDesc& media) {
  media.min_samples = parser.parse_int();
  parser.parse_comma();
  media.max_samples = static_cast<int>(parse_optional_float(parser, media.min_samples));
  if (media.min_samples < 1) parser.fail("media needs at least one sample an interval");
  if (media.max_samples < media.min_samples) {
    parser.fail("the most samples of media are fewer than the least");
  }
}

bool accept_sampling_word(Parser& parser, MediaDesc& media) {
  if (parser.accept(Keyword::kJitter, media.jitter) ||
      parser.accept(Keyword::kVariance, media.variance) ||
      parser.accept(Keyword::kRatio, media.ratio))
    return true;
  if (parser.accept(Keyword::kIntervals)) {
    media.intervals = parser.parse_int();
    if (media.intervals < 1) parser.fail("media needs at least one interval");
  } else if (parser.accept(Keyword::kSamples)) {
    parse_samples(parser, media);
  } else if (parser.accept(Keyword::kMethod)) {
    media.method = parser.parse_int();
    if (media.method < 1 || media.method > 3) parser.fail("the method of media is 1, 2 or 3");
  } else if (parser.accept(Keyword::kAaThreshold)) {
    media.aa_threshold = parser.parse_float();
    if (media.aa_threshold <= 0.0) parser.fail("aa_threshold of media must be greater than 0");
  } else if (parser.accept(Keyword::kAaLevel)) {
    media.aa_level = parser.parse_int();
    if (media.aa_level < 1) parser.fail("aa_level of media must be at least 1");
  } else if (parser.accept(Keyword::kConfidence)) {
    media.confidence = parser.parse_float();
    if (media.confidence < 0.0 || media.confidence >= 1.0) {
      parser.fail("confidence of media is at least 0 and less than 1");
    }
  } else {
    return false;
  }
  return true;
}

void parse_scattering(Parser& parser, ScatteringDesc& scattering) {
  parser.expect(Punct::kLeftCurly);
  scattering.type = parser.parse_int();
  if (scattering.type < 1 || scattering.type > 5) parser.warn("scattering types go from 1 to 5");
  parser.parse_comma();
  if (parser.at_colour() || parser.at_expression()) scattering.colour = parse_rgb(parser);
  for (;;) {
    if (parser.accept(Keyword::kExtinction, scattering.extinction)) continue;
    if (parser.at(Keyword::kEccentricity)) {
      if (scattering.type != 5) parser.fail("eccentricity goes with scattering type 5 only");
      parser.next();
      scattering.eccentricity = parser.parse_float();
    } else {
      break;
    }
  }
  end_block(parser, "one of a color, eccentricity, extinction");
}

bool accept_media_word(Parser& parser, MaterialContext& context, MediaDesc& media) {
  if (accept_sampling_word(parser, media) ||
      accept_rgb(parser, Keyword::kAbsorption, media.absorption) ||
      accept_rgb(parser, Keyword::kEmission, media.emission))
    return true;
  if (parser.accept(Keyword::kScattering)) {
    parse_scattering(parser, media.scattering);
  } else if (parser.accept(Keyword::kCollect)) {
    media.ignore_photons = !(parse_optional_float(parser, 1.0) > 0.0);
  } else if (parser.accept(Keyword::kDensity)) {
    media.densities.push_back(parse_density(parser, context));
  } else if (const auto transform = parser.accept_transforms()) {
    for (Ref<DensityDesc>& density : media.densities)
      density = transformed(std::move(density), *transform);
  } else {
    return false;
  }
  return true;
}

}  // namespace

Ref<DensityDesc> parse_density_body(Parser& parser, MaterialContext& context) {
  return parse_body<DensityTarget>(parser, context, Ref<DensityDesc>());
}

Ref<DensityDesc> parse_density(Parser& parser, MaterialContext& context) {
  parser.expect(Punct::kLeftCurly);
  auto density = parse_density_body(parser, context);
  end_block(parser, kPigmentWords);
  return density;
}

Ref<MediaDesc> parse_media(Parser& parser, MaterialContext& context) {
  auto media = std::make_shared<MediaDesc>();
  const Location where = parser.location();
  parser.expect(Punct::kLeftCurly);
  if (const auto known = parser.accept_value<Ref<MediaDesc>>()) {
    *media = **known;
  } else if (parser.language_version() >= 350) {
    media->method = 3;
    media->intervals = 1;
    media->min_samples = media->max_samples = 10;
  } else {
    media->method = 1;
    media->intervals = 10;
    media->min_samples = media->max_samples = 1;
  }
  media->where = where;
  while (accept_media_word(parser, context, *media)) {
  }
  end_block(parser,
            "one of method, intervals, samples, confidence, variance, ratio, jitter, "
            "aa_level, aa_threshold, absorption, emission, scattering, collect, density, a "
            "transform");
  return media;
}

}  // namespace lentray::parser
