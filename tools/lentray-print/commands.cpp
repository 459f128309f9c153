#include "tools/lentray-print/commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "camera/text.h"
#include "core/image/writer.h"
#include "parser/options/ini.h"
#include "tools/lentray-print/page_error.h"
#include "tools/lentray-print/page_file.h"
#include "tools/lentray-print/report_text.h"
#include "tools/lentray-print/sheet_run.h"
#include "tools/lentray-print/test_pages.h"

namespace lentray::print {

using camera::format;
using parser::OptionError;

namespace {

constexpr double kUsualDpi = 600.0;

std::vector<double> lpis_of(const Arguments& a) {
  constexpr double kFineSpan = 0.1, kFineStep = 0.01;
  const bool is_phase = a.command == Command::phase_test;
  const double nominal = kInch / *a.lens.lens_pitch;
  const double span = a.fine ? kFineSpan : a.span.value_or(is_phase ? 0.2 : 0.5);
  if (a.bands) {
    if (*a.bands == 1) return {nominal};
    std::vector<double> all;
    all.reserve(static_cast<std::size_t>(*a.bands));
    for (int i = 0; i < *a.bands; ++i)
      all.push_back(nominal + span * (2.0 * i / (*a.bands - 1) - 1.0));
    return all;
  }
  const double step = a.fine ? kFineStep : a.step.value_or(0.1);
  constexpr double kMost = 100.0;
  if (span / step > kMost) {
    throw OptionError("a span of " + format(span) + " lpi by " + format(step) + " makes " +
                      format(2.0 * std::floor(span / step) + 1.0) + " gratings; 201 are possible");
  }
  return series(nominal, span, step);
}

Page test_page_of(const Arguments& a) {
  constexpr parser::Extent kPage{200.0, 100.0};
  const parser::Extent size = a.size.value_or(kPage);
  TestPaper paper{.width = a.horizontal ? size.height : size.width,
                  .height = a.horizontal ? size.width : size.height,
                  .dpi = a.lens.dpi_x.value_or(kUsualDpi),
                  .is_hard = a.hard_edges};
  paper.dpi_along = a.lens.dpi_y.value_or(paper.dpi);
  constexpr double kMostPixels = 100000.0;
  if (std::max(paper.width * paper.dpi, paper.height * paper.dpi_along) / kInch > kMostPixels) {
    throw PageError("a test page of " + size_text(size.width, size.height) + " at " +
                    dpi_text(paper.dpi, paper.dpi_along) + " has more than 100000 pixels a side");
  }
  if (a.command == Command::eye_test) {
    return eye_test(paper, {.lens_pitch = *a.lens.lens_pitch,
                            .focal_length = a.focal_length,
                            .ior = a.ior,
                            .distance = a.distance,
                            .separation = a.separation});
  }
  std::vector<double> lpis = lpis_of(a);
  if (!(lpis.front() >= 1.0)) {
    throw OptionError("gratings down to " + format(lpis.front()) +
                      " lines an inch: 1 is the least; give a smaller --span");
  }
  return a.command == Command::pitch_test ? pitch_test(paper, std::move(lpis))
                                          : phase_test(paper, std::move(lpis), a.phases);
}

Report run_test(const Arguments& a) {
  Page page = finished(test_page_of(a), a);
  Report report;
  report.lines.push_back(a.out.string() + ": " + page.title + "; page " +
                         size_text(page.width, page.height));
  if (a.lens.dpi_y) {
    report.lines.push_back(format(a.lens.dpi_x.value_or(kUsualDpi)) + " dpi across the lenses, " +
                           format(*a.lens.dpi_y) + " along them: print it so");
  }
  if (a.command == Command::pitch_test) {
    report.lines.push_back(
        "The number that is read off is for lentray: Print_LPI=NUMBER View_Distance=V, with the "
        "distance that the test was looked at from. Where a picture is there already, "
        "lentray-print "
        "sheet --pitch NUMBERlpi fits it");
  }
  constexpr int kBits = 8;
  report.warnings = write_pages({{"", [&page] { return std::move(page); }}}, a.out, kBits);
  return report;
}

}  // namespace

Report run_command(const Arguments& a) {
  check_page_file(a.out);
  core::check_writable(a.out);
  return a.command == Command::sheet ? run_sheet(a) : run_test(a);
}

}  // namespace lentray::print
