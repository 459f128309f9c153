#include "tools/lentray-chart/page_labels.h"

#include <algorithm>

namespace lentray::chart {
namespace {

constexpr double kReach = 6.0;  ///< half a symbol

struct Box {
  double left, top, right, bottom;
  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// From a point to the middle of its label, in widths and heights. Below the front, to the left, there are no points.
struct Direction {
  double across, down;
};
constexpr Direction kDirections[] = {{-0.5, 0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, -0.5},
                                     {0.0, 0.5},  {0.0, -0.5}, {0.5, 0.0}, {-0.5, 0.0}};

Box box_at(const LabelWish& wish, const Direction& direction, double gap) {
  const double width = label_width(wish.text);
  const auto side = [](double part) { return part > 0.0 ? 1.0 : part < 0.0 ? -1.0 : 0.0; };
  const double x = wish.at.x + direction.across * width + side(direction.across) * gap;
  const double y = wish.at.y + direction.down * kLabelHeight + side(direction.down) * gap;
  return {x - width / 2, y - kLabelHeight / 2, x + width / 2, y + kLabelHeight / 2};
}

}  // namespace

double label_width(const std::string& text) {
  constexpr double kLetter = 6.6;  // of 11 pixels' text, as wide fonts have it
  return kLetter * static_cast<double>(text.size());
}

std::vector<PlacedLabel> placed_labels(const std::vector<LabelWish>& wishes,
                                       const std::vector<Spot>& spots, const LabelArea& area,
                                       std::size_t most) {
  std::vector<LabelWish> order = wishes;
  std::stable_sort(order.begin(), order.end(), [](const LabelWish& a, const LabelWish& b) {
    return a.is_first && !b.is_first;
  });
  std::vector<Box> taken;
  for (const Spot& spot : spots) {
    taken.push_back({spot.x - kReach, spot.y - kReach, spot.x + kReach, spot.y + kReach});
  }
  const auto is_clear = [&](const Box& box) {
    return box.left >= area.left + 2 && box.right <= area.right && box.top >= area.top &&
           box.bottom <= area.bottom - 2 &&
           std::none_of(taken.begin(), taken.end(), [&](const Box& b) { return b.meets(box); });
  };
  std::vector<PlacedLabel> out;
  for (const LabelWish& wish : order) {
    if (out.size() == most) break;
    const auto place = [&] {
      for (const double gap : {kReach, 2.0 * kReach, 4.0 * kReach}) {
        for (const Direction& direction : kDirections) {
          const Box box = box_at(wish, direction, gap);
          if (!is_clear(box)) continue;
          out.push_back({wish.text, box.left, (box.top + box.bottom) / 2});
          taken.push_back(box);
          return;
        }
      }
    };
    place();
  }
  return out;
}

}  // namespace lentray::chart
