// The light along the camera rays of neighbouring pixels, wave by wave: all camera rays, then all rays that go on from
// what they met, and so on; the light is summed up from the last wave to the first. The surfaces of a wave are lit
// together (core/trace/block_lights.h). World space; colours linear. One a thread; no allocation a ray once its
// buffers have grown.
// The bits are those of Integrator::trace_met(), which follows one ray after the other: who is in a wave changes none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/pixel.h"
#include "core/trace/block_lights.h"
#include "core/trace/first_hits.h"
#include "core/trace/integrator.h"
#include "core/trace/plain_lights.h"
#include "core/trace/ray_record.h"
#include "core/trace/surface_layers.h"

namespace lentray::core {

/// The sample that a camera ray belongs to.
struct SampleOfPixel {
  Pixel pixel;
  std::uint64_t key;  ///< core/trace/random_key.h
};

class RayWaves {
 public:
  static constexpr std::size_t kMost = FirstHits::kMost;

  /// The integrator works with the same context and tester.
  RayWaves(ThreadContext& context, Integrator& integrator, ShadowTester& shadows);
  /// False: the integrator alone is as quick, or has to follow the rays one by one; trace() must not be called.
  bool works() const { return m_works; }
  /// What these samples, 1 to kMost, see along their rays. `hits` has looked for what they meet first; null: nobody has.
  void trace(std::span<const Ray> rays, std::span<const SampleOfPixel> samples,
             const FirstHits* hits, std::span<Radiance> seen);

 private:
  /// A ray on the way.
  struct Node {
    const RayState* state;
    RayRecord record;
    std::uint32_t root;   ///< the camera ray's
    std::uint32_t first;  ///< node of the first that goes on from it, or kFollowed
    std::uint32_t depth;  ///< rays before it on the way
    bool is_cut;          ///< it sees nothing
    Radiance seen;
  };
  static constexpr std::uint32_t kFollowed = ~0u;  ///< the integrator follows them
  static constexpr std::size_t kMostNodes = 32 * kMost;

  void add(const RayState& state, std::size_t root, std::uint32_t depth) {
    Node& node = m_nodes[m_count++];
    node.state = &state;
    node.root = static_cast<std::uint32_t>(root);
    node.first = 0;
    node.depth = depth;
    node.is_cut = m_stepper.is_cut(state);
    node.seen = {};
  }
  /// Finds what the nodes [first, end) meet, at most kMost.
  void meet(std::size_t first, std::size_t end, const FirstHits* hits);
  void light(std::size_t first, std::size_t end);
  void place(std::size_t at, const RayState& state, const Hit& hit);
  /// Of a place that is shaded; none: the block cannot light them.
  Layers plain_layers(std::size_t at) const {
    return m_has_plain && m_found[at].is_plain ? m_found[at].of(m_layers) : Layers();
  }
  void shade(std::size_t first, std::size_t end);
  void add_onward(Node& node);
  void resolve();

  ThreadContext& m_context;
  Integrator& m_integrator;
  RayStepper& m_stepper;
  BlockLights m_lights;
  PlainLights m_plain;
  bool m_works, m_has_plain;
  std::span<const SampleOfPixel> m_samples;
  std::array<RayState, kMost> m_camera;
  std::unique_ptr<Node[]> m_nodes;  ///< kMostNodes of them, used again
  std::size_t m_count = 0;
  // Of the nodes that are shaded, in turn.
  std::array<Hit, kMost> m_own_hits;
  std::array<const Hit*, kMost> m_hits;  ///< null: nothing
  std::array<MetPlace, kMost> m_places;
  std::array<PlaceLayers, kMost> m_found;
  LayerBuffer m_layers;  ///< of all
};

}  // namespace lentray::core
