// Antialiasing method 1: adaptive, not recursive. All pixels' centres come first, in the pixel
// order; then, row by row, a pixel is compared with what its left and upper neighbours have become,
// and where two differ both get depth x depth samples more.
//
// What a pixel becomes depends on what happened before it, so the rows are chains. They begin anew
// in tiles of PixelLattice::kTile pixels each way, counted from the image's corner: a tile sees the
// bare centres of the pixels around it. So tiles can be traced alone and at once, and a part of a
// picture has the whole picture's pixels. Within a tile, pixels that do not join one another (other
// views behind a lens sheet) are chains of their own.
// Source: reference manual 3.7, "Sampling_Method"; the order of the comparisons and the weights
// measured on stock by tests/image/antialiasing_test.cpp.
#pragma once

#include <memory>

#include "core/render/film.h"

namespace lentray::core {

std::unique_ptr<Film> make_film_of_centres(FilmSetup setup, const BandOrders& orders);
FilmColumns traced_columns_of_centres(const FilmSetup& setup);

}  // namespace lentray::core
