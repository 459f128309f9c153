// Holds the pictures of a chart against its references, the plain picture and stock's. Also makes the references.
// Errors: Stopped; those of reading and writing pictures. One thread.
#pragma once

#include "tools/lentray-chart/session.h"

namespace lentray::chart {

/// Renders ever more exact pictures until the change between two is a tenth of the smallest error that matters, or
/// Arguments::reference_limit is reached. Goes on where it was stopped. Says in a line what came of it.
void make_references(Session& session);

/// Errors of all points that have none yet, and the pictures of their differences.
void compare_points(Session& session);

/// Exact settings whose picture is not the plain one, a line each.
std::vector<std::string> broken_promises(const Chart& chart);

}  // namespace lentray::chart
