#include "tools/lentray-diff/seen_mode.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/formed.h"
#include "core/image/display.h"
#include "core/image/orientation.h"
#include "core/image/run_files.h"
#include "core/image/srgb.h"
#include "core/image/writer.h"
#include "tools/common/json_text.h"
#include "tools/common/own_folder.h"
#include "tools/common/photo_reader.h"
#include "tools/common/process.h"
#include "tools/common/sheet_facts.h"
#include "tools/lentray-diff/eye_measure.h"
#include "tools/lentray-diff/report.h"
#include "tools/lentray-diff/seen_sheet.h"

namespace lentray::diff {
namespace {

namespace fs = std::filesystem;
using core::formed;
using core::ImageError;
using core::StoredImage;
using nlohmann::json;

constexpr float kFullLevel = 255.0f;  ///< of white, where a picture is as viewers show it
constexpr const char* kSeenPictures[] = {"first.png", "second.png", "heat.png"};

/// A picture as viewers show it, its strips as columns.
struct SheetPicture {
  StoredImage shown;
  SeenSheet sheet;
};

SheetPicture read_sheet(const fs::path& path, const SeenArguments& arguments) {
  tool::PhotoReader reader;
  StoredImage image = reader.read(path);
  if (arguments.across || tool::lies_across(tool::facts_of(image))) {
    image = core::upright(std::move(image), core::kTurnedBack);
  }
  for (const std::string& warning : reader.warnings()) {
    std::cerr << "lentray-diff: warning: " << warning << "\n";
  }
  SheetPicture out;
  out.sheet = seen_sheet_of(image, arguments, path.string());
  out.shown = core::displayed(image);
  return out;
}

/// What an eye sees of one picture.
struct Sight {
  std::vector<LightPlane> luminance;  ///< at kSeenParts
  std::array<LightPlane, 3> colours;  ///< R, G and B at the middle part
};

Sight sight_of(const EyeMeasure& measure, const StoredImage& shown) {
  std::array<LightPlane, 3> light;
  for (std::size_t c = 0; c < 3; ++c) {
    light[c] = {shown.width, shown.height,
                std::vector<float>(std::size_t{shown.width} * shown.height)};
    for (std::size_t i = 0; i < light[c].values.size(); ++i) {
      light[c].values[i] = core::linear_of_srgb(shown.samples[3 * i + c] / kFullLevel);
    }
  }
  Sight out;
  for (std::size_t c = 0; c < 3; ++c) {
    out.colours[c] = measure.seen(light[c], kSeenParts[kMiddlePart]);
  }
  LightPlane& luminance = light[0];
  for (std::size_t i = 0; i < luminance.values.size(); ++i) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) sum += kLuminance[c] * light[c].values[i];
    luminance.values[i] = static_cast<float>(sum);
  }
  for (const double part : kSeenParts) out.luminance.push_back(measure.seen(luminance, part));
  return out;
}

/// What is compared, and how far it differs.
struct SeenResult {
  SeenSheet sheet;
  std::uint32_t width, height;  ///< of the pictures
  EyeMeasure measure;
  Sight first, second;
  SeenDifferences differences;
};

EyeMeasure measure_of(const SheetPicture& picture, const fs::path& path) {
  try {
    return {picture.sheet.lenses, picture.sheet.eye, picture.shown.width, picture.shown.height};
  } catch (const std::invalid_argument& error) {
    throw ImageError("'" + path.string() + "': " + error.what());
  }
}

void refuse_others(const SeenResult& first, const SheetPicture& second) {
  std::string why = other_sheet(first.sheet, second.sheet);
  if (first.width != second.shown.width || first.height != second.shown.height) {
    why = formed("%u x %u and %u x %u pixels", first.width, first.height, second.shown.width,
                 second.shown.height);
  }
  if (!why.empty()) throw ImageError("two pictures of one sheet are expected, not " + why);
}

/// What is seen of the first picture alone.
SeenResult seen_of(const SheetPicture& picture, const fs::path& path) {
  SeenResult out{picture.sheet,
                 picture.shown.width,
                 picture.shown.height,
                 measure_of(picture, path),
                 {},
                 {},
                 {}};
  out.first = sight_of(out.measure, picture.shown);
  return out;
}

/// One picture is in memory at a time: sheets are large.
SeenResult measured(const SeenArguments& arguments) {
  const fs::path& path = arguments.pictures[0];
  SeenResult out = seen_of(read_sheet(path, arguments), path);
  const SheetPicture second = read_sheet(arguments.pictures[1], arguments);
  refuse_others(out, second);
  out.second = sight_of(out.measure, second.shown);
  out.differences = seen_differences(out.measure, out.first.luminance, out.second.luminance);
  return out;
}

/// How many rows of equal weight have that much noise in their mean.
double rows_blended(const EyeBeforePrint& eye) {
  double squares = 0.0;
  for (const double weight : row_weights(eye)) squares += weight * weight;
  return 1.0 / squares;
}

