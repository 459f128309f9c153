// What the page's script knows as JSON: the settings with their figures and pictures. Keys are those of page.js, which
// reads them. Pure functions; threads: any number. Errors: none.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tools/lentray-chart/page.h"
#include "tools/lentray-chart/page_pictures.h"

namespace lentray::chart {

/// Whether the page's fields may choose it, as --budget and --error do: measured, and no lens model, whose errors are
/// against another reference.
bool can_be_chosen(const Point& point);

nlohmann::json page_data(const Chart& chart, const PageOptions& options,
                         const PagePictures& pictures);

}  // namespace lentray::chart
