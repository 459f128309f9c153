#include "tools/lentray/output.h"

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "camera/text.h"
#include "core/image/file_swap.h"
#include "tools/lentray/version.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

float linear_of_srgb(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

void decode_srgb(core::Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 != 3) image.rgba[i] = linear_of_srgb(image.rgba[i]);
  }
}

std::string text_of(const camera::Property& property) {
  if (const auto* text = std::get_if<std::string>(&property.second)) return *text;
  if (const auto* vector = std::get_if<core::Vec3>(&property.second)) {
    return camera::text_of(*vector);
  }
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", std::get<double>(property.second));
  return buffer;
}

core::ImageMetadata metadata(const CameraSetup& setup) {
  core::ImageMetadata out;
  out.software = std::string("Lentray ") + kVersion;
  if (!setup.sheet) return out;
  // A view is no print; only the integral image has a physical resolution.
  if (!setup.view) {
    out.dpi_x = setup.sheet->print_dpi_x();
    out.dpi_y = setup.sheet->print_dpi_y();
    out.description = "integral image for a lenticular sheet";
  }
  for (const camera::Property& property : setup.camera().describe()) {
    out.fields.emplace_back("lentray:" + property.first, text_of(property));
  }
  return out;
}

/// Encodings work on files: one that goes away again carries the picture to standard output.
void write_to_stdout(const core::Image& image, const core::ImageFormat& format,
                     const core::ImageMetadata& data) {
  std::string folder = (fs::temp_directory_path() / "lentray-XXXXXX").string();
  if (!mkdtemp(folder.data())) throw core::ImageError("cannot make a temporary folder");
  const fs::path path = fs::path(folder) / ("picture" + core::extension_of(format.type));
  try {
    core::write_image(image, path, format, data);
    std::ifstream in(path, std::ios::binary);
    char buffer[65536];
    while (in.read(buffer, sizeof buffer), in.gcount() > 0) {
      std::fwrite(buffer, 1, static_cast<std::size_t>(in.gcount()), stdout);
    }
  } catch (...) {
    fs::remove_all(folder);
    throw;
  }
  fs::remove_all(folder);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw core::ImageError("cannot write the picture to standard output");
  }
}

}  // namespace

core::FileType file_type(parser::OutputType type) {
  switch (type) {
    case parser::OutputType::kPng: return core::FileType::png;
    case parser::OutputType::kTiff: return core::FileType::tiff;
    case parser::OutputType::kExr: break;
  }
  return core::FileType::exr;
}

void write_picture(core::Image& image, const std::string& path, parser::OutputType type,
                   const parser::RenderOptions& options, const core::SceneSettings& settings,
                   const CameraSetup& camera) {
  core::ImageFormat format;
  format.type = file_type(type);
  format.bits = options.bits;
  format.srgb = options.srgb;
  format.file_gamma = options.file_gamma;
  format.alpha = options.alpha;
  if (settings.assumed_gamma > 0.0) {
    format.working_gamma = settings.assumed_gamma;
  } else if (settings.assumed_gamma_set) {
    decode_srgb(image);
  } else {
    // Scenes older than 3.7 without an assumed_gamma: colours go to the file as they are.
    format.srgb = false;
    format.file_gamma = 1.0;
  }
  const core::ImageMetadata data = metadata(camera);
  if (path == "-") return write_to_stdout(image, format, data);
  core::write_image(image, path, format, data);
}

nlohmann::json lens_json(const camera::Camera& camera) {
  nlohmann::json out = nlohmann::json::object();
  constexpr std::string_view kPrefix = "lens.";
  for (const camera::Property& property : camera.describe()) {
    if (property.first.rfind(kPrefix, 0) != 0) continue;
    nlohmann::json& value = out[property.first.substr(kPrefix.size())];
    if (const auto* text = std::get_if<std::string>(&property.second)) {
      value = *text;
    } else if (const auto* v = std::get_if<core::Vec3>(&property.second)) {
      value = {v->x, v->y, v->z};
    } else {
      const double number = std::get<double>(property.second);
      constexpr double kExact = 9007199254740992.0;  // 2^53
      if (number == std::floor(number) && std::fabs(number) < kExact) {
        value = static_cast<std::int64_t>(number);
      } else {
        value = number;
      }
    }
  }
  return out;
}

void write_text_file(const std::string& path, const std::string& text) {
  core::FileSwap swap(path);
  std::ofstream out(swap.temporary(), std::ios::binary);
  out << text;
  out.close();
  if (!out) throw core::ImageError("cannot write '" + path + "'");
  swap.commit();
}

}  // namespace lentray::tool
