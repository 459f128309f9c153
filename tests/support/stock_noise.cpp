#include "tests/support/stock_noise.h"

namespace lentray::test {

::testing::AssertionResult within_stocks_noise(const SceneText& scene) {
  const auto stock = [&](const std::vector<std::string>& more) {
    SceneText one = scene;
    one.arguments.insert(one.arguments.end(), more.begin(), more.end());
    return stock_render(one);
  };
  const StoredImage reference = stock({"+WT1"});
  const std::vector<StoredImage> others{stock({"+WT1", "+BS8"}), stock({"+WT1", "+BS256"}),
                                        stock({"+WT2"})};
  core::LensComparison result;
  result.whole =
      core::compare(lentray_render(scene), reference, core::Columns::all(reference.width));
  core::grade_by_noise(result, reference, others);
  const core::Comparison& c = result.whole;
  return (c.grade >= Grade::noise ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
         << "blocks " << c.blocks.rms << ", S " << c.noise->rms << "; bias " << c.blocks.bias
         << ", S " << c.noise->bias;
}

}  // namespace lentray::test
