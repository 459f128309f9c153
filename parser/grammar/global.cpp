#include "parser/grammar/global.h"

#include <algorithm>
#include <memory>
#include <string>

#include "core/photon/photon_file.h"
#include "parser/base/shown.h"
#include "parser/files/opened_file.h"
#include "parser/grammar/helpers.h"

namespace lentray::parser {
namespace {

constexpr int kTraceLevelLimit = 256;  ///< stock's
constexpr int kMostNearest = 20, kMostBounces = 20;

using Setting = void (*)(Parser&, GlobalDesc&);
struct SettingEntry {
  Keyword keyword;
  Setting read;
};

void check(Parser& parser, bool good, const char* message) {
  if (!good) parser.fail(message);
}

void parse_assumed_gamma(Parser& parser, GlobalDesc& global) {
  const bool again = global.assumed_gamma || global.gamma_is_srgb;
  if (again) parser.warn("New instance of assumed_gamma ignored.");
  if (parser.accept(Keyword::kSrgb)) {
    if (again) return;
    global.gamma_is_srgb = true;
    parser.set_working_gamma(-1.0);
    return;
  }
  const double gamma = parser.parse_float();
  check(parser, gamma > 0.0, "assumed_gamma must be greater than 0.");
  if (again) return;
  global.assumed_gamma = gamma;
  parser.set_working_gamma(gamma);
}

void parse_noise_generator(Parser& parser, GlobalDesc& global) {
  global.noise_generator = parser.parse_int();
  check(parser, *global.noise_generator >= 0 && *global.noise_generator <= 3,
        "noise_generator must be 1, 2 or 3.");
  parser.set_noise_generator(*global.noise_generator);
}

void parse_number_of_waves(Parser& parser, GlobalDesc& global) {
  global.number_of_waves = parser.parse_int();
  if (global.number_of_waves <= 0) {
    parser.warn("number_of_waves must be greater than 0; changed to 1.");
    global.number_of_waves = 1;
  }
}

void parse_charset(Parser& parser, GlobalDesc&) {
  const bool utf8 = parser.at(Keyword::kUtf8);
  if (!utf8 && !parser.at(Keyword::kAscii) && !parser.at(Keyword::kSys)) {
    parser.fail_expected("ascii, utf8 or sys");
  }
  parser.next();
  parser.set_utf8(utf8);
}

void parse_hf_gray_16(Parser& parser, GlobalDesc&) {
  (void)optional_switch(parser);
  parser.warn("hf_gray_16 is an option of the command line now and has no effect in a scene.");
}

/// Settings of radiosity that are one float.
struct RadiosityFloat {
  Keyword keyword;
  double RadiositySettings::*value;
  bool (*good)(double) = nullptr;  ///< null: any number will do
  const char* rule = "";           ///< what a good one is
};
constexpr bool is_positive(double x) { return x > 0.0; }
constexpr bool is_not_negative(double x) { return x >= 0.0; }
constexpr bool is_share(double x) { return x >= 0.0 && x <= 1.0; }
constexpr bool is_positive_share(double x) { return x > 0.0 && x <= 1.0; }
constexpr const char* kPositive = " must be greater than 0.";

constexpr std::array kRadiosityFloats{
    RadiosityFloat{Keyword::kAdcBailout, &RadiositySettings::adc_bailout, is_positive, kPositive},
    RadiosityFloat{Keyword::kBrightness, &RadiositySettings::brightness, is_positive, kPositive},
    RadiosityFloat{Keyword::kErrorBound, &RadiositySettings::error_bound, is_positive, kPositive},
    RadiosityFloat{Keyword::kGrayThreshold, &RadiositySettings::gray_threshold, is_share,
                   " goes from 0 to 1."},
    RadiosityFloat{Keyword::kLowErrorFactor, &RadiositySettings::low_error_factor, is_positive,
                   kPositive},
    RadiosityFloat{Keyword::kMaxSample, &RadiositySettings::max_sample},
    RadiosityFloat{Keyword::kMaximumReuse, &RadiositySettings::maximum_reuse, is_positive,
                   kPositive},
    RadiosityFloat{Keyword::kMinimumReuse, &RadiositySettings::minimum_reuse, is_not_negative,
                   " must not be negative."},
    RadiosityFloat{Keyword::kPretraceEnd, &RadiositySettings::pretrace_end, is_positive_share,
                   " must be greater than 0 and at most 1."},
    RadiosityFloat{Keyword::kPretraceStart, &RadiositySettings::pretrace_start, is_positive_share,
                   " must be greater than 0 and at most 1."},
};
struct RadiositySwitch {
  Keyword keyword;
  bool RadiositySettings::*value;
};
constexpr std::array kRadiositySwitches{
    RadiositySwitch{Keyword::kAlwaysSample, &RadiositySettings::always_sample},
    RadiositySwitch{Keyword::kMedia, &RadiositySettings::media},
    RadiositySwitch{Keyword::kNormal, &RadiositySettings::normal},
    RadiositySwitch{Keyword::kSubsurface, &RadiositySettings::subsurface},
};

/// Stock changes the one that the scene did not set, and says so.
void check_reuse(Parser& parser, RadiositySettings& r, bool set_minimum, bool set_maximum) {
  if (r.maximum_reuse >= 2.0 * r.minimum_reuse) return;
  std::string text = "radiosity: maximum_reuse should be much larger than minimum_reuse";
  if (set_maximum && set_minimum) {
    check(parser, r.maximum_reuse > r.minimum_reuse,
          "Radiosity maximum_reuse must be larger than minimum_reuse.");
  } else if (set_maximum) {
    r.minimum_reuse = 0.5 * r.maximum_reuse;
    text += "; minimum_reuse has been adjusted.";
  } else {
    r.maximum_reuse = 2.0 * r.minimum_reuse;
    text += "; maximum_reuse has been adjusted.";
  }
  parser.diagnostics().warn({}, text);
}

void check_pool(Parser& parser, const RadiositySettings& r) {
  constexpr int kMostDirections = 10'000'000;
  check(parser, r.direction_pool >= r.count, "The pool of directions must hold the count.");
  check(parser, r.direction_pool <= kMostDirections,
        "Radiosity has at most 10,000,000 directions.");
}

void parse_radiosity(Parser& parser, GlobalDesc& global) {
  if (!global.radiosity) global.radiosity.emplace();
  RadiositySettings& r = *global.radiosity;
  bool set_minimum = false, set_maximum = false;
  parser.expect(Punct::kLeftCurly);
  while (!parser.accept(Punct::kRightCurly)) {
    if (const auto* item = find_entry<kRadiosityFloats>(parser.peek())) {
      parser.next();
      const double value = parser.parse_float();
      if (item->good && !item->good(value)) {
        parser.fail("Radiosity " + std::string(spelling(item->keyword)) + item->rule);
      }
      r.*(item->value) = value;
      set_minimum |= item->keyword == Keyword::kMinimumReuse;
      set_maximum |= item->keyword == Keyword::kMaximumReuse;
    } else if (const auto* flag = find_entry<kRadiositySwitches>(parser.peek())) {
      parser.next();
      r.*(flag->value) = parser.parse_float() != 0.0;
    } else if (parser.accept(Keyword::kCount)) {
      r.count = parser.parse_int();
      check(parser, r.count > 0, "Radiosity count must be a positive number.");
      r.direction_pool =
          static_cast<int>(std::clamp(next_float(parser, std::max(1600, r.count)), 0.0, 2e9));
      check_pool(parser, r);
    } else if (parser.accept(Keyword::kNearestCount)) {
      r.nearest_count = parser.parse_int();
      check(parser, r.nearest_count >= 1 && r.nearest_count <= kMostNearest,
            "Radiosity nearest_count goes from 1 to 20.");
      r.nearest_count_adaptive = static_cast<int>(next_float(parser, 0.0));
      check(parser, r.nearest_count_adaptive >= 0 && r.nearest_count_adaptive < r.nearest_count,
            "The second number of nearest_count must be less than the first.");
    } else if (parser.accept(Keyword::kRecursionLimit)) {
      r.recursion_limit = parser.parse_int();
      check(parser, r.recursion_limit >= 1 && r.recursion_limit <= kMostBounces,
            "Radiosity recursion_limit goes from 1 to 20.");
    } else if (parser.accept(Keyword::kLoadFile) || parser.accept(Keyword::kSaveFile)) {
      const Location where = parser.location();
      (void)parser.parse_string();
      parser.warn_at(where, "Radiosity files are options of the command line now; ignored here.");
    } else {
      parser.fail_expected("one of count, nearest_count, recursion_limit, " +
                           word_list(kRadiosityFloats) + ", " + word_list(kRadiositySwitches) +
                           " or }");
    }
  }
  check(parser, r.pretrace_end <= r.pretrace_start,
        "Radiosity pretrace_end must not be greater than pretrace_start.");
  check_reuse(parser, r, set_minimum, set_maximum);
  if (parser.language_version() < 350) {
    parser.warn("since 3.5 a radiosity { } in global_settings turns radiosity on");
  }
}

std::shared_ptr<const core::PhotonMaps> load_photons(Parser& parser, const std::string& name,
                                                     const Location& where) {
  const auto found = parser.find_to_open(name, where);
  if (!found) parser.fail_at(where, "cannot find the photon file '" + shown_name(name) + "'");
  const std::string bytes = read_held(*found).value_or("");
  try {
    return std::make_shared<const core::PhotonMaps>(core::read_photon_file(bytes));
  } catch (const core::BadPhotonFile& bad) {
    parser.fail_at(where, "cannot use the photon file '" + shown_name(name) + "': " + bad.what());
  }
}

/// The last of load_file and save_file holds.
void accept_photon_file(Parser& parser, PhotonSettings& p, GlobalDesc& global, bool loads) {
  const Location where = parser.location();
  const std::string name = parser.parse_string();
  if (loads ? !p.save_file.empty() : !p.load_file.empty()) {
    parser.warn_at(where, std::string("photons are either loaded or saved: this ") +
                              (loads ? "load_file" : "save_file") + " holds");
  }
  p.load_file = loads ? name : std::string();
  p.save_file = loads ? std::string() : name;
  global.loaded_photons.maps = loads ? load_photons(parser, name, where) : nullptr;
  if (!loads) parser.check_writable(name, where);
}

bool accept_photon_setting(Parser& parser, PhotonSettings& p, GlobalDesc& global) {
  if (parser.accept(Keyword::kSpacing, p.spacing) || parser.accept(Keyword::kJitter, p.jitter) ||
      parser.accept(Keyword::kCount, p.count) || parser.accept(Keyword::kAutostop, p.autostop) ||
      parser.accept(Keyword::kAdcBailout, p.adc_bailout) ||
      parser.accept(Keyword::kMaxTraceLevel, p.max_trace_level))
    return true;
  if (parser.accept(Keyword::kRadius)) {
    p.radius = optional_float(parser, -1.0);
    p.radius_multiplier = next_float(parser, 1.0);
    p.media_radius = next_float(parser, -1.0);
    p.media_radius_multiplier = next_float(parser, 1.0);
  } else if (parser.accept(Keyword::kExpandThresholds)) {
    parse_values(parser, p.expand_increase, p.expand_min);
    if (p.expand_increase < 0.0 || p.expand_min < 0) {
      parser.warn("The numbers of expand_thresholds must not be negative: 0 is used.");
      p.expand_increase = std::max(0.0, p.expand_increase);
      p.expand_min = std::max(0, p.expand_min);
    }
  } else if (parser.accept(Keyword::kGather)) {
    parse_values(parser, p.gather_min, p.gather_max);
  } else if (parser.accept(Keyword::kLoadFile)) {
    accept_photon_file(parser, p, global, true);
  } else if (parser.accept(Keyword::kSaveFile)) {
    accept_photon_file(parser, p, global, false);
  } else if (parser.accept(Keyword::kMedia)) {
    p.media_steps = parser.parse_int();
    check(parser, p.media_steps >= 0, "The steps of photons' media must not be negative.");
    p.media_factor = next_float(parser, 1.0);
    check(parser, p.media_factor > 0.0, "The factor of photons' media must be greater than 0.");
  } else {
    return false;
  }
  return true;
}

void parse_photons(Parser& parser, GlobalDesc& global) {
  PhotonSettings& p = global.photons.emplace();
  parser.expect(Punct::kLeftCurly);
  while (!parser.at(Punct::kRightCurly)) {
    if (!accept_photon_setting(parser, p, global)) {
      parser.fail_expected(
          "one of radius, spacing, expand_thresholds, gather, jitter, count, autostop, "
          "adc_bailout, max_trace_level, load_file, save_file, media or }");
    }
  }
  check(parser, p.gather_max == 0 || p.gather_min <= p.gather_max,
        "The first number of gather must not be greater than the second.");
  if (p.gather_max == 0) parser.warn("gather is 0: there are no photons.");
  parser.expect(Punct::kRightCurly);
}

void parse_subsurface(Parser& parser, GlobalDesc& global) {
  global.subsurface.emplace();
  parser.expect(Punct::kLeftCurly);
  while (!parser.accept(Punct::kRightCurly)) {
    if (parser.accept(Keyword::kSamples)) {
      parse_values(parser, global.subsurface->samples_diffuse, global.subsurface->samples_single);
    } else if (parser.accept(Keyword::kRadiosity)) {
      global.subsurface->radiosity = parser.parse_float() != 0.0;
    } else {
      parser.fail_expected("samples, radiosity or }");
    }
  }
}

constexpr std::array kSettings{
    SettingEntry{Keyword::kAdcBailout,
                 [](Parser& p, GlobalDesc& g) { g.adc_bailout = p.parse_float(); }},
    SettingEntry{
        Keyword::kAmbientLight,
        [](Parser& p, GlobalDesc& g) { g.ambient_light = to_colour(p.parse_colour()).rgb; }},
    SettingEntry{Keyword::kAssumedGamma, parse_assumed_gamma},
    SettingEntry{Keyword::kCharset, parse_charset},
    SettingEntry{Keyword::kHfGray16, parse_hf_gray_16},
    SettingEntry{Keyword::kIridWavelength,
                 [](Parser& p, GlobalDesc& g) {
                   const core::Rgb c = to_colour(p.parse_colour()).rgb;
                   g.irid_wavelength = {c.r, c.g, c.b};
                 }},
    SettingEntry{Keyword::kMaxIntersections,
                 [](Parser& p, GlobalDesc&) {
                   (void)p.parse_float();
                   if (p.language_version() >= 370)
                     p.warn("max_intersections has no effect any more.");
                 }},
    SettingEntry{Keyword::kMaxTraceLevel, parse_max_trace_level},
    SettingEntry{Keyword::kMmPerUnit,
                 [](Parser& p, GlobalDesc& g) { g.mm_per_unit = p.parse_float(); }},
    SettingEntry{Keyword::kNoiseGenerator, parse_noise_generator},
    SettingEntry{Keyword::kNumberOfWaves, parse_number_of_waves},
    SettingEntry{Keyword::kPhotons, parse_photons},
    SettingEntry{Keyword::kRadiosity, parse_radiosity},
    SettingEntry{Keyword::kSubsurface, parse_subsurface},
};

}  // namespace

void parse_max_trace_level(Parser& parser, GlobalDesc& global) {
  const int level = parser.parse_int();
  if (level > kTraceLevelLimit) {
    parser.warn("max_trace_level " + std::to_string(level) + " is more than " +
                std::to_string(kTraceLevelLimit) + "; using that.");
  }
  global.max_trace_level = std::clamp(level, 1, kTraceLevelLimit);
}

void parse_global_settings(Parser& parser, Context&, GlobalDesc& global) {
  global.where = parser.location();
  parser.expect(Punct::kLeftCurly);
  while (!parser.accept(Punct::kRightCurly)) {
    const SettingEntry* entry = find_entry<kSettings>(parser.peek());
    if (!entry) parser.fail_expected("one of " + word_list(kSettings) + " or }");
    parser.next();
    entry->read(parser, global);
  }
}

}  // namespace lentray::parser
