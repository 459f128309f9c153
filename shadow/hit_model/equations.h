// The paper's closed forms of hits, equations 6 to 19, as they are printed, with what print and text
// leave open decided as docs/paper/equations.md says. How far they are from the truth is enumeration.h's to
// say. (Equations 1 to 5 are what hits and misses cost.)
//
// The paper: Youssef, Aggoun, Wolf, McCormick, "Pixels Grouping and Shadow Cache for Faster
// Integral 3D Ray-Tracing". Its camera: viewing distance infinite, whole N, every ray of a lens
// through one point (the pinhole). Its shadow: a rectangle on a plane facing the sheet.
//
// Units: mm, radians, pixels. Pure functions, any number of threads; no
// errors: arguments outside the range of validity that each function names give a number all the
// same, which means nothing.
#pragma once

#include <cstdint>

#include "camera/lens_sheet.h"

namespace lentray::shadow::paper {

// One lens --------------------------------------------------------------------------------------

/// What equation 6 takes for the angle of a lens's fan of rays.
enum class Alpha {
  kPrinted,    ///< no n: the angle inside the sheet, 21.02 degrees with the paper's lens
  kRefracted,  ///< with n: the angle in the air, 33.93 degrees (pinhole model)
};
const char* name_of(Alpha alpha);

/// (6) alpha = 2 atan(N ps / 2f), and with n as the lens refracts it. Radians, below pi; pi where
/// the fan's edge is totally reflected.
double fan_angle(const camera::LensParameters& lens, Alpha kind);

/// (7) beta = alpha / N: between neighbouring rays. Taken as equal for all: valid for small alpha.
double ray_angle(double alpha, double pixels);

/// (8) theta = atan(A / D): the angle of the shadow as a lens sees it that is straight before one
/// of its ends; other lenses see less, and half of it each way when straight before its middle
/// more (2 atan(A/2D)). D = 0: pi/2.
double shadow_angle(double width, double distance);

/// (9) CCWLhit = floor(theta / beta): hits in one lens. Valid for theta < alpha. Counts gaps
/// between rays: up to one more hit.
std::uint64_t hits_by_angles(double theta, double beta);

/// (10) = (9) with (6) and (8) put in, its floor given back, and at most N. Valid for all D >= 0
/// but for lenses that see a part of the shadow only.
std::uint64_t hits_in_lens(const camera::LensParameters& lens, double width, double distance,
                           Alpha kind);

// From lens to lens (style 1, "rows") -------------------------------------------------------------

/// (11) X2 = LAstart + P n - D tan(alpha/2): where the first ray of lens n meets the plane.
/// `array_start`: the axis of lens 0. It is the edge of the fan, half a pixel beyond that ray.
double first_place(const camera::LensParameters& lens, double array_start, double n,
                   double distance, Alpha kind);
/// The same of the last ray, which (14) takes to hit the shadow: LAstart + P n + D tan(alpha/2).
double last_place(const camera::LensParameters& lens, double array_start, double n, double distance,
                  Alpha kind);

/// (12) X2 >= Xend - A: whether the first ray of the next lens is not before the shadow.
bool crosses(double first_place_of_next, double shadow_end, double width);

/// (13) CSTAL, 1 or 0.
int crossing_status(double first_place_of_next, double shadow_start);

/// (14) CCLhit = CCWLhit + CSTAL; at most N, for a lens has no more rays. Valid if the lens's last
/// ray hits the shadow.
std::uint64_t hits_with_crossing(std::uint64_t in_lens, int status, double pixels);

/// Where the lenses and the shadow are; the paper leaves it open. Across the sheet.
struct Across {
  double array_start = 0.0;  ///< axis of lens 0, mm
  std::uint32_t lenses = 0;
  double start = 0.0;     ///< Xstart, mm
  double width = 0.0;     ///< A, mm; Xend = start + width
  double distance = 0.0;  ///< D, mm
};

/// (15) CChit of style 1: CCLhit of the first lens, and of the lenses after it as far as the
/// product of the CSTAL holds. Lens 0 of the sum is the first whose last ray hits the shadow and
/// that is crossed from; if there is none, nothing is crossed and CCWLhit is all.
std::uint64_t style1_hits(const camera::LensParameters& lens, const Across& across, Alpha kind);

// The other styles --------------------------------------------------------------------------------

/// (16) CChit of style 2 ("views"): floor(A / P), for the rays of a view are parallel. Valid away
/// from the sheet's edges; up to one more hit.
std::uint64_t style2_hits(const camera::LensParameters& lens, double width);

/// n of (17): the lenses whose fan meets the shadow, an end of one touching the other included.
std::uint32_t lenses_that_see(const camera::LensParameters& lens, const Across& across, Alpha kind);

/// (17) CChit of the combined style: the sum of CCWLhit + 1 over the n lenses that see the shadow,
/// with at most N a lens. Counts each of them as if it saw the whole shadow.
std::uint64_t combined_hits(const camera::LensParameters& lens, const Across& across, Alpha kind);

/// (18) CChit of style 3 ("columns"): floor(A / ps); A is the shadow's height. Valid within the
/// sheet; up to one more hit.
std::uint64_t style3_hits(const camera::LensParameters& lens, double height);

/// (19) CChit of the two-dimensional style ("strips"): (17) times (18).
std::uint64_t two_dimensional_hits(const camera::LensParameters& lens, const Across& across,
                                   double height, Alpha kind);

}  // namespace lentray::shadow::paper
