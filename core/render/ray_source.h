// Where camera rays come from; camera/ implements it. World space. Immutable, any number of threads.
#pragma once

#include <cstdint>

#include "core/base/ray.h"
#include "core/render/eye_place.h"
#include "core/render/pixel_lattice.h"

namespace lentray::core {

/// A place in a pixel's own area. What the area is, the camera decides: a pixel of an ordinary
/// picture has its square of the picture, one of a lens sheet its lens's width.
struct PixelPlace {
  std::int32_t column = 0, row = 0;  ///< may lie outside the picture
  double across = 0.0, down = 0.0;   ///< from the pixel's centre, in its area's width and height
  /// From the middle of the directions the pixel covers, -0.5 to 0.5; only pixels of a lens sheet
  /// cover more than one.
  double turn = 0.0;
};

/// One of the rays of a place.
struct PlaceRay {
  std::uint32_t number = 0;
  SpreadPlace through{};  ///< of the aperture of its lens, and of the height of its pixel's row
};

class FocalBlur;

class RaySource {
 public:
  virtual ~RaySource() = default;
  /// Ray through a place of the image in pixels: the centre of pixel (i, k) is (i + 0.5, k + 0.5),
  /// row 0 on top. World space; the direction is unit unless the camera documents otherwise.
  /// False: the pixel shows nothing and is black.
  virtual bool ray(double column, double row, Ray& ray) const = 0;
  /// Ray through a place of a pixel's area. At a pixel's centre the same as ray(), bit for bit.
  virtual bool ray_at(const PixelPlace& place, Ray& out) const {
    return ray(place.column + 0.5 + place.across, place.row + 0.5 + place.down, out);
  }
  /// How many rays a place has, each of which counts alike: their mean is seen.
  virtual std::uint32_t rays_a_place() const { return 1; }
  /// One of them; false: it is none. Whether that counts, missing_rays_are_black() says.
  virtual bool one_ray_at(const PixelPlace& place, [[maybe_unused]] const PlaceRay& which,
                          Ray& out) const {
    return ray_at(place, out);
  }
  /// A ray of a place that is none counts as a black one. Otherwise it does not count.
  virtual bool missing_rays_are_black() const { return false; }
  /// How a camera with an aperture blurs; null: all rays of a place are one. Lives as long as it.
  virtual const FocalBlur* blur() const { return nullptr; }
  /// Ray through a place of a pixel's area from a point of the aperture, in the aperture's own units
  /// (core/render/focal_blur.h). All such rays meet where the camera is in focus.
  virtual bool lens_ray_at(const PixelPlace& place, [[maybe_unused]] double x,
                           [[maybe_unused]] double y, Ray& out) const {
    return ray_at(place, out);
  }
  /// Of an ordinary picture each column is a lens of one view.
  virtual EyePlace eye_place(std::uint32_t column, std::uint32_t row) const {
    return {column, row, 0};
  }
  /// Ray `number` of rays_a_place() of a pixel that is seen there.
  PlaceRay ray_of(const EyePlace& at, std::uint32_t number) const {
    return {number, spread_place(at, number, rays_a_place())};
  }
  /// How the areas of the pixels of a picture of that width join.
  virtual PixelLattice lattice(std::uint32_t width) const { return PixelLattice::in_rows(width); }
};

}  // namespace lentray::core
