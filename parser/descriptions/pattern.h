// A pattern with its modifiers as written, shared by pigments, normals, textures and densities.
// `placement` keeps warps, turbulence and transforms from the pattern outwards: a point of the world
// goes through it backwards, last entry first, before the pattern reads it. Statements append to
// it in the order of the text, except turbulence outside a warp, which is one entry in front, wherever
// it was written (measured on stock: `scale 2 turbulence 1` is `turbulence 1 scale 2`).
// Source: reference manual 3.7, "Patterns", "Pattern Modifiers", "Warps".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/transform.h"
#include "core/base/vec3.h"
#include "core/pattern/pattern.h"
#include "core/pattern/placement.h"
#include "parser/base/edit.h"
#include "parser/base/sparse.h"
#include "parser/descriptions/nesting.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::parser {

enum class PatternKind {
#define LENTRAY_PATTERN(kind, words) kind,
#include "parser/descriptions/patterns.def"
#undef LENTRAY_PATTERN
};

/// The keyword of a pattern, for messages.
const char* pattern_name(PatternKind kind);

using WaveForm = core::Wave::Form;

/// What warps have that are no transforms.
struct WarpParameters {
  core::Turbulence turbulence;
  // repeat
  int axis = 0;
  double width = 0.0;
  core::Vec3 flip{1, 1, 1}, offset;
  core::BlackHole hole;
  // mappings
  core::Vec3 orientation{0, 0, 1};
  double distance_exponent = 0.0, major_radius = 1.0, plane_offset = 0.0;
};

struct WarpDesc {
  enum class Kind {
    kTransform,
    kTurbulence,         ///< warp { turbulence }
    kClassicTurbulence,  ///< turbulence outside a warp: some patterns apply it in their own way
    kRepeat,
    kBlackHole,
    kSpherical,
    kToroidal,
    kPlanar,
    kCylindrical,
    kCubic
  };
  Kind kind = Kind::kTransform;
  Sparse<core::Transform> transform;
  Sparse<WarpParameters> own;
};

/// image_map, bump_map, image_pattern, material_map: a picture as a pattern. The file is looked up
/// while parsing (path), and read when it is used.
struct ImageDesc {
  std::string type;  ///< keyword or extension: "png"; "function" for a computed one
  std::string name;  ///< as written
  FoundFile path;    ///< empty if it was not found
  Location where;    ///< of the name
  Ref<FunctionDesc> function;
  int function_width = 0, function_height = 0;
  double gamma = 0.0;          ///< 0: the file's own; -1: srgb
  double working_gamma = 1.0;  ///< of the scene where the image stands; -1: srgb
  /// Which files are decoded to the working gamma without `gamma`.
  enum class Decoding { kNone, kMarked, kAll } decoding = Decoding::kAll;
  std::optional<bool> premultiplied;
  bool once = false;
  int map_type = 0, interpolate = 0;
  enum class Use { kDefault, kColour, kIndex, kAlpha } use = Use::kDefault;
  core::Vec2 repeat{1, 1}, offset;
  std::optional<double> filter_all, transmit_all;
  std::vector<std::pair<int, double>> filters, transmits;  ///< by palette index
};

/// What only some kinds of pattern have.
struct PatternParameters {
  core::Vec3 vector;  ///< gradient's direction, slope's
  core::Vec3 brick_size{8, 3, 4.5};
  double mortar = 0.5;
  double agate_turbulence = 1.0;
  int arms = 0;  ///< of a spiral
  double quilt0 = 1.0, quilt1 = 1.0;
  double facets_coords = 0.0, facets_size = 0.1, facets_metric = 2.0;
  core::Vec3 crackle_form{-1, 1, 0};
  double crackle_metric = 2.0, crackle_offset = 0.0;
  bool crackle_solid = false;
  // mandel, julia, magnet
  core::Vec2 julia;
  int iterations = 0, exponent = 2, magnet = 0;
  int exterior_type = 1, interior_type = 0;
  double exterior_factor = 1.0, interior_factor = 1.0;
  // slope
  core::Vec3 altitude;
  double slope_low = 0.0, slope_high = 0.0, altitude_low = 0.0, altitude_high = 0.0;
  bool slope_point_at = false;
  int tiling = 1;
  // pavement
  int pavement_sides = 3, pavement_tiles = 1, pavement_pattern = 1;
  int pavement_exterior = 0, pavement_interior = 0, pavement_form = 0;

  Ref<FunctionDesc> function;
  std::shared_ptr<const ImageDesc> image;
  Ref<ObjectDesc> object;  ///< object, potential
  bool potential_threshold = false;
  Ref<PigmentDesc> pigment;  ///< pigment_pattern
  std::string density_file;
  FoundFile density_path;
  int density_interpolate = 0;
};

struct PatternDesc {
  PatternKind kind = PatternKind::kPlain;
  Location where;
  std::vector<WarpDesc> placement;

  double frequency = 1.0, phase = 0.0;
  WaveForm wave = WaveForm::kRamp;
  double wave_exponent = 1.0;  ///< of poly_wave
  int noise_generator = 0;     ///< 0: the scene's

  Sparse<PatternParameters> own;

  Nesting nesting;  ///< of the statement the pattern belongs to, its map included

  /// The one turbulence outside warps, made if there is none yet.
  core::Turbulence& classic_turbulence();
  void transform(const core::Transform& by);
};

/// A pigment, normal or density after one more transform; null stays null. An original that others
/// share stays as it is.
template <typename Desc>
Ref<Desc> transformed(Ref<Desc> desc, const core::Transform& transform) {
  if (desc) edit(desc).pattern.transform(transform);
  return desc;
}

}  // namespace lentray::parser