std::string text_of(const SeenResult& result) {
  const SeenDifference& all = result.differences.all;
  const EyeBeforePrint& eye = result.sheet.eye;
  std::string out = "L* does not differ in anything that is seen\n";
  if (all.largest > 0.0) {
    out = formed(
        "L* differs by %.3f RMS, by %.2f or less in 99 %% of what is seen; most by %.2f, in lens "
        "%lld at %.1f of its width, row %u\n",
        all.rms, all.within_99, all.largest, static_cast<long long>(all.where.lens), all.where.part,
        all.where.row);
  }
  return out + formed(
                   "seen from %.4g mm by an eye of %.3g' (it blends %.1f rows of %.4g an inch), at "
                   "%zu places of %u lenses of %.6g pixels in %u rows\n",
                   eye.distance, eye.arc_minutes, rows_blended(eye), eye.rows_an_inch,
                   kSeenParts.size(), result.measure.lenses(), result.sheet.lenses.pixels,
                   result.measure.rows());
}

json json_of(const SeenDifference& difference) {
  return {{"points", difference.points},
          {"rms", difference.rms},
          {"within_99", difference.within_99},
          {"largest", difference.largest},
          {"bias", difference.bias},
          {"where",
           {{"part", difference.where.part},
            {"lens", difference.where.lens},
            {"row", difference.where.row}}}};
}

json json_of(const SeenResult& result, const SeenArguments& arguments) {
  json parts = json::array();
  for (std::size_t p = 0; p < kSeenParts.size(); ++p) {
    parts.push_back(json_of(result.differences.parts[p]));
    parts.back()["part"] = kSeenParts[p];
  }
  const SeenSheet& sheet = result.sheet;
  return {{"pictures", {arguments.pictures[0].string(), arguments.pictures[1].string()}},
          {"width", result.width},
          {"height", result.height},
          {"lens_pixels", sheet.lenses.pixels},
          {"slant_deg", sheet.slant},
          {"rows_an_inch", sheet.eye.rows_an_inch},
          {"view_distance_mm", sheet.eye.distance},
          {"arc_minutes", sheet.eye.arc_minutes},
          {"sigma_rows", sheet.eye.sigma()},
          {"rows_blended", rows_blended(sheet.eye)},
          {"blur_columns", result.measure.blur()},
          {"lenses", result.measure.lenses()},
          {"rows", result.measure.rows()},
          {"l_star", json_of(result.differences.all)},
          {"parts", std::move(parts)}};
}

/// A pixel for each lens and row becomes as wide as the lens is in square pixels. Upright.
StoredImage in_square_pixels(const SeenResult& result, const StoredImage& seen) {
  const double scale = result.sheet.eye.rows_an_inch / result.sheet.columns_an_inch;
  const auto width = static_cast<std::uint32_t>(std::max(1.0, std::round(result.width * scale)));
  StoredImage out = core::black_rgb(width, seen.height, 8);
  for (std::uint32_t row = 0; row < seen.height; ++row) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const auto lens = result.measure.lens_at((x + 0.5) / width * result.width, row);
      if (!lens) continue;
      for (int c = 0; c < 3; ++c) out.at(x, row, c) = seen.at(*lens, row, c);
    }
  }
  return result.sheet.is_across ? core::upright(std::move(out), core::kTurned) : out;
}

/// A pixel for each lens and row.
StoredImage picture_of(const std::array<LightPlane, 3>& colours) {
  StoredImage out = core::black_rgb(colours[0].width, colours[0].height, 8);
  for (std::size_t i = 0; i < colours[0].values.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float level = core::srgb_of_linear(std::clamp(colours[c].values[i], 0.0f, 1.0f));
      out.samples[3 * i + c] = std::round(kFullLevel * level);
    }
  }
  return out;
}

void write_seen(const SeenArguments& arguments, const SeenResult& result) {
  const LightPlane& largest = result.differences.largest;
  const StoredImage pictures[] = {picture_of(result.first.colours),
                                  picture_of(result.second.colours),
                                  heat_map(largest.values, largest.width, largest.height)};
  std::cout << formed(
      "pictures: what is seen at %.1f of the lenses, and the largest difference "
      "(black 0, blue 1, green 2, yellow 4, red 12, white 32 L* and more):\n",
      kSeenParts[kMiddlePart]);
  for (std::size_t i = 0; i < std::size(pictures); ++i) {
    const fs::path place = arguments.out / kSeenPictures[i];
    core::write_stored(in_square_pixels(result, pictures[i]), place);
    std::cout << "  " << place.string() << "\n";
  }
}

/// Files are asked for before anything is computed, and none is an input.
void claim_outputs(const SeenArguments& arguments) {
  for (const fs::path& input : arguments.pictures) core::note_input(input);
  core::claim_writable(arguments.json, "--json");
  if (arguments.out.empty()) return;
  tool::make_folder(arguments.out, arguments.out);
  for (const char* name : kSeenPictures) core::claim_writable(arguments.out / name, "--out");
}

}  // namespace

int compare_seen(const SeenArguments& arguments) {
  claim_outputs(arguments);
  const SeenResult result = measured(arguments);
  std::cout << text_of(result);
  if (!arguments.out.empty()) write_seen(arguments, result);
  if (!arguments.json.empty()) {
    tool::write_whole(arguments.json, tool::json_text(json_of(result, arguments), 2) + "\n");
  }
  std::cout << std::flush;
  return 0;
}

}  // namespace lentray::diff
