// Renders the settings of a chart, in rounds: every setting once, then every setting once more, so that a slower spell
// of the machine meets all alike. What is there already is not rendered again.
// Errors: Stopped; std::runtime_error when the plain setting fails. One thread.
#pragma once

#include "tools/lentray-chart/session.h"

namespace lentray::chart {

/// How often a setting is timed that takes `seconds`: `wanted` times below 10 s, at most twice below 60 s, else once.
int repeats_for(double seconds, int wanted);

/// Points, and what was found with pictures, that are gone, emptied or cut lose it: it is made again.
void forget_lost_pictures(Session& session);

/// Rounds first to last, counted from 0, over all points. The state is saved after each run.
void measure(Session& session, int first, int last);

/// One more run of a point, counted with the others.
void measure_again(Session& session, Point& point);

/// Stock's version goes into the chart, or why there is none.
void find_stock(Session& session);

/// Of a sheet: what lentray-diff says of the plain picture, whose views it has stock render one after another.
void compare_sheet_with_stock(Session& session);

}  // namespace lentray::chart
