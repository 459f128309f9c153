#include "core/irradiance/rca_samples.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/formed.h"
#include "core/irradiance/irradiance_cache.h"

namespace lentray::core {
namespace {

constexpr double kSteps = 127.0;         ///< of a part of a normal, from 0 to 1
constexpr double kMostRadiiAway = 1e15;  ///< of the origin: cells are numbered by 64 bits

int step_of(double part) { return static_cast<int>((part + 1.0) * kSteps + 0.499999); }

std::string packed(const Vec3& normal) {
  return formed("%02x%02x%02x", step_of(normal.x) & 0xff, step_of(normal.y) & 0xff,
                step_of(normal.z) & 0xff);
}

bool unpack(std::string_view text, Vec3& normal) {
  if (text.size() != 6) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const char* const at = text.data() + 2 * axis;
    unsigned step = 0;
    const auto [end, error] = std::from_chars(at, at + 2, step, 16);
    if (error != std::errc() || end != at + 2) return false;
    normal[axis] = step / kSteps - 1.0;
  }
  const double size = length(normal);
  if (size > 0.0) normal = normal / size;  // null stays null: nothing is near
  return true;
}

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() &&
         std::isfinite(static_cast<double>(number));
}

using Words = std::array<std::string_view, 11>;

bool split(std::string_view line, Words& words) {
  constexpr std::string_view kBlank = " \t\r";
  std::size_t count = 0;
  for (std::size_t at = 0; (at = line.find_first_not_of(kBlank, at)) != line.npos; ++count) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    if (count == words.size()) return false;
    words[count] = line.substr(at, end - at);
    at = end;
  }
  return count == words.size();
}

bool read_sample(std::string_view line, DepthSample& out) {
  Words w;
  IrradianceSample& s = out.sample;
  s.quality = 1.0f;
  if (!line.starts_with('C') || !split(line, w) || !read_number(w[0].substr(1), out.depth))
    return false;
  --out.depth;
  const bool is_read = read_number(w[1], s.point.x) && read_number(w[2], s.point.y) &&
                       read_number(w[3], s.point.z) && unpack(w[4], s.normal) &&
                       read_number(w[5], s.light.r) && read_number(w[6], s.light.g) &&
                       read_number(w[7], s.light.b) && read_number(w[8], s.radius) &&
                       read_number(w[9], s.nearest) && unpack(w[10], s.to_nearest);
  return is_read && out.depth >= 0 && s.radius > 0.0f && s.nearest >= 0.0f &&
         length(s.normal) > 0.0 && length(s.point) < s.radius * kMostRadiiAway;
}

void append_sample(int depth, const IrradianceSample& s, std::string& out) {
  out += formed("C%d\t%g\t%g\t%g\t", depth + 1, s.point.x, s.point.y, s.point.z) +
         packed(s.normal) +
         formed("\t%.4f\t%.4f\t%.4f\t%g\t%g\t", static_cast<double>(s.light.r),
                static_cast<double>(s.light.g), static_cast<double>(s.light.b),
                static_cast<double>(s.radius), static_cast<double>(s.nearest)) +
         packed(s.to_nearest) + "\n";
}

}  // namespace

RcaSamples read_rca_samples(std::string_view text) {
  RcaSamples out;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (text.empty()) break;
    DepthSample sample;
    if (read_sample(line, sample)) {
      out.samples.push_back(sample);
    } else if (line.find_first_not_of(" \t\r") != line.npos) {
      if (out.passed_over++ == 0) out.first_passed_over = number;
    }
  }
  return out;
}

std::string rca_samples_text(const IrradianceCache& cache, const std::vector<std::size_t>& known) {
  std::string out;
  for (int depth = 0; depth < cache.depths(); ++depth) {
    const auto& samples = cache.store(depth).samples();
    const auto at = static_cast<std::size_t>(depth);
    for (std::size_t i = at < known.size() ? known[at] : 0; i < samples.size(); ++i) {
      append_sample(depth, samples[i], out);
    }
  }
  return out;
}

}  // namespace lentray::core
