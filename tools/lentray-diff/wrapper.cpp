#include "tools/lentray-diff/wrapper.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "core/base/formed.h"
#include "tools/common/scene_scanner.h"

namespace lentray::diff {

using core::StoredImage;
using core::Vec3;
using tool::SceneScanner;

namespace {

std::string text_of(double value) { return core::formed("%.17g", value); }

std::string text_of(const Vec3& v) {
  return "<" + text_of(v.x) + "," + text_of(v.y) + "," + text_of(v.z) + ">";
}

std::string head(const Included& scene) {
  return scene.version + "\n#include \"" + scene.path + "\"\n";
}

struct Block {
  std::size_t open = 0, close = 0;  ///< of the braces
  bool lenticular = false;
};

/// A camera's braces; the scanner stands behind the word `camera`. False if none follow.
bool camera_block(SceneScanner& scanner, Block& block) {
  if (scanner.next() != "{") return false;
  block.open = scanner.begin();
  int depth = 1;
  for (std::string_view token = scanner.next(); !token.empty(); token = scanner.next()) {
    if (token == "{") ++depth;
    if (token == "}" && --depth == 0) {
      block.close = scanner.begin();
      return true;
    }
    if (token == "lenticular" && depth == 1) block.lenticular = true;
  }
  return false;
}

/// Views of a cut last lens have fewer pixels: where their middle lies, scene units along r.
double middle_of_view(const Sheet& s, std::uint32_t width) {
  return (width - s.lenses()) / 2.0 * s.pitch * s.scale();
}

std::string camera(const char* kind, const Vec3& location, const Vec3& direction, const Vec3& right,
                   const Vec3& up) {
  return std::string("camera {\n  ") + kind + "\n  location " + text_of(location) +
         "\n  direction " + text_of(direction) + "\n  right " + text_of(right) + "\n  up " +
         text_of(up) + "\n}\n";
}

}  // namespace

const char* name_of(Way way) {
  switch (way) {
    case Way::orthographic_views: return "oblique orthographic views";
    case Way::perspective_views: return "oblique perspective views";
    case Way::mesh_camera: break;
  }
  return "mesh_camera";
}

Way best_way(const Sheet& s) {
  if (!s.has_views()) return Way::mesh_camera;
  const double eye = s.eye_distance();
  if (std::isinf(eye))
    return s.paraxial || !s.is_finite() ? Way::orthographic_views : Way::mesh_camera;
  // Stock starts at the eye: only then does it see the same things.
  const bool from_eye = std::abs(s.front - eye) <= 1e-9 * eye;
  return s.paraxial && from_eye ? Way::perspective_views : Way::mesh_camera;
}

std::string version_directive(const std::string& scene) {
  SceneScanner scanner(scene);
  for (std::string_view token = scanner.next(); !token.empty(); token = scanner.next()) {
    if (token != "#") continue;
    const std::size_t begin = scanner.begin();
    if (scanner.next() != "version") continue;
    const std::size_t end = scene.find_first_of(";\n", scanner.end());
    const std::string value = scene.substr(scanner.end(), end - scanner.end());
    // An expression over identifiers cannot be asked before the scene is read.
    const bool plain = value.find_first_not_of("0123456789. \t\r") == std::string::npos;
    return plain ? scene.substr(begin, end - begin) + ";" : std::string();
  }
  return {};
}

std::vector<std::string> included_files(const std::string& scene) {
  std::vector<std::string> files;
  SceneScanner scanner(scene);
  for (std::string_view token = scanner.next(); !token.empty(); token = scanner.next()) {
    if (token != "#" || scanner.next() != "include") continue;
    if (const auto name = scanner.next_string(); !name.empty()) files.emplace_back(name);
  }
  return files;
}

std::string without_lenticular(const std::string& scene, bool& changed) {
  changed = false;
  std::string out = scene;
  SceneScanner scanner(scene);
  std::size_t shift = 0;
  for (std::string_view token = scanner.next(); !token.empty(); token = scanner.next()) {
    Block block;
    if (token != "camera" || !camera_block(scanner, block) || !block.lenticular) continue;
    std::string replacement = " orthographic ";
    for (std::size_t i = block.open; i < block.close; ++i) {
      if (scene[i] == '\n') replacement += '\n';
    }
    const std::size_t length = block.close - block.open - 1;
    out.replace(block.open + 1 + shift, length, replacement);
    shift += replacement.size() - length;  // wraps round when shorter, and back when added
    changed = true;
  }
  return out;
}

std::string view_scene(const Sheet& s, std::uint32_t view, Way way, const Included& scene) {
  const std::uint32_t width = s.view_width(view);
  const Vec3 middle = s.centre + s.right * middle_of_view(s, width);
  const Vec3 right = s.right * (width * s.pitch * s.scale());
  const Vec3 up = s.up * s.height;
  if (way == Way::orthographic_views) {
    const auto slope = s.slope(view);
    if (!slope) throw std::logic_error("a dark view has no camera");
    const Vec3 v = s.right * *slope + s.direction + s.up * s.eye_slope_y;
    return head(scene) + camera("orthographic", middle - v * s.front, normalized(v), right, up);
  }
  if (way != Way::perspective_views) throw std::logic_error("a mesh_camera shows no single view");
  const double distance = s.eye_distance();
  const double slope = s.ior * s.cell_offset(view) / s.focal_length + s.eye_slope_x;
  const Vec3 eye = s.centre - (s.right * slope + s.up * s.eye_slope_y + s.direction) * distance;
  return head(scene) + camera("perspective", eye, middle - eye, right, up);
}

namespace {

/// Stock keeps a mesh's corners and normals as floats and its transforms as doubles. So one mesh
/// holds a column's rows, in numbers that floats hold exactly (halves, times a power of two), and
/// each column is a transform of it, which also says how far a step of a row reaches.
struct ColumnMesh {
  double inverse = 0.0;      ///< 1/V or 1/D, scene units
  double row = 0.0;          ///< a row's height
  double stretch = 1.0;      ///< scene units a unit of the mesh's y
  double start_step = 0.0;   ///< y from one row's face to the next
  double normal_step = 0.0;  ///< y of the normal (0, y, 1), likewise

