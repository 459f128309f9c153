// What files of photographs say beside their pixels: how the camera was held, and what colours the values stand for.
// Of PNG, JPEG, TIFF and BigTIFF files, from their heads alone. Scenes do not ask for it: POV-Ray takes pictures as they
// are stored. Errors: none, what cannot be read is not said. Threads: any number.
// Source: TIFF specification 6.0; Exif 2.32 (Orientation, InteroperabilityIndex); PNG specification, third edition
// (eXIf, iCCP, cHRM); ICC.1:2022, annex B (profiles in files).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lentray::core {

/// Places in CIE's chromaticity diagram.
struct Chromaticities {
  double white_x = 0.3127, white_y = 0.3290;
  double red_x = 0.64, red_y = 0.33, green_x = 0.30, green_y = 0.60, blue_x = 0.15, blue_y = 0.06;
};

struct PhotoTags {
  int orientation = 1;  ///< 1 to 8: where the stored rows and columns begin; 1: as they are shown
  std::string profile;  ///< an ICC profile, perhaps broken; empty: none
  bool is_adobe_rgb = false;  ///< a camera says it by Exif's mark alone
  std::optional<Chromaticities>
      chromaticities;  ///< of PNG, which has neither profile nor sRGB's mark
  bool is_jpeg = false;
  int pages = 1;                    ///< of TIFF: its pictures, small copies and masks aside
  std::string description;          ///< of JPEG
  double dpi_x = 0.0, dpi_y = 0.0;  ///< of JPEG; 0: unknown
};

PhotoTags photo_tags(const std::filesystem::path& path);

}  // namespace lentray::core
