#include "tools/session/radiosity_file.h"

#include <cstring>
#include <stdexcept>

#include "core/base/byte_text.h"
#include "core/irradiance/cache_bytes.h"
#include "tools/session/summed_bytes.h"

namespace lentray::tool {
namespace {

constexpr FileMark kLightMark{"lentray light", 1};

std::string report_bytes(const core::RadiosityReport& report) {
  std::string out;
  core::append_bytes(report.sees_pixels, out);
  core::append_bytes(std::uint64_t{report.levels.size()}, out);
  for (const core::RadiosityReport::Level& level : report.levels) {
    core::append_bytes(level.places, out);
    core::append_bytes(std::uint64_t{level.depths.size()}, out);
    for (const core::GatherCounts& depth : level.depths) core::append_bytes(depth, out);
  }
  return out;
}

bool take_level(std::string_view& bytes, core::RadiosityReport::Level& level) {
  std::uint64_t depths = 0;
  if (!core::take_bytes(bytes, level.places) || !core::take_bytes(bytes, depths) ||
      depths > bytes.size() / sizeof(core::GatherCounts))
    return false;
  level.depths.resize(depths);
  for (core::GatherCounts& depth : level.depths) core::take_bytes(bytes, depth);
  return true;
}

bool take_report(std::string_view bytes, core::RadiosityReport& report) {
  std::uint64_t levels = 0;
  if (!core::take_bytes(bytes, report.sees_pixels) || !core::take_bytes(bytes, levels))
    return false;
  for (; levels > 0; --levels) {
    if (!take_level(bytes, report.levels.emplace_back())) return false;
  }
  return bytes.empty();
}

}  // namespace

std::string radiosity_file(const Identity& identity, const core::IrradianceCache& cache,
                           const core::RadiosityReport& report) {
  std::string pass, out;
  append_summed(report_bytes(report), pass);
  append_summed(core::bytes_of(cache), pass);
  core::append_bytes(kLightMark, out);
  append_summed(identity.text(), out);
  append_summed(pass, out);
  return out;
}

bool is_radiosity_file(std::string_view bytes) {
  return bytes.size() >= sizeof kLightMark.kind &&
         std::memcmp(bytes.data(), kLightMark.kind, sizeof kLightMark.kind) == 0;
}

std::string fault_of_radiosity(std::string_view bytes, const Identity& wanted,
                               std::string_view& pass) {
  std::string_view identity;
  if (!take_mark(bytes, kLightMark)) return "another version of the program made it";
  if (!take_summed(bytes, identity)) return "it is damaged";
  try {
    const std::string other = difference(Identity::of_text(std::string(identity)), wanted);
    if (!other.empty()) return other;
  } catch (const std::invalid_argument&) {
    return "another version of the program made it";
  }
  return take_summed(bytes, pass) && bytes.empty() ? "" : "it is damaged";
}

SavedRadiosity radiosity_of(std::string_view pass, const core::RadiositySettings& settings,
                            const core::Vec3& eye) {
  SavedRadiosity out;
  std::string_view report, cache;
  if (!take_summed(pass, report) || !take_summed(pass, cache) || !pass.empty() ||
      !take_report(report, out.report) || out.report.levels.empty())
    return {};
  out.cache = core::cache_of(cache, settings, eye);
  return out;
}

}  // namespace lentray::tool
