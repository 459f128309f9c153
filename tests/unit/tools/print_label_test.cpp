// The label of a printed sheet: what is left of it where there is little room.
#include <gtest/gtest.h>

#include "tools/lentray-print/letters.h"
#include "tools/lentray-print/marks.h"

namespace lentray::print {
namespace {

const std::vector<LabelFact> kLabelFacts{{"name", 3}, {"pitch", 6}, {"dpi", 5}, {"lens", 1}};

TEST(UnitPrintLabel, LightFactsGoFirstWhereverTheyStand) {
  const Label all = label_within(kLabelFacts, 1000.0);
  EXPECT_EQ(all.text, "name  |  pitch  |  dpi  |  lens");
  const double height = all.height;
  const auto room_for = [&](const char* text) { return text_width(text, height) + 1e-6; };
  EXPECT_EQ(label_within(kLabelFacts, text_width(all.text, height) - 1e-6).text,
            "name  |  pitch  |  dpi");
  EXPECT_EQ(label_within(kLabelFacts, room_for("pitch  |  dpi")).text, "pitch  |  dpi");
}

/// Smaller letters, then one of them.
TEST(UnitPrintLabel, PitchAndResolutionGoLast) {
  const double height = label_within(kLabelFacts, 1000.0).height;
  const double both = text_width("pitch  |  dpi", height);
  const Label smaller = label_within(kLabelFacts, 0.8 * both);
  EXPECT_EQ(smaller.text, "pitch  |  dpi");
  EXPECT_NEAR(smaller.height, 0.8 * height, 1e-9);
  EXPECT_EQ(label_within(kLabelFacts, 0.45 * both).text, "pitch");
  EXPECT_EQ(label_within(kLabelFacts, 0.01 * both).text, "");
}

}  // namespace
}  // namespace lentray::print
