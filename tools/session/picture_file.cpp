#include "tools/session/picture_file.h"

#include <variant>

#include "camera/text.h"
#include "core/base/formed.h"
#include "core/image/orientation.h"
#include "tools/common/machine.h"
#include "tools/common/version.h"

namespace lentray::tool {
namespace {

std::string text_of(const camera::Property& property) {
  if (const auto* text = std::get_if<std::string>(&property.second)) return *text;
  if (const auto* vector = std::get_if<core::Vec3>(&property.second)) {
    return camera::text_of(*vector);
  }
  return core::formed("%.17g", std::get<double>(property.second));
}

core::ImageMetadata metadata(const CameraSetup& setup) {
  core::ImageMetadata out;
  out.software = std::string("Lentray ") + kVersion;
  if (!setup.sheet) return out;
  // A view is no print; only the integral image has a physical resolution.
  if (!setup.view) {
    out.dpi_x = setup.sheet->print_dpi_x();
    out.dpi_y = setup.sheet->print_dpi_y();
    if (setup.is_on_its_side) out.orientation = core::kTurned;
    out.description = "integral image for a lenticular sheet";
  }
  for (const camera::Property& property : properties_of(setup)) {
    out.fields.emplace_back("lentray:" + property.first, text_of(property));
  }
  return out;
}

}  // namespace

PictureFile::PictureFile(const std::string& path, const core::ImageFormat& format,
                         const CameraSetup& camera, core::SpareRoom* spare) {
  if (path.empty()) return;
  m_writer = std::make_unique<core::PictureWriter>(
      path, camera.camera().width(), camera.camera().height(), format, metadata(camera), spare);
}

void PictureFile::put(const core::Image& band, std::uint32_t) {
  if (!m_writer) return;
  const double before = thread_cpu_seconds();
  m_writer->put(band);
  m_cpu_seconds += thread_cpu_seconds() - before;
}

void PictureFile::finish() {
  if (!m_writer) return;
  const double before = thread_cpu_seconds();
  m_writer->finish();
  m_cpu_seconds += thread_cpu_seconds() - before;
}

}  // namespace lentray::tool
