// Pages that measure a lens sheet: its pitch as the eye sees it, the place of its lenses, and where the eyes are.
//
// A lens sheet that is laid on a line grating of just its pitch turns dark or light as a whole; on any other it shows
// bands, one over each length in which the two differ by a line. So the pitch of lens sheet, printer and viewing
// distance together is read off a row of gratings.
// Units: mm, pixels an inch, lines an inch. Errors: PageError where the page has no room. Pure.
#pragma once

#include <vector>

#include "tools/lentray-print/page.h"

namespace lentray::print {

struct TestPaper {
  double width = 200.0, height = 100.0;
  double dpi = 600.0;      ///< across the lenses
  double dpi_along = 0.0;  ///< along them; 0: the same
  bool is_hard = false;    ///< no grey: each edge at the nearest pixel

  double dpi_down() const { return dpi_along > 0.0 ? dpi_along : dpi; }
};

/// As many decimals as distinguish all of them and give them exactly; the values are rounded to these (4 at most).
int round_to_labels(std::vector<double>& values);
/// nominal - span .. nominal + span, the nominal one among them.
std::vector<double> series(double nominal, double span, double step);

/// A labelled band for each, from the finest to the coarsest grating; a line's middle is in the middle of the page.
Page pitch_test(const TestPaper& paper, std::vector<double> lpis);
/// A row for each, in cells that differ in where their lines are: by 1/phases of a period from one to the next.
Page phase_test(const TestPaper& paper, std::vector<double> lpis, int phases);

/// Eyes that look at a sheet: the lens, and where they are.
struct EyeTest {
  double lens_pitch = 0.635, focal_length = 1.8, ior = 1.56;
  double distance = 500.0;   ///< from the sheet
  double separation = 65.0;  ///< of the eyes
};
/// Rows for eyes at 80 % to 120 % of the distance, each black to the left eye and white to the right.
Page eye_test(const TestPaper& paper, const EyeTest& test);

}  // namespace lentray::print
