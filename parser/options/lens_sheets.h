// Lens_Sheet=NAME: lens sheets that are sold commonly, and those of users. Users' ones stand in INI files
// named lens_sheets.ini, a section [name] each, with options of lens data:
//
//   [shop's 60]
//   Lens_LPI=60.02   Lens_Thickness=0.65mm   Lens_IOR=1.57
//
// each on a line of its own. What stands before the first section holds for all of them.
// Errors: OptionError. Any number of threads.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "camera/lens_profiles.h"
#include "parser/options/options.h"

namespace lentray::parser {

inline constexpr const char* kLensSheetFile = "lens_sheets.ini";

/// Those of users first, which hide common ones of the same name.
std::vector<camera::LensProfile> lens_sheets(std::span<const std::string> files);

/// Gives options the data of the sheet that they name, where they do not give others. With
/// Restrict_IO the current folder's file is not read, for it may have come with the scene.
void apply_lens_sheet(RenderOptions& options, std::span<const std::string> files);

/// What Lens_Sheet=list prints: a line a sheet.
std::string lens_sheet_list(const RenderOptions& options, std::span<const std::string> files);

}  // namespace lentray::parser
