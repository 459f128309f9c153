#include "core/pass/radiosity_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/memory_limit.h"
#include "core/irradiance/pretrace.h"
#include "core/pass/gather_threads.h"
#include "core/scene/scene.h"
#include "core/trace/random_key.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

namespace {

constexpr double kBytesASample = 1500.0;  ///< with its places in the grids of its store

double most_samples(const RadiosityPassSetup& setup) {
  if (setup.most_samples > 0) return static_cast<double>(setup.most_samples);
  return memory_limit() / kBytesASample;
}

std::string too_many(double most, bool was_asked) {
  return "radiosity makes more samples than " +
         (was_asked ? "Radiosity_Samples=" : std::string("the memory holds, some ")) +
         std::to_string(static_cast<std::uint64_t>(most)) +
         "; a larger error_bound, minimum_reuse or pretrace_end makes fewer";
}

}  // namespace

class RadiosityPass::Levels {
 public:
  /// `light`: what earlier passes left.
  Levels(const RadiosityPassSetup& setup, const Illumination& light, IrradianceCache& cache,
         RadiosityReport& report, PassRun& run)
      : m_setup(setup), m_cache(cache), m_report(report), m_run(run),
        m_threads(setup.scene, light, setup.shadows, run), m_context(setup.scene, false, &light),
        m_shadows(setup.shadows.make(m_context)),
        m_blocks(pretrace_blocks(setup.width, setup.height)), m_most_samples(most_samples(setup)) {}

  void run() {
    const auto levels = pretrace_levels(m_cache.settings(), m_setup.width, m_setup.height);
    for (const PretraceLevel& level : levels) m_all += places_of(level.spacing);
    const double last = m_setup.sees_every_pixel ? 1.0 : last_spacing();
    m_all += places_of(last);
    begin(false);
    for (const PretraceLevel& level : levels) {
      look_ahead(level, m_cache.settings().nearest_count_adaptive);
    }
    begin(true);
    m_counted.clear();
    m_report.sees_pixels = m_setup.sees_every_pixel;
    if (m_setup.sees_every_pixel) {
      see_pixels();
    } else {
      m_blocks = pretrace_blocks(m_setup.width, m_setup.height);
      look_ahead({static_cast<int>(levels.size()), last, last}, 0);
    }
    m_threads.count_rays();
  }

