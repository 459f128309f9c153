// Polynomial surfaces of every order, 2 to 15, against stock: alone and cut open, from outside and from within
// their bounds. Where stock's own solver gives way, its isosurface of the same function is the reference.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

/// x^n + y^n + z^n with two terms more; the coefficients in the manual's order (powers of x fall, then of y, z),
/// and the same as a function.
struct Polynomial {
  int order;
  std::string coefficients, function;
};

Polynomial polynomial(int order) {
  Polynomial p{order, "", ""};
  for (int i = order; i >= 0; --i) {
    for (int j = order - i; j >= 0; --j) {
      for (int k = order - i - j; k >= 0; --k) {
        double value = 0.0;
        if (i == order || j == order || k == order) value = k == order && order % 2 == 1 ? .8 : 1.0;
        if (i == 1 && j == 1 && k == 0) value = .4;
        if (j == order - 1 && i + k == 0 && order > 2) value = -.5;
        if (i + j + k == 0) value = -.7;
        p.coefficients += (p.coefficients.empty() ? "" : ",") + std::to_string(value);
        if (value == 0.0) continue;
        p.function += (value < 0.0 ? "" : "+") + std::to_string(value);
        for (int n = 0; n < i; ++n) p.function += "*x";
        for (int n = 0; n < j; ++n) p.function += "*y";
        for (int n = 0; n < k; ++n) p.function += "*z";
      }
    }
  }
  return p;
}

std::string as_poly(const Polynomial& p) {
  return "poly { " + std::to_string(p.order) + ", <" + p.coefficients + "> sturm ";
}

/// `reach`: how far from the origin it is asked for. Divided by what keeps the gradient low, where the roots stay.
std::string as_isosurface(const Polynomial& p, double reach) {
  const std::string order = std::to_string(p.order), far = std::to_string(reach);
  return "isosurface { function { (" + p.function + ") / (1 + pow(x*x + y*y + z*z, " +
         std::to_string((p.order - 1) / 2.0) + ")) } max_gradient " + order +
         " accuracy 1e-5 max_trace 4 contained_by { box { -" + far + ", " + far + " } } ";
}

constexpr const char* kOutside = "location <2.2,2.6,-4> look_at <0,.1,0> angle 45";
constexpr const char* kPolynomialShapesWithin = "location <.1,.05,-.1> look_at <.3,.2,1> angle 100";

std::string stage(const std::string& camera) {
  return "#version 3.7; global_settings { assumed_gamma 1 }\ncamera { " + camera +
         " }\n"
         "light_source { <-4,7,-6>, 1 } light_source { <5,3,-2>, .3 } plane { y, -1.6 pigment { "
         "checker rgb .9 rgb .5 } }\n";
}

std::string clipped(const std::string& shape) {
  return stage(kOutside) + shape +
         "clipped_by { sphere { 0, 1.4 } } bounded_by { clipped_by } pigment { rgb <.9,.5,.3> }"
         " finish { specular .4 } }";
}

std::string polynomial_shapes_in_csg(const std::string& shape) {
  return stage(kOutside) + "difference { intersection { " + shape +
         "rotate <10,20,30> } box { -1.1, 1.1 } }"
         " sphere { <.6,.6,-.9>, .7 } pigment { rgb <.3,.7,.9> } }";
}

std::string within(const std::string& shape) {
  return stage(kPolynomialShapesWithin) + "light_source { <.1,.1,-.1>, .8 } " + shape +
         "clipped_by { box { -1.3, 1.3 } } bounded_by { clipped_by } pigment { rgb <.9,.8,.3> } }";
}

/// What stock makes of `reference` is what lentray makes of `scene`.
::testing::AssertionResult polynomial_shapes_same(const std::string& scene,
                                                  const std::string& reference,
                                                  std::uint32_t width) {
  const auto text = [width](const std::string& sdl) {
    return SceneText{
        .sdl = sdl, .width = width, .height = width * 3 / 4, .arguments = {}, .files = {}};
  };
  return reaches(lentray_render(text(scene)), stock_render(text(reference)), Grade::exact);
}

class ImagePolynomialShapes : public ::testing::TestWithParam<int> {
 protected:
  void expect_as_stock(int order, std::uint32_t width) const;
};
/// The same of all orders, in larger pictures.
class SlowPolynomialShapes : public ImagePolynomialShapes {};

/// Of order 6 stock's polynomial has specks (35 of 120 x 90 pixels), from order 9 on from within and from order 11 on from outside
/// more and more: up to 13 % of the pixels.
void ImagePolynomialShapes::expect_as_stock(int order, std::uint32_t width) const {
  const Polynomial p = polynomial(order);
  const std::string shape = as_poly(p), truth = as_isosurface(p, 1.5);
  EXPECT_TRUE(polynomial_shapes_same(clipped(shape),
                                     clipped(order == 6 || order > 8 ? truth : shape), width))
      << "clipped by a sphere";
  EXPECT_TRUE(polynomial_shapes_same(
      polynomial_shapes_in_csg(shape),
      polynomial_shapes_in_csg(order > 13 ? as_isosurface(p, 2.0) : shape), width))
      << "in CSG";
  EXPECT_TRUE(polynomial_shapes_same(within(shape), within(order > 8 ? truth : shape), width))
      << "from within";
}

// Stock takes minutes for high orders.
TEST_P(ImagePolynomialShapes, AsStock) { expect_as_stock(GetParam(), GetParam() > 5 ? 40 : 80); }
TEST_P(SlowPolynomialShapes, AsStock) { expect_as_stock(GetParam(), GetParam() > 12 ? 56 : 80); }

INSTANTIATE_TEST_SUITE_P(Order, ImagePolynomialShapes, ::testing::Values(2, 3, 4, 5, 6, 7, 9, 15));
INSTANTIATE_TEST_SUITE_P(Order, SlowPolynomialShapes, ::testing::Range(2, 16));

}  // namespace
}  // namespace lentray::test
