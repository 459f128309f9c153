// The shares of a blob's textures, where the elements are many enough for a search among them.
#include "core/material/blob_texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "core/pattern/surface_context.h"

namespace lentray::test {
namespace {

using namespace lentray::core;

TEST(UnitBlobTexture, SharesAreThoseOfAllElements) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 2.0), size(0.3, 0.9);
  std::vector<BlobTexture::Element> elements;
  for (int i = 0; i < 60; ++i) {
    BlobField field;
    field.radius = size(random);
    field.strength = i % 5 == 0 ? -0.5 : 1.0;
    field.length = i % 3 == 0 ? size(random) : 0.0;
    field.to_blob = Transform::rotation({place(random) * 90, place(random) * 90, 0})
                        .then(Transform::translation({place(random), place(random), 0}));
    elements.push_back({field, std::make_shared<LayeredTexture>(std::vector<TextureLayer>(1))});
  }
  const BlobTexture texture(elements, 0.01);
  int blended = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{place(random), place(random), place(random) * 0.5};
    WeightedTextures expected, found;
    const SurfaceContext surface{p, {0, 1, 0}, {0, 0, 1}, nullptr};
    double total = 0.0;
    const auto influence = [&](const BlobTexture::Element& e) {
      return std::fabs(e.field.at(e.field.to_blob.inverse_point(p)));
    };
    for (const auto& e : elements) total += influence(e);
    for (const auto& e : elements) {
      const double share = total == 0.0 ? 0.0 : influence(e) / total;
      if (share > 0.0 && share >= 0.01) e.texture->resolve(p, surface, share, expected);
    }
    if (total == 0.0) elements.front().texture->resolve(p, surface, 1.0, expected);
    texture.resolve(p, surface, 1.0, found);
    ASSERT_EQ(found.size(), expected.size()) << i;
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_EQ(found[k].texture, expected[k].texture) << i;
      ASSERT_EQ(found[k].weight, expected[k].weight) << i;
    }
    if (found.size() > 1) ++blended;
  }
  EXPECT_GT(blended, 100);
}

}  // namespace
}  // namespace lentray::test
