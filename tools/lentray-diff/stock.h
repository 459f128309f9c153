// Stock POV-Ray, run as it is installed: one picture, or all views of a lens sheet interlaced.
// Antialiased where the options ask for it; what stock cannot antialias itself is the mean of many
// pictures (tools/lentray-diff/sampling.h).
// Errors: std::runtime_error with the last lines stock said. Threads: any number.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/image/reader.h"
#include "tools/lentray-diff/antialiasing.h"
#include "tools/lentray-diff/mean.h"
#include "tools/lentray-diff/sheet.h"
#include "tools/lentray-diff/wrapper.h"

namespace lentray::diff {

struct StockOptions {
  std::string povray = "povray";
  int processes = 1;  ///< at the same time
  int bits = 8;       ///< 8 or 16
  Antialiasing antialiasing;
  int block = 0;         ///< +BS; 0: stock's own, but for antialiasing one as large as the picture
  int threads = 1;       ///< +WT
  int samples = 8;       ///< antialiased mesh_camera: samples each way
  ColourSpaces colours;  ///< for means
  double seconds = 0.0;  ///< time limit of a process, 0: none
  std::vector<std::filesystem::path> library_paths;  ///< besides the scene's folder, absolute
  std::vector<std::string> arguments;                ///< passed on, such as Declare=Size=2
  std::filesystem::path keep;                        ///< where wrappers and pictures stay; or empty
};

/// The user's scene as it lies, in its own camera.
core::StoredImage stock_picture(const std::filesystem::path& scene, std::uint32_t width,
                                std::uint32_t height, const StockOptions& options);

/// The integral image of the sheet. Pixels that show nothing are black.
core::StoredImage stock_integral(const std::filesystem::path& scene, const Sheet& sheet, Way way,
                                 const StockOptions& options);

/// View j alone.
core::StoredImage stock_view(const std::filesystem::path& scene, const Sheet& sheet,
                             std::uint32_t view, const StockOptions& options);

/// All wrapper scenes the sheet has, as view0.pov ..., mesh.pov.
void write_wrappers(const std::filesystem::path& scene, const Sheet& sheet,
                    const std::filesystem::path& folder);

/// Column i*N + j of the result is column i of views[j].
core::StoredImage interlaced(const std::vector<core::StoredImage>& views, std::uint32_t columns);

}  // namespace lentray::diff
