// A film of each method from its plan and its bands. Internal to the films.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "core/render/film.h"

namespace lentray::core {

/// What all bands of a film share.
struct FilmPlan {
  FilmPlan(FilmSetup s, const BandOrders& o) : setup(std::move(s)), orders(o) {}
  FilmSetup setup;
  const BandOrders& orders;
};

/// The plan is made of the setup and the orders; a band of the plan, the rows [first, end), and the image that
/// begins with row `top`.
template <class Plan, class Band>
class FilmOf final : public Film {
 public:
  FilmOf(FilmSetup setup, const BandOrders& orders) : m_plan(std::move(setup), orders) {}
  std::unique_ptr<FilmBand> band(std::uint32_t top, std::uint32_t bottom,
                                 Image& image) const override {
    const PixelRegion& region = m_plan.setup.region;
    const std::uint32_t grain = rows_together(m_plan.setup.antialiasing);
    const std::uint32_t first = std::max(top, region.top / grain * grain);
    const std::uint32_t end = std::min(bottom, (region.bottom + grain - 1) / grain * grain);
    if (first >= end || region.top >= region.bottom || region.left >= region.right) return nullptr;
    return std::make_unique<Band>(m_plan, first, end, top, image);
  }

 private:
  const Plan m_plan;
};

std::unique_ptr<Film> make_film_of_centres(FilmSetup setup, const BandOrders& orders);
FilmColumns traced_columns_of_centres(const FilmSetup& setup);

/// The place of a pixel's sample among those that an eye blends, of this pixel and of its neighbours: well apart.
SamplePlace spread_sample(const RaySource& camera, const Pixel& pixel, std::uint32_t number);
std::unique_ptr<Film> make_film_of_spread(FilmSetup setup, const BandOrders& orders);
FilmColumns traced_columns_of_spread(const FilmSetup& setup);

std::unique_ptr<Film> make_film_of_corners(FilmSetup setup, const BandOrders& orders);
FilmColumns traced_columns_of_corners(const FilmSetup& setup);

}  // namespace lentray::core
