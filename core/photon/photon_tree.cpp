#include "core/photon/photon_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>

#include "core/base/processor.h"
#include "core/base/simd.h"

namespace lentray::core {
namespace {

constexpr double kFlattening = 16.0;
constexpr std::size_t kBucket = 12;  ///< so few photons are all looked at: cheaper than to choose
constexpr std::size_t kAtOnce = 4;   ///< a bucket holds whole lots of them
constexpr std::size_t kNoBox = std::size_t{1} << 63;  ///< of parts of buckets
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
/// coordinates from greater ones. In which order it leaves the others decides in part what the radius
/// of gathering is, so the steps of the selection are fixed.
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
    // The greater of two comes first.
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

/// The square of a distance, as a search measures it. `off_plane`: the way times the surface's normal.
template <bool kFlattened>
double flattened(double distance_squared, double off_plane) {
  if constexpr (!kFlattened) return distance_squared;
  return distance_squared + std::fabs(off_plane) * distance_squared * kFlattening;
}

Vec3 way_to(const Photon& photon, const Vec3& point) {
  return {photon.place[0] - point.x, photon.place[1] - point.y, photon.place[2] - point.z};
}

/// The square of the distance to the plane of a photon that splits.
double gap_to(const Photon& photon, const Vec3& point) {
  const double aside = way_to(photon, point)[photon.axis];
  return aside * aside;
}

/// Where photons are sought.
struct Around {
  Vec3 point, normal;
};
using Distances = std::array<double, kBucket>;

template <bool kFlattened>
double measured(const Photon& photon, const Around& from) {
  const Vec3 way = way_to(photon, from.point);
  return flattened<kFlattened>(length_squared(way), kFlattened ? dot(from.normal, way) : 0.0);
}

/// Measures `count` photons, one or more. Returns those that are nearer than `limit`: a bit each.
template <bool kFlattened>
unsigned measure_all(const Photon* photons, std::size_t count, const Around& from, double limit,
                     Distances& distances) {
  unsigned near = 0;
  for (std::size_t i = 0; i < count; ++i) {
    distances[i] = measured<kFlattened>(photons[i], from);
    near |= static_cast<unsigned>(distances[i] < limit) << i;
  }
  return near;
}

/// The same, four at a time.
template <bool kFlattened>
LENTRAY_AVX2 unsigned measure_all_avx2(const Photon* photons, std::size_t count, const Around& from,
                                       double limit, Distances& distances) {
  unsigned near = 0;
  for (std::size_t first = 0; first < count; first += kAtOnce) {
    // Behind the last photon stands the last one again.
    const auto at = [&](std::size_t i) {
      Float4 place_and_power;
      std::memcpy(&place_and_power, photons + std::min(first + i, count - 1),
                  sizeof(place_and_power));
      return place_and_power;
    };
    const Float4 a = at(0), b = at(1), c = at(2), d = at(3);
    const Float4 xy = simd::shuffled<0, 4, 1, 5>(a, b), xy2 = simd::shuffled<0, 4, 1, 5>(c, d);
    const Float4 z = simd::shuffled<2, 6, 2, 6>(a, b), z2 = simd::shuffled<2, 6, 2, 6>(c, d);
    const Double4 x =
        simd::widened(simd::shuffled<0, 1, 4, 5>(xy, xy2)) - simd::double4(from.point.x);
    const Double4 y =
        simd::widened(simd::shuffled<2, 3, 6, 7>(xy, xy2)) - simd::double4(from.point.y);
    const Double4 w =
        simd::widened(simd::shuffled<0, 1, 4, 5>(z, z2)) - simd::double4(from.point.z);
    Double4 distance = x * x + y * y + w * w;
    if constexpr (kFlattened) {
      const Double4 off_plane = simd::double4(from.normal.x) * x +
                                simd::double4(from.normal.y) * y + simd::double4(from.normal.z) * w;
      distance = distance + simd::abs(off_plane) * distance * simd::double4(kFlattening);
    }
    simd::store(distances.data() + first, distance);
    near |= simd::signs(distance < simd::double4(limit)) << first;
  }
  return near & ((1u << count) - 1u);
}

/// The nearest photons so far. A heap, the farthest first, once there are as many as are wanted.
class Nearest {
 public:
  Nearest(const PhotonSearch& search, std::vector<FoundPhotons::One>& list)
      : m_most(search.most), m_limit(search.radius * search.radius), m_list(list) {
    if (m_list.size() < m_most + 1) m_list.resize(m_most + 1);
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
    if (!m_is_cut) make_heap();
    replace_farthest({distance, number});
    m_limit = m_list.front().distance;
  }

 private:
  using One = FoundPhotons::One;

  [[gnu::noinline]] void make_heap() {
    std::make_heap(m_list.data(), m_list.data() + m_most,
                   [](const One& a, const One& b) { return a.distance < b.distance; });
    m_list[m_most] = {-1.0, 0};
    m_is_cut = true;
  }
  /// The hole that it leaves sinks to the end of the heap, and from there `by` rises: steps that a processor
  /// foresees. Behind the heap stands one that is nearer than all.
  void replace_farthest(const One& by) {
    One* const heap = m_list.data();
    std::size_t hole = 0;
    for (std::size_t child = 1; child < m_most; child = 2 * hole + 1) {
      child += order(heap[child + 1]) > order(heap[child]);
      heap[hole] = heap[child];
      hole = child;
    }
    while (hole > 0) {
      const std::size_t parent = (hole - 1) / 2;
      if (order(heap[parent]) > order(by)) break;
      heap[hole] = heap[parent];
      hole = parent;
    }
    heap[hole] = by;
  }
  /// Of numbers that are not below 0 the bits are in the order of the numbers, and are sooner compared.
  static std::int64_t order(const One& one) { return std::bit_cast<std::int64_t>(one.distance); }

