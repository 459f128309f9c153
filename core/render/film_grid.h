// Every pixel is the mean of depth x depth samples at the middles of its cells, whatever they show:
// no pixel is compared with another, and there is no jitter. For references that other settings are
// held against.
#pragma once

#include <memory>

#include "core/render/film.h"

namespace lentray::core {

std::unique_ptr<Film> make_film_of_grids(FilmSetup setup, const BandOrders& orders);

}  // namespace lentray::core
