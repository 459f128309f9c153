#include "tools/session/radiosity_lattice.h"

#include <cstdint>
#include <sstream>

#include "core/base/byte_text.h"
#include "core/irradiance/pretrace.h"
#include "parser/files/watched_files.h"

namespace lentray::tool {
namespace {

/// Of pictures with more pixels, and of lens sheets, not each is looked at before the picture.
constexpr double kMostPixels = 1e6;

/// Rays from all over it, as bits: two lattices that have them in common are the same.
std::uint64_t sum_of_rays(const camera::Camera& camera) {
  constexpr std::uint32_t kAcross = 64, kDown = 32;
  std::string bytes;
  for (std::uint32_t i = 0; i < kDown; ++i) {
    for (std::uint32_t k = 0; k < kAcross; ++k) {
      const std::uint32_t column = std::uint64_t{k} * camera.width() / kAcross;
      const std::uint32_t row = std::uint64_t{i} * camera.height() / kDown;
      core::Ray ray;
      if (!camera.ray(column + 0.5, row + 0.5, ray)) ray = {};
      core::append_bytes(ray.origin, bytes);
      core::append_bytes(ray.direction, bytes);
    }
  }
  return parser::checksum(bytes);
}

const char* on_off(bool on) { return on ? "on" : "off"; }

std::string settings_text(const core::RadiositySettings& s) {
  std::ostringstream out;
  out << "  count " << s.count << ", " << s.direction_pool << "  nearest_count " << s.nearest_count
      << ", " << s.nearest_count_adaptive << "  recursion_limit " << s.recursion_limit
      << "  error_bound " << s.error_bound << "  low_error_factor " << s.low_error_factor
      << "\n  minimum_reuse " << s.minimum_reuse << "  maximum_reuse " << s.maximum_reuse
      << "  pretrace_start " << s.pretrace_start << "  pretrace_end " << s.pretrace_end
      << "  adc_bailout " << s.adc_bailout << "\n  brightness " << s.brightness
      << "  gray_threshold " << s.gray_threshold << "  max_sample ";
  if (s.max_sample > 0.0) {
    out << s.max_sample;
  } else {
    out << "none";
  }
  out << "  importance " << s.default_importance << "  always_sample " << on_off(s.always_sample)
      << "  media " << on_off(s.media) << "  normal " << on_off(s.normal) << "\n";
  return out.str();
}

}  // namespace

RadiosityLattice lattice_of(const CameraSetup& setup) {
  const bool is_sheet = setup.sheet != nullptr;
  const camera::Camera& camera = is_sheet ? *setup.sheet : setup.camera();
  const double pixels = static_cast<double>(camera.width()) * camera.height();
  return {camera, is_sheet, !is_sheet && pixels <= kMostPixels};
}

core::Vec3 radiosity_eye(const parser::CameraRequest& request) {
  const camera::Projection& p = request.projection;
  if (request.kind != "lenticular") return p.location;
  return p.location - core::normalized(p.direction) * core::length(p.right);
}

std::string identity_lines(const RadiosityLattice& lattice, const core::Vec3& eye) {
  std::ostringstream out;
  out.precision(17);
  out << (lattice.is_sheet ? "lens sheet " : "picture ") << lattice.camera.width() << " x "
      << lattice.camera.height() << "\nseen from " << eye.x << " " << eye.y << " " << eye.z
      << "\nrays " << std::hex << sum_of_rays(lattice.camera) << "\n";
  return out.str();
}

std::string radiosity_plan(const core::Scene& scene, const RadiosityLattice& lattice) {
  const core::RadiositySettings& s = *scene.settings().radiosity;
  const std::uint32_t width = lattice.camera.width(), height = lattice.camera.height();
  std::ostringstream out;
  out << "Radiosity\n" << settings_text(s);
  out << "  a sample gathers with";
  for (int depth = 0; depth < s.recursion_limit; ++depth)
    out << (depth == 0 ? " " : ", ") << core::rules_at(s, depth).rays;
  out << " rays" << (s.recursion_limit > 1 ? ", bounce by bounce" : "") << "\n  places "
      << (lattice.is_sheet ? "over the lens sheet, shared by its views" : "of the picture")
      << ", apart by pixels:";
  for (const core::PretraceLevel& level : core::pretrace_levels(s, width, height))
    out << " " << level.spacing;
  out << (lattice.sees_every_pixel ? ", then every pixel\n" : ", then some 250,000 places\n");
  return out.str();
}

}  // namespace lentray::tool