  const std::size_t m_most;
  double m_limit;
  bool m_is_cut = false;
  std::size_t m_size = 0;
  std::vector<One>& m_list;
};

}  // namespace

PhotonTree::PhotonTree(std::vector<Photon> photons, Order order, bool portable)
    : m_photons(std::move(photons)), m_avx2(!portable && has_avx2()) {
  if (order == Order::kOfShooting) split(0, m_photons.size());
  for (Photon& photon : m_photons) photon.hidden_by = 0;
  if (!is_empty()) note(0, m_photons.size(), 0);
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

PhotonTree::Box PhotonTree::note(std::size_t begin, std::size_t end, std::size_t number) {
  const std::size_t mid = middle(begin, end);
  Box box{m_photons[mid].place, m_photons[mid].place};
  const auto include = [&box](const std::array<float, 3>& least, const std::array<float, 3>& most) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.least[axis] = std::min(box.least[axis], least[axis]);
      box.most[axis] = std::max(box.most[axis], most[axis]);
    }
  };
  if (m_boxes.size() <= number) m_boxes.resize(number + 1);
  if (end - begin > kBucket) {
    const Box before = note(begin, mid, 2 * number + 1), after = note(mid + 1, end, 2 * number + 2);
    include(before.least, before.most);
    include(after.least, after.most);
  } else {
    for (std::size_t i = begin; i < end; ++i) include(m_photons[i].place, m_photons[i].place);
    note_hidden(begin, end);
  }
  return m_boxes[number] = box;
}

void PhotonTree::note_hidden(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  const std::size_t mid = middle(begin, end);
  const std::size_t axis = m_photons[mid].axis;
  const float plane = m_photons[mid].place[axis];
  for (std::size_t i = begin; i < end; ++i) {
    const float place = m_photons[i].place[axis];
    if (i < mid ? place > plane : place < plane) {
      m_photons[i].hidden_by = static_cast<std::int8_t>(mid - i);
    }
  }
  note_hidden(begin, mid);
  note_hidden(mid + 1, end);
}

double PhotonTree::Box::gap(const Vec3& point) const {
  const auto aside = [](float low, float high, double at) {
    return std::max(std::max(low - at, at - high), 0.0);
  };
  return length_squared(Vec3(aside(least[0], most[0], point.x), aside(least[1], most[1], point.y),
                             aside(least[2], most[2], point.z)));
}

void PhotonTree::find(const PhotonSearch& search, FoundPhotons& found) const {
  search.normal ? find_in<true>(search, found) : find_in<false>(search, found);
}

template <bool kFlattened>
void PhotonTree::find_in(const PhotonSearch& search, FoundPhotons& found) const {
  struct Range {
    std::size_t begin, end;
    double gap;       ///< square of the distance to the plane that it lies behind
    std::size_t box;  ///< its number
  };
  constexpr std::size_t kDeepest = 64;  ///< halvings of a number of photons
  std::array<Range, kDeepest> behind;
  std::size_t waiting = 0;
  const std::size_t bucket_size = search.one_by_one ? 0 : kBucket;
  const Around from{search.point, kFlattened ? *search.normal : Vec3()};
  const auto measure = m_avx2 ? measure_all_avx2<kFlattened> : measure_all<kFlattened>;
  Nearest nearest(search, found.m_room);
  // Of what lies beyond none would be taken. On surfaces, which are flat, planes serve nearly as well.
  const auto is_beyond = [&](const Range& range) {
    if (kFlattened || range.box >= m_boxes.size()) return false;
    return !(m_boxes[range.box].gap(from.point) < nearest.limit());
  };
  behind[waiting++] = {0, m_photons.size(), 0.0, 0};
  while (waiting > 0) {
    Range range = behind[--waiting];
    if (!(range.gap < nearest.limit()) || is_beyond(range)) continue;
    while (range.begin < range.end) {
      const std::size_t count = range.end - range.begin;
      if (count <= bucket_size && nearest.takes(count)) {
        if (is_beyond(range)) break;
        const Photon* const bucket = m_photons.data() + range.begin;
        Distances distances;
        for (unsigned near = measure(bucket, count, from, nearest.limit(), distances); near != 0;
             near &= near - 1) {
          const auto i = static_cast<std::size_t>(std::countr_zero(near));
          const Photon& photon = bucket[i];
          if (!(distances[i] < nearest.limit())) continue;
          if (photon.hidden_by != 0 &&
              !(gap_to((&photon)[photon.hidden_by], from.point) < nearest.limit())) {
            continue;
          }
          nearest.add(distances[i], static_cast<std::uint32_t>(range.begin + i));
        }
        break;
      }
      const std::size_t mid = middle(range.begin, range.end);
      const Photon& photon = m_photons[mid];
      const double aside = way_to(photon, from.point)[photon.axis];
      const double gap = aside * aside;
      if (gap <= nearest.limit()) {
        const double distance = measured<kFlattened>(photon, from);
        if (distance < nearest.limit()) nearest.add(distance, static_cast<std::uint32_t>(mid));
      }
      const std::size_t box = count > kBucket ? 2 * range.box + 1 : kNoBox;
      const Range before{range.begin, mid, gap, box}, after{mid + 1, range.end, gap, box + 1};
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
