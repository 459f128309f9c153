#include "tools/lentray-diff/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/formed.h"

namespace lentray::diff {

using core::Comparison;
using core::Grade;
using core::LensComparison;
using core::StoredImage;

namespace {

std::array<double, 3> heat_colour(double difference) {
  static constexpr std::array<std::array<double, 4>, 6> stops{{{0, 0, 0, 0},
                                                               {1, 0, 0, 160},
                                                               {2, 0, 200, 80},
                                                               {4, 255, 255, 0},
                                                               {12, 255, 0, 0},
                                                               {32, 255, 255, 255}}};
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (difference > stops[i][0]) continue;
    const double f = (difference - stops[i - 1][0]) / (stops[i][0] - stops[i - 1][0]);
    std::array<double, 3> colour{};
    for (int c = 0; c < 3; ++c) {
      colour[c] = std::round(stops[i - 1][c + 1] + f * (stops[i][c + 1] - stops[i - 1][c + 1]));
    }
    return colour;
  }
  return {255, 255, 255};
}

void put(StoredImage& image, std::uint32_t x, std::uint32_t y,
         const std::array<double, 3>& colour) {
  for (int c = 0; c < 3; ++c) {
    image.at(x, y, c) = static_cast<float>(std::clamp(std::round(colour[c]), 0.0, 255.0));
  }
}

std::string decibels(double psnr) {
  return std::isinf(psnr) ? "  equal" : core::formed("%7.2f", psnr);
}

std::string line(const std::string& name, const Comparison& c) {
  std::string out =
      core::formed("%-10s %9llu %8.2f %9.4f %8.3f %% %8.3f %%  %s  %s", name.c_str(),
                   static_cast<unsigned long long>(c.pixels), c.largest, c.mean,
                   100.0 * c.share_beyond_1(), 100.0 * c.share_beyond_2(), decibels(c.psnr).c_str(),
                   std::string(core::name_of(c.grade)).c_str());
  if (c.noise) {
    out += core::formed("  blocks %.2f, S %.2f; bias %.2f, S %.2f", c.blocks.rms, c.noise->rms,
                        c.blocks.bias, c.noise->bias);
  }
  return out + "\n";
}

std::string tally(const char* what, const std::vector<Comparison>& parts) {
  std::map<Grade, std::size_t, std::greater<>> counts;
  for (const Comparison& c : parts) ++counts[c.grade];
  std::string text = std::to_string(parts.size()) + " " + what + ":";
  const char* between = " ";
  for (const auto& [grade, count] : counts) {
    text += between + std::to_string(count) + " " + std::string(core::name_of(grade));
    between = ", ";
  }
  return text + "\n";
}

/// Indices, worst first: by grade, then by PSNR; ties stay in order.
std::vector<std::size_t> worst_first(const std::vector<Comparison>& parts) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (parts[a].grade != parts[b].grade) return parts[a].grade < parts[b].grade;
    return parts[a].psnr < parts[b].psnr;
  });
  return order;
}

nlohmann::json number_or_null(double value) {
  return std::isinf(value) ? nlohmann::json() : nlohmann::json(value);
}

nlohmann::json to_json(const Comparison& c) {
  nlohmann::json out{{"pixels", c.pixels},
                     {"largest", c.largest},
                     {"mean", c.mean},
                     {"beyond_1", c.share_beyond_1()},
                     {"beyond_2", c.share_beyond_2()},
                     {"psnr", number_or_null(c.psnr)},
                     {"smooth_psnr", number_or_null(c.smooth_psnr)},
                     {"block_rms", c.blocks.rms},
                     {"bias", c.blocks.bias},
                     {"grade", std::string(core::name_of(c.grade))}};
  if (c.noise) out.update({{"noise_rms", c.noise->rms}, {"noise_bias", c.noise->bias}});
  return out;
}

nlohmann::json to_json(const std::vector<Comparison>& parts) {
  nlohmann::json list = nlohmann::json::array();
  for (const Comparison& c : parts) list.push_back(to_json(c));
  return list;
}

}  // namespace

StoredImage heat_map(const StoredImage& a, const StoredImage& b) {
  StoredImage image = core::black_rgb(a.width, a.height, 8);
  for (std::uint32_t y = 0; y < a.height; ++y) {
    for (std::uint32_t x = 0; x < a.width; ++x) {
      put(image, x, y, heat_colour(core::pixel_difference(a, b, x, y)));
    }
  }
  return image;
}

StoredImage heat_map(const std::vector<float>& differences, std::uint32_t width,
                     std::uint32_t height) {
  StoredImage image = core::black_rgb(width, height, 8);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      put(image, x, y, heat_colour(double{differences[std::size_t{y} * width + x]}));
    }
  }
  return image;
}

StoredImage side_by_side(const StoredImage& ours, const StoredImage& stock) {
  constexpr std::uint32_t gap = 4;
  StoredImage image = core::black_rgb(3 * ours.width + 2 * gap, ours.height, 8);
  image.samples.assign(image.samples.size(), 255.0f);
  for (std::uint32_t y = 0; y < ours.height; ++y) {
    for (std::uint32_t x = 0; x < ours.width; ++x) {
      const auto p = core::level(ours, x, y), q = core::level(stock, x, y);
      put(image, x, y, p);
      put(image, x + ours.width + gap, y, q);
      put(image, x + 2 * (ours.width + gap), y,
          {8 * std::abs(p[0] - q[0]), 8 * std::abs(p[1] - q[1]), 8 * std::abs(p[2] - q[2])});
    }
  }
  return image;
}

std::string table(const LensComparison& result, bool all_lenses) {
  std::string text =
      "              pixels  largest      mean    > 1/255    > 2/255  PSNR dB  grade\n" +
      line("whole", result.whole);
  for (std::size_t j = 0; j < result.views.size(); ++j) {
    text += line("view " + std::to_string(j), result.views[j]);
  }
  if (result.lenses.size() < 2) return text;
  constexpr std::size_t shown_when_short = 5;
  std::vector<std::size_t> order = worst_first(result.lenses);
  if (all_lenses) {
    std::sort(order.begin(), order.end());
  } else if (order.size() > shown_when_short) {
    order.resize(shown_when_short);
    text += "the worst lenses:\n";
  }
  for (const std::size_t i : order) text += line("lens " + std::to_string(i), result.lenses[i]);
  text += tally("lenses", result.lenses);
  if (!result.views.empty()) text += tally("views", result.views);
  return text;
}

nlohmann::json to_json(const LensComparison& result) {
  return {{"whole", to_json(result.whole)},
          {"views", to_json(result.views)},
          {"lenses", to_json(result.lenses)}};
}

}  // namespace lentray::diff
