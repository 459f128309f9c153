// All three answers for every point of a grid of (A, D): equations, enumeration, kernel.
// mm and rays. Points are spread over threads; results do not depend on their number.
// Errors: std::invalid_argument, std::logic_error of the model.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shadow/hit_model/enumeration.h"
#include "tools/common/csv.h"
#include "tools/lentray-model/arguments.h"

namespace lentray::model {

struct Point {
  double a = 0.0, d = 0.0;
  std::optional<std::uint64_t> printed, refracted;  ///< closed forms, none for fixed strips
  std::uint64_t enumerated = 0;
  std::optional<std::uint64_t> measured;

  std::optional<std::uint64_t> closed(shadow::paper::Alpha alpha) const {
    return alpha == shadow::paper::Alpha::kPrinted ? printed : refracted;
  }
};

/// One style's points, A by A, of each all D.
struct StyleGrid {
  shadow::Style style;
  std::vector<Point> points;
};

struct Grid {
  std::vector<double> a, d;
  std::vector<StyleGrid> styles;
};

/// One point, not measured.
Point model_point(const shadow::PaperSheet& sheet, const shadow::Enumeration& enumeration,
                  const shadow::ShadowSquare& shadow, const shadow::Style& style);

/// `measured`: which styles are rendered too. `progress`: told the part that is done, from any
/// thread; may be empty.
Grid make_grid(const Arguments& arguments, const shadow::PaperSheet& sheet,
               const std::vector<shadow::Style>& styles,
               const std::function<bool(const shadow::Style&)>& measured,
               const std::function<void(double)>& progress);

/// The CSV: style,A,D,xstart,closed_form,enumerated,measured.
std::string csv_of(const Grid& grid, const Arguments& arguments);

}  // namespace lentray::model
