// The light that reaches a surface from other surfaces: put together from samples nearby, or gathered by
// rays of its own where there are too few. World space; colours linear. One a thread.
//
// In a picture the samples are given and stay as they are; what is gathered there serves its own place
// alone. A pass makes them: what it gathers becomes a sample.
// Source: reference manual 3.7, "Radiosity"; the rules are those that replay stock's pictures
// (tests/image/radiosity_test.cpp).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/irradiance/irradiance_cache.h"
#include "core/trace/gather_record.h"
#include "core/trace/gather_sum.h"
#include "core/trace/indirect_light.h"
#include "core/trace/integrator.h"
#include "core/trace/query_recorder.h"
#include "core/trace/shadow_tester.h"

namespace lentray::core {

struct ThreadContext;

/// Traces rays before it is known what indirect light their surfaces get.
class GatherTeam {
 public:
  virtual ~GatherTeam() = default;
  /// As many records as rays; the random numbers of each ray are those of its key. `asked`: for samples
  /// that serve what surfaces ask; null: they want no indirect light.
  virtual void trace(std::span<const GatherRay> rays, const SampleLookup* asked,
                     std::span<GatherRecord> records) = 0;
  /// What an earlier run kept of the next gather of the first depth; false: nothing.
  virtual bool recall([[maybe_unused]] std::string& record) { return false; }
  /// Keeps one for a later run. Only when all have been recalled.
  virtual void keep([[maybe_unused]] std::string_view record) {}
};

/// Traces the rays of gathers, under radiosity's own rules.
Integrator make_gatherer(ThreadContext& context, ShadowTester& shadows);

class RadiosityLight final : public IndirectLight {
 public:
  /// For a picture.
  RadiosityLight(ThreadContext& context, ShadowTester& shadows, const IrradianceCache& cache);
  /// For a pass, which makes the samples. `is_last`: they are looked for as the picture does.
  RadiosityLight(ThreadContext& context, ShadowTester& shadows, IrradianceCache& cache,
                 bool is_last, GatherTeam& team);
  ~RadiosityLight() override;

  void begin(Pixel pixel, bool is_centre, std::uint64_t key) override;
  bool is_wanted() const override { return m_depth < m_cache.depths(); }
  IndirectAnswer at(const IndirectQuery& query) override { return answer(query, {}); }
  /// The same of a query that was noted.
  IndirectAnswer at(const RecordedQuery& asked) { return answer(asked.query, asked.early); }
  /// For what camera rays ask.
  const SampleLookup& lookup() const { return m_depths.front().lookup; }

  /// By depth, since it was made.
  const std::vector<GatherCounts>& counts() const { return m_counts; }
  /// What was gathered for the first depth since the last beginning of a ray.
  std::vector<GatheredLight> take_gathered() { return std::move(m_gathered); }
  /// What was answered to the first depth since then.
  std::span<const KnownAnswer> answered() const { return m_answered; }

 private:
  RadiosityLight(ThreadContext& context, ShadowTester& shadows, const IrradianceCache& cache,
                 IrradianceCache* growing, bool is_last, GatherTeam* team);
  /// What the pass answered to that query of the pixel's centre; null: it did not.
  const KnownAnswer* known_answer(const IndirectQuery& query);
  IndirectAnswer answer(const IndirectQuery& query, const EarlyReuse& early);
  IndirectAnswer found_out(const IndirectQuery& query, const EarlyReuse& early);
  /// The next of what was gathered for the pixel.
  const GatheredLight& next_gathered();
  /// Samples nearby, and whether that will do.
  Reuse reuse(const IndirectQuery& query, const EarlyReuse& early);
  bool is_enough(const Reuse& found) const;
  GatheredLight gathered_for(const IndirectQuery& query, const Vec3& normal);
  GatheredLight gather_or_recall(const IndirectQuery& query, const Vec3& normal);
  GatheredLight gather(const IndirectQuery& query, const Vec3& normal);
  unsigned aim(const IndirectQuery& query, const Vec3& normal);
  void shoot();
  GatherSum sum_up();
  bool keep(const Vec3& point, const Vec3& normal, const GatherSum& sum);

  ThreadContext& m_context;
  const IrradianceCache& m_cache;
  IrradianceCache* const m_growing;  ///< null: what is gathered is not kept
  const RadiositySettings& m_settings;
  const bool m_is_last;
  Integrator m_rays;         ///< that gather
  GatherTeam* const m_team;  ///< null: this thread traces all
  struct Depth {
    DepthRules rules;
    DirectionCycle cycle;
    SampleLookup lookup;
    std::vector<GatherRay> rays{};  ///< of the gather on the way
    std::vector<GatherRecord> records{};
    std::vector<double> qualities{};
  };
  Depth& here() { return m_depths[static_cast<std::size_t>(m_depth)]; }
  std::vector<Depth> m_depths;
  std::vector<GatherCounts> m_counts;
  int m_depth = 0;              ///< gathers on the way
  double m_quality = 1.0;       ///< the least of the samples that the ray used
  float m_importance = 1.0f;    ///< of what the last gather's ray met
  bool m_has_gathered = false;  ///< since the ray on the way began
  PixelSight m_sight;           ///< of the pixel
  std::size_t m_answers = 0;    ///< that it had of m_sight's gathered ones
  std::size_t m_known = 0;      ///< of its answers
  std::uint64_t m_key = 0;
  std::uint64_t m_gathers = 0;  ///< since the ray began
  std::vector<GatheredLight> m_gathered;
  std::vector<KnownAnswer> m_answered;
};

}  // namespace lentray::core
