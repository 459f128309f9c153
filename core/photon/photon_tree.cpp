#include "core/photon/photon_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace lentray::core {
namespace {

constexpr double kFlattening = 16.0;
constexpr std::size_t kBucket = 12;   ///< so few photons are all looked at: cheaper than to choose
constexpr std::ptrdiff_t kAPair = 2;  ///< of two photons the first splits, wherever the other lies

/// The middle of begin .. end - 1; of an even number the first of two.
constexpr std::size_t middle(std::size_t begin, std::size_t end) { return (begin + end - 1) / 2; }

std::size_t widest_axis(const Photon* begin, const Photon* end) {
  std::array<float, 3> least = begin->place, most = begin->place;
  for (const Photon* photon = begin; photon != end; ++photon) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], photon->place[axis]);
      most[axis] = std::max(most[axis], photon->place[axis]);
    }
  }
  std::array<float, 3> extents;
  std::transform(most.begin(), most.end(), least.begin(), extents.begin(), std::minus<>());
  return static_cast<std::size_t>(std::max_element(extents.begin(), extents.end()) -
                                  extents.begin());
}

/// Quickselect with a median of three: changes the order of photons so that the wanted one parts lesser
/// coordinates from greater ones. In which order it leaves the others decides in part what stock's radius
/// is, so it moves the same photons as stock.
class Selection {
 public:
  explicit Selection(std::size_t axis) : m_axis(axis) {}

  void place(Photon* begin, Photon* end, const Photon* wanted) const {
    while (end - begin > kAPair) {
      Photon* const pivot = partition(begin, end);
      if (wanted < pivot) {
        end = pivot;
      } else if (pivot < wanted) {
        begin = pivot + 1;
      } else {
        return;
      }
    }
    // As in stock the greater of two comes first.
    if (end - begin == kAPair && !(at(begin[0]) > at(begin[1]))) std::swap(begin[0], begin[1]);
  }

 private:
  float at(const Photon& photon) const { return photon.place[m_axis]; }

  /// Moves the greatest of first, middle and last to the end, the least to the second place and the median
  /// to the first one.
  void order_three(Photon* begin, Photon* end) const {
    Photon *const second = begin + 1, *const last = end - 1;
    std::swap(begin[(last - begin) / 2], *second);
    Photon* greatest = at(*second) > at(*last) ? second : last;
    if (at(*begin) > at(*greatest)) greatest = begin;
    std::swap(*greatest, *last);
    if (at(*second) > at(*begin)) std::swap(*second, *begin);
  }
  /// More than a pair. Where the median of three came to lie: before it nothing is greater, behind it
  /// nothing less.
  Photon* partition(Photon* begin, Photon* end) const {
    order_three(begin, end);
    const float median = at(*begin);
    // Not seen yet: from `low` to before `high`.
    Photon *low = begin + 2, *high = end - 1;
    while (true) {
      while (low < high && at(*low) < median) ++low;
      while (low < high && at(high[-1]) > median) --high;
      if (high - low < 2) break;
      std::swap(*low++, *--high);
    }
    std::swap(*begin, low[-1]);
    return low - 1;
  }

  const std::size_t m_axis;
};

/// The nearest photons so far. A heap, the farthest first, once there are as many as are wanted.
class Nearest {
 public:
  Nearest(const PhotonSearch& search, std::vector<FoundPhotons::One>& list)
      : m_most(search.most), m_limit(search.radius * search.radius), m_list(list) {
    if (m_list.size() < m_most + kBucket) m_list.resize(m_most + kBucket);
  }
  double limit() const { return m_limit; }  ///< of the square of a distance that counts
  bool is_cut() const { return m_is_cut; }  ///< there were more than are wanted
  std::size_t size() const { return m_size; }
  /// Whether so many more are found in whatever order they are added.
  bool takes(std::size_t more) const { return m_is_cut || m_size + more <= m_most; }

  void add(double distance, std::uint32_t number) {
    if (m_size < m_most) {
      m_list[m_size++] = {distance, number};
      return;
    }
    if (!m_is_cut) {
      std::make_heap(m_list.data(), m_list.data() + m_most,
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
      m_is_cut = true;
    }
    replace_farthest({distance, number});
    m_limit = m_list.front().distance;
  }
  /// Of distances of photons with numbers from `first` on those that count. takes() them.
  void add_all(const double* distances, const double* gaps, std::size_t count, std::size_t first) {
    if (m_is_cut) {
      for (std::size_t i = 0; i < count; ++i) {
        if (distances[i] < m_limit && gaps[i] < m_limit)
          add(distances[i], static_cast<std::uint32_t>(first + i));
      }
      return;
    }
    FoundPhotons::One* const list = m_list.data();
    std::size_t size = m_size;
    for (std::size_t i = 0; i < count; ++i) {  // without a branch that nobody foresees
      list[size] = {distances[i], static_cast<std::uint32_t>(first + i)};
      size += (distances[i] < m_limit) & (gaps[i] < m_limit);
    }
    m_size = size;
  }

 private:
  void replace_farthest(const FoundPhotons::One& by) {
    FoundPhotons::One* const heap = m_list.data();
    std::size_t hole = 0;
    for (std::size_t child = 1; child < m_most; child = 2 * hole + 1) {
      if (child + 1 < m_most && heap[child + 1].distance > heap[child].distance) ++child;
      if (!(heap[child].distance > by.distance)) break;
      heap[hole] = heap[child];
      hole = child;
    }
    heap[hole] = by;
  }

  const std::size_t m_most;
  double m_limit;
  bool m_is_cut = false;
  std::size_t m_size = 0;
  std::vector<FoundPhotons::One>& m_list;
};

}  // namespace

