// Parallax of a lens sheet: how far points move from one view to the next, and which depths move by
// less than a given distance. Depths are scene units behind the sheet, negative before it. Pixels are
// those of a view, one a lens. Pure; any number of threads.
//
// With V infinite a point at the depth z moves by n ps z/(f P) pixels a view, with V finite by
// n ps/(f P) z/(1 + z/V): ps is a pixel of the print, z in mm. With an eye of the scene's (camera/scene_eye.h) it is m times
// that, with D for V. A pixel of the print is seen from a range
// of directions n ps/f wide, which draws a point out by as much. So what moves by at most a pixel a
// view is as sharp as lenses can show it. With V infinite that is a depth of 2 N t/n in all.
// Sources: docs/lens/formulae.md; pop3dart.com, "What is the main figure of merit of your lenticular
// printing technology"; on depth of field as the band that views hold: M. Zwicker, W. Matusik, F. Durand,
// H. Pfister, "Antialiasing for Automultiscopic 3D Displays" (2006).
#pragma once

#include <vector>

#include "camera/lenticular.h"

namespace lentray::camera {

/// How far, in pixels of a view (one a lens), points move from one view to the next: by their depth in mm
/// behind the sheet (negative: before it). Positive behind the sheet, where things move along with the eye.
struct ParallaxRule {
  double step = 0.0;  ///< pixels for a mm of depth at the sheet
  double turn = 0.0;  ///< by how much less it is farther away, a mm of depth
  /// Infinite depths have one where the eye is near. -inf: rays of neighbouring views part or meet before the
  /// point, as they may near the eyes.
  double at(double mm) const;
};
/// `bend`: how much directions change a mm of the print; n/f under lenses seen straight on.
ParallaxRule parallax_rule(const Lenticular& sheet, double bend);
/// Of a sheet whose scene's eye is `eye` mm before it, with the factor m (camera/scene_eye.h).
ParallaxRule parallax_rule(const LensParameters& lens, double eye, double factor, double bend);

/// parallax_rule() of a depth in scene units, under lenses seen straight on.
double parallax(const Lenticular& sheet, double depth);

/// How much the directions of a lens's pixels change a mm of the print, by column: to the neighbour on
/// that side where they change more. With the paraxial model n/f; with Snell's law outer views are
/// farther apart.
std::vector<double> column_bends(const LensSheet& sheet);
/// The largest of them.
double most_bend(const LensSheet& sheet);

/// Parallax from view to view, in pixels of a view, beyond which the eye sees jumps and double edges.
/// Source: pop3dart.com, "Depth: it's all about parallax and sequence length".
inline constexpr double kMostParallax = 1.5;
/// Up to which the lenses show points as sharply as they can.
inline constexpr double kSharpParallax = 1.0;

struct DepthInterval {
  double nearest = 0.0;   ///< negative; above -V
  double farthest = 0.0;  ///< may be infinite
};
/// Where points move by at most so many pixels a view.
DepthInterval depths_within(const Lenticular& sheet, double pixels);

}  // namespace lentray::camera