 private:
  double places_of(double spacing) const {
    return static_cast<double>(m_setup.width) * m_setup.height / (spacing * spacing);
  }
  void advance(std::size_t places) {
    check_samples();
    m_done += static_cast<double>(places);
    m_run.advance(std::min(1.0, m_done / m_all));
  }
  void check_samples() const {
    std::uint64_t count = 0;
    for (int depth = 0; depth < m_cache.depths(); ++depth)
      count += m_cache.store(depth).samples().size();
    if (static_cast<double>(count) > m_most_samples)
      throw NoRoom(too_many(m_most_samples, m_setup.most_samples > 0));
  }
  /// Of places instead of pixels.
  double last_spacing() const {
    constexpr double kPlaces = 250'000.0;
    return std::max(
        1.0, std::ceil(std::sqrt(static_cast<double>(m_setup.width) * m_setup.height / kPlaces)));
  }
  /// `enough`: see goes_on().
  void look_ahead(const PretraceLevel& level, int enough) {
    RadiosityReport::Level done;
    for (PretraceBlock& block : m_blocks) {
      JitterRun jitter(m_jitter, level, block);
      std::vector<PretracePart> wanted;
      std::size_t places = 0;
      for (const PretracePart& part : block.parts) {
        const PartFindings found = look_at(pretrace_places(level, block, part, jitter));
        places += found.places;
        if (goes_on(found, enough)) wanted.push_back(part);
      }
      end_level(block, level, wanted, enough);
      done.places += places;
      advance(places);
    }
    report(std::move(done));
  }
  PartFindings look_at(const std::vector<PretracePlace>& places) {
    const GatherCounts before = m_light->counts()[0];
    trace(places);
    for (std::size_t i = 0; i < places.size(); ++i) ask(i);
    GatherCounts done = m_light->counts()[0];
    done -= before;
    return {places.size(), done.queries, done.found};
  }
  void see_pixels() {
    m_cache.begin_sights(m_setup.width, m_setup.height);
    RadiosityReport::Level done;
    for (const PixelBlock& block : pixel_blocks(m_setup.width, m_setup.height)) {
      std::vector<PretracePlace> centres;
      for (std::uint32_t row = block.top; row < block.bottom; ++row) {
        for (std::uint32_t column = block.left; column < block.right; ++column) {
          centres.push_back({column + 0.5, row + 0.5});
        }
      }
      trace(centres);
      for (std::size_t i = 0; i < centres.size(); ++i) {
        const std::size_t samples = m_cache.store(0).samples().size();
        ask(i);
        m_cache.see(m_rays[i].pixel, samples, m_light->take_gathered());
        m_cache.answer(m_light->answered());
      }
      done.places += centres.size();
      advance(centres.size());
    }
    report(std::move(done));
  }
  /// Camera rays, on all threads.
  void trace(const std::vector<PretracePlace>& places) {
    m_rays.clear();
    for (const PretracePlace& place : places) {
      PassRay ray;
      ray.shows = m_setup.camera.ray(place.column, place.row, ray.ray);
      ray.pixel = {static_cast<std::uint32_t>(std::max(0.0, place.column)),
                   static_cast<std::uint32_t>(std::max(0.0, place.row))};
      m_rays.push_back(ray);
    }
    m_records.resize(std::max(m_records.size(), m_rays.size()));
    m_threads.look(m_rays, m_light->lookup(), {m_records.data(), m_rays.size()});
  }
  /// What one of them asked, in order.
  void ask(std::size_t ray) {
    m_run.check_cancelled();
    const Pixel pixel = m_rays[ray].pixel;
    m_light->begin(pixel, true,
                   sample_key(static_cast<std::int32_t>(pixel.column),
                              static_cast<std::int32_t>(pixel.row), 0));
    if (!m_rays[ray].shows) return;
    for (const RecordedQuery& asked : m_records[ray].queries) m_light->at(asked);
  }
  /// Levels begin, and with them the directions.
  void begin(bool is_last) {
    m_light = std::make_unique<RadiosityLight>(m_context, *m_shadows, m_cache, is_last, m_threads);
    m_context.indirect = m_light.get();
  }
  void report(RadiosityReport::Level done) {
    done.depths = m_light->counts();
    m_counted.resize(done.depths.size());
    for (std::size_t i = 0; i < m_counted.size(); ++i) {
      const GatherCounts all = done.depths[i];
      done.depths[i] -= m_counted[i];
      m_counted[i] = all;
    }
    m_report.levels.push_back(std::move(done));
  }

  const RadiosityPassSetup& m_setup;
  IrradianceCache& m_cache;
  RadiosityReport& m_report;
  PassRun& m_run;
  GatherThreads m_threads;
  ThreadContext m_context;
  const std::unique_ptr<ShadowTester> m_shadows;
  std::unique_ptr<RadiosityLight> m_light;
  std::vector<PassRay> m_rays;  ///< camera rays on the way
  std::vector<GatherRecord> m_records;
  std::vector<PretraceBlock> m_blocks;
  std::vector<GatherCounts> m_counted;  ///< by depth, before this level
  const JitterCycle m_jitter;
  const double m_most_samples;
  double m_all = 0.0, m_done = 0.0;  ///< places
};

/// A guess: one place in ten gathers.
double RadiosityPass::work() const {
  const RadiositySettings& settings = *m_setup.scene.settings().radiosity;
  return 0.1 * m_setup.width * m_setup.height * settings.count;
}

void RadiosityPass::run(PassRun& run) {
  auto cache = std::make_shared<IrradianceCache>(*m_setup.scene.settings().radiosity, m_setup.eye);
  for (const DepthSample& known : m_known) {
    if (known.depth < cache->depths()) cache->store(known.depth).add(known.sample);
  }
  Levels(m_setup, m_result, *cache, m_report, run).run();
  run.count("bytes", static_cast<double>(cache->bytes()));
  m_result.irradiance = std::move(cache);
}

}  // namespace lentray::core
