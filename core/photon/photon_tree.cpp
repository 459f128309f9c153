#include "core/photon/photon_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace lentray::core {
namespace {

constexpr double kFlattening = 16.0;
constexpr std::size_t kBucket = 12;  ///< so few photons are all looked at: cheaper than to choose
constexpr std::size_t kAPair = 2;    ///< of two photons the first splits, wherever the other lies

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
  std::size_t widest = 0;
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}}) {
    if (most[axis] - least[axis] > most[widest] - least[widest]) widest = axis;
  }
  return widest;
}

/// Quickselect (Hoare) with the median of three as Sedgewick has it: changes the order of photons so that the one
/// at `wanted` parts lesser coordinates from greater ones. Which of the others come first depends on each
/// step, and stock's radius depends on that: its steps are these.
class Selection {
 public:
  Selection(Photon* photons, std::size_t axis) : m_photons(photons), m_axis(axis) {}

  void place(std::size_t first, std::size_t last, std::size_t wanted) {
    while (first < last) {
      const std::size_t pivot = partition(first, last);
      if (wanted == pivot) return;
      if (wanted < pivot) {
        last = pivot - 1;
      } else {
        first = pivot + 1;
      }
    }
  }

 private:
  float at(std::size_t i) const { return m_photons[i].place[m_axis]; }
  void swap(std::size_t i, std::size_t j) { std::swap(m_photons[i], m_photons[j]); }
  void swap_if_greater(std::size_t i, std::size_t j) {
    if (at(i) > at(j)) swap(i, j);
  }
  /// Where the median of three came to lie between those that are no greater and those that are no less.
  std::size_t partition(std::size_t first, std::size_t last) {
    const std::size_t second = first + 1;
    swap((first + last) / 2, second);
    swap_if_greater(second, last);
    swap_if_greater(first, last);
    swap_if_greater(second, first);
    const float pivot = at(first);
    std::size_t up = second, down = last;
    while (up <= down) {
      do ++up;
      while (up <= last && at(up) < pivot);
      do --down;
      while (at(down) > pivot);  // ends at the pivot
      if (up < down) swap(up, down);
    }
    swap(first, down);
    return down;
  }

  Photon* const m_photons;
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
  if (end - begin > kAPair) Selection(photons, axis).place(begin, end - 1, mid);
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