  explicit ColumnMesh(const Sheet& s) : row(s.height / s.rows) {
    inverse = 1.0 / s.eye_distance();
    const double sideways = row * (1.0 - s.front * inverse);  // between the starts of two rows
    if (std::abs(sideways) < 1e-9 * row) {                    // all rays start at the eye
      normal_step = std::ldexp(1.0, -30);  // so small that making it unit changes no bit
      stretch = normal_step / (row * inverse);
    } else {
      start_step = 1.0;
      stretch = sideways;
      normal_step = row * inverse * stretch;  // exact if V is infinite
    }
  }
};

/// The faces of a column, `down` rows below the pixels' centres. A face's ray starts at its centroid and runs along (P3 - P1) x (P2 - P1).
std::string column_mesh(const Sheet& s, const ColumnMesh& mesh, double down) {
  std::ostringstream out;
  out << "mesh {\n";
  for (std::uint32_t r = 0; r < s.rows; ++r) {
    const double y = s.rows / 2.0 - r - 0.5 - down, normal = y * mesh.normal_step;
    // Its place in the transform's shear is undone, so that starts stay in their plane.
    const Vec3 c = Vec3{0.0, 1.0, s.eye_slope_y * mesh.stretch} * (y * mesh.start_step);
    const Vec3 across{0.25, 0.0, 0.0}, upwards{0.0, 0.25, -0.25 * normal};
    out << "triangle { " << text_of(c - across + upwards) << ", " << text_of(c + across + upwards)
        << ", " << text_of(c - upwards * 2.0) << " }\n";
  }
  out << "}\n";
  return out.str();
}

/// A number for every column at every offset.
template <class Value>
std::string array_of(const char* name, const Sheet& s, const std::vector<PixelOffset>& offsets,
                     const Value& value) {
  std::ostringstream out;
  out << "#declare " << name << " = array[" << s.columns * offsets.size() << "] {\n";
  const char* between = "";
  for (const PixelOffset& offset : offsets) {
    for (std::uint32_t k = 0; k < s.columns; ++k) {
      out << between << text_of(value(k, offset));
      between = ",\n";
    }
  }
  out << "\n}\n";
  return out.str();
}

}  // namespace

std::string mesh_scene(const Sheet& s, const Included& scene,
                       const std::vector<PixelOffset>& offsets) {
  const ColumnMesh mesh(s);
  std::ostringstream out;
  out << head(scene)
      << "#declare Lentray_Diff_Column = " << column_mesh(s, mesh, offsets.at(0).down)
      << array_of(
             "Lentray_Diff_T", s, offsets,
             [&](std::uint32_t k, const PixelOffset& o) { return s.slope(k, o).value_or(0.0); })
      << array_of("Lentray_Diff_X", s, offsets, [&](std::uint32_t k, const PixelOffset& o) {
           return s.axis(s.lens_of(k) + o.across) * s.scale();
         });
  const auto vector = [](const Vec3& v) {
    return text_of(v.x) + "," + text_of(v.y) + "," + text_of(v.z);
  };
  const double rise = s.eye_slope_y;
  // The normal (0, m, 1) becomes (T, rise + m/stretch, 1), for it transforms by the inverse
  // transpose; then comes the place in the sheet, and the sheet's in the world.
  out << "camera {\n  mesh_camera { 1 1\n    #for (Lentray_Diff_K, 0, "
      << s.columns * offsets.size() - 1 << ")\n"
      << "      #local Lentray_Diff_U = Lentray_Diff_T[Lentray_Diff_K];\n"
      << "      mesh { Lentray_Diff_Column\n        matrix <1,0,-Lentray_Diff_U, 0,"
      << text_of(mesh.stretch) << "," << text_of(-rise * mesh.stretch) << ", 0,0,1,\n"
      << "          Lentray_Diff_X[Lentray_Diff_K] - " << text_of(s.front) << "*Lentray_Diff_U, "
      << text_of(-s.front * rise) << ", " << text_of(-s.front) << ">\n        matrix <"
      << vector(s.right) << ", " << vector(s.up) << ", " << vector(s.direction) << ", "
      << vector(s.centre) << ">\n      }\n    #end\n  }\n  location <0,0,0>\n}\n";
  return out.str();
}

StoredImage mesh_picture(const StoredImage& rendered, const Sheet& s, bool lag) {
  StoredImage image = core::black_rgb(s.columns, s.rows, rendered.bits);
  for (std::uint32_t k = 0; k < s.columns; ++k) {
    if (!s.slope(k)) continue;  // shows nothing
    for (std::uint32_t r = 0; r < s.rows; ++r) {
      for (int c = 0; c < 3; ++c) {
        image.at(k, r, c) = rendered.at(r, k + (lag ? 1 : 0), rendered.channels < 3 ? 0 : c);
      }
    }
  }
  return image;
}

}  // namespace lentray::diff