PhotonTree::PhotonTree(std::vector<Photon> photons, Order order) : m_photons(std::move(photons)) {
  if (order == Order::kOfShooting) split(0, m_photons.size());
  for (Photon& photon : m_photons) photon.hidden_by = 0;
  note_hidden(0, m_photons.size());
}

void PhotonTree::split(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  Photon* const photons = m_photons.data();
  const std::size_t axis = widest_axis(photons + begin, photons + end);
  const std::size_t mid = middle(begin, end);
  if (static_cast<std::ptrdiff_t>(end - begin) > kAPair) {
    Selection(axis).place(photons + begin, photons + end, photons + mid);
  }
  photons[mid].axis = static_cast<std::uint8_t>(axis);
  split(begin, mid);
  split(mid + 1, end);
}

void PhotonTree::note_hidden(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  const std::size_t mid = middle(begin, end);
  if (end - begin <= kBucket) {
    const std::size_t axis = m_photons[mid].axis;
    const float plane = m_photons[mid].place[axis];
    for (std::size_t i = begin; i < end; ++i) {
      const float place = m_photons[i].place[axis];
      if (i < mid ? place > plane : place < plane) {
        m_photons[i].hidden_by = static_cast<std::int8_t>(mid - i);
      }
    }
  }
  note_hidden(begin, mid);
  note_hidden(mid + 1, end);
}

void PhotonTree::find(const PhotonSearch& search, FoundPhotons& found) const {
  search.normal ? find_in<true>(search, found) : find_in<false>(search, found);
}

template <bool kFlattened>
void PhotonTree::find_in(const PhotonSearch& search, FoundPhotons& found) const {
  struct Range {
    std::size_t begin, end;
    double gap;  ///< square of the distance to the plane that it lies behind
  };
  constexpr std::size_t kDeepest = 64;  ///< halvings of a number of photons
  std::array<Range, kDeepest> behind;
  std::size_t waiting = 0;
  const std::size_t bucket_size = search.one_by_one ? 0 : kBucket;
  const Vec3& point = search.point;
  const Vec3 normal = kFlattened ? *search.normal : Vec3();
  const auto way_to = [&point](const Photon& photon) {
    return Vec3(photon.place[0] - point.x, photon.place[1] - point.y, photon.place[2] - point.z);
  };
  const auto measured = [&normal](const Vec3& way) {
    const double distance = length_squared(way);
    if constexpr (!kFlattened) return distance;
    return distance + std::fabs(dot(normal, way)) * distance * kFlattening;
  };
  Nearest nearest(search, found.m_room);
  behind[waiting++] = {0, m_photons.size(), 0.0};
  while (waiting > 0) {
    Range range = behind[--waiting];
    if (!(range.gap < nearest.limit())) continue;
    while (range.begin < range.end) {
      if (range.end - range.begin <= bucket_size && nearest.takes(range.end - range.begin)) {
        const std::size_t count = range.end - range.begin;
        const Photon* const bucket = m_photons.data() + range.begin;
        std::array<double, kBucket> distances, gaps;
        for (std::size_t i = 0; i < count; ++i) {
          const Photon& hiding = bucket[static_cast<std::ptrdiff_t>(i) + bucket[i].hidden_by];
          const double aside = way_to(hiding)[hiding.axis];
          distances[i] = measured(way_to(bucket[i]));
          gaps[i] = aside * aside;
        }
        nearest.add_all(distances.data(), gaps.data(), count, range.begin);
        break;
      }
      const std::size_t mid = middle(range.begin, range.end);
      const Photon& photon = m_photons[mid];
      const Vec3 way = way_to(photon);
      const double aside = way[photon.axis];
      const double gap = aside * aside;
      if (gap <= nearest.limit()) {
        const double distance = measured(way);
        if (distance < nearest.limit()) nearest.add(distance, static_cast<std::uint32_t>(mid));
      }
      const Range before{range.begin, mid, gap}, after{mid + 1, range.end, gap};
      const bool is_before = aside > 0.0;
      behind[waiting] = is_before ? after : before;
      waiting += behind[waiting].begin < behind[waiting].end;
      range = is_before ? before : after;
    }
  }
  found.m_size = nearest.size();
  found.m_radius = nearest.is_cut() ? std::sqrt(nearest.limit()) : search.radius;
}

}  // namespace lentray::core
