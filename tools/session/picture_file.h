// The picture of a run on its way to its file, band by band, with its metadata.
// Errors: core::ImageError. One call at a time.
#pragma once

#include <memory>
#include <string>

#include "core/image/writer.h"
#include "core/render/band_sink.h"
#include "tools/session/camera_setup.h"

namespace lentray::tool {

class PictureFile final : public core::BandSink {
 public:
  /// `path` "-": standard output; empty: nowhere. Bands hold colours of the working space that
  /// `format` says. `spare`, or null, gives way to the file on a full disk.
  PictureFile(const std::string& path, const core::ImageFormat& format, const CameraSetup& camera,
              core::SpareRoom* spare);

  void put(const core::Image& band, std::uint32_t top) override;
  /// The file is in its place; without this nothing is left behind.
  void finish();
  /// Processor seconds that encoding and writing took.
  double cpu_seconds() const { return m_cpu_seconds; }

 private:
  std::unique_ptr<core::PictureWriter> m_writer;
  double m_cpu_seconds = 0.0;
};

}  // namespace lentray::tool
