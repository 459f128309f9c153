// Scenes that make stock POV-Ray show what a lens sheet shows: each includes the user's scene and
// then declares its own camera, for the last camera wins. Measured on POV-Ray 3.7.0.10; held by
// tests/compat/wrapper_test.
//   V infinite, whole N    a view is an oblique orthographic picture
//   V finite, paraxial     a view is an oblique perspective picture from its eye
//   the rest               a mesh_camera whose faces are the pixels' rays (agrees to 1e-12 where
//                          rays start at the eye or V is infinite, else to 2e-8)
// Pure functions of text; threads: any number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/reader.h"
#include "tools/lentray-diff/sheet.h"

namespace lentray::diff {

enum class Way { orthographic_views, perspective_views, mesh_camera };
const char* name_of(Way way);

/// The most exact way stock has for the sheet.
Way best_way(const Sheet& sheet);

/// The first `#version` directive of a scene with its end, or nothing. A wrapper must begin with
/// it: stock decides on its dialect before the first include.
std::string version_directive(const std::string& scene);

/// A scene that stock can read: cameras of the kind `lenticular`, which it does not know, become
/// orthographic ones. Lines keep their numbers. `changed` says if there were any.
std::string without_lenticular(const std::string& scene, bool& changed);

/// Files that a scene includes by a plain string, in order, as written; conditions are ignored.
std::vector<std::string> included_files(const std::string& scene);

/// The user's scene as it is included: its version directive and its path.
struct Included {
  std::string version, path;
};

/// View j: the picture is view_width(j) x rows. For the two ways that have views.
std::string view_scene(const Sheet& sheet, std::uint32_t view, Way way, const Included& scene);

/// The whole integral image, lying on its side: `rows` pixels wide and `columns` high, for a
/// mesh_camera is most exact where a row of its picture is a column of the sheet. POV-Ray 3.7 shows
/// mesh row k - 1 in image row k: there the picture must be rendered one row higher (`lag`).
/// With several offsets, all equally far down, one such image lies below the other.
std::string mesh_scene(const Sheet& sheet, const Included& scene,
                       const std::vector<PixelOffset>& offsets = {PixelOffset{}});

/// The integral image in what stock rendered of mesh_scene(); dark pixels black.
core::StoredImage mesh_picture(const core::StoredImage& rendered, const Sheet& sheet, bool lag);

}  // namespace lentray::diff
