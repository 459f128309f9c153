// Antialiasing method 2: adaptive and recursive. The corners of all pixels come first, in the pixel
// order; then each pixel whose corners differ is cut into quarters, and these into theirs, `depth`
// times at most. Pixels do not depend on each other.
// Source: reference manual 3.7, "Sampling_Method"; places, weights and jitter measured on stock by
// tests/image/antialiasing_test.cpp.
#pragma once

#include <memory>

#include "core/render/film.h"

namespace lentray::core {

std::unique_ptr<Film> make_film_of_corners(FilmSetup setup, const BandOrders& orders);
FilmColumns traced_columns_of_corners(const FilmSetup& setup);

}  // namespace lentray::core
