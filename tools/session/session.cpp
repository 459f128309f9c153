#include "tools/session/session.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "camera/scene_probe.h"
#include "core/accel/hierarchy.h"
#include "core/accel/light_buffer.h"
#include "core/base/formed.h"
#include "core/base/memory_stages.h"
#include "core/pass/pass_list.h"
#include "core/render/focal_blur.h"
#include "core/render/frame.h"
#include "parser/options/options.h"
#include "parser/read_scene.h"
#include "parser/source/build_error.h"
#include "parser/source/cancelled.h"
#include "shadow/pixel_orders.h"
#include "shadow/run_log.h"
#include "shadow/run_meter.h"
#include "shadow/tester_factory.h"
#include "tools/common/machine.h"
#include "tools/session/identity.h"
#include "tools/session/quality.h"
#include "tools/session/radiosity_lattice.h"

namespace lentray::tool {
namespace {

/// At most, and without antialiasing.
std::uint64_t rays_a_pixel(const parser::SceneDesc& scene) {
  if (!scene.camera || scene.camera->aperture == 0.0) return 1;
  return static_cast<std::uint64_t>(
      std::clamp(scene.camera->blur_samples, 1, core::FocalBlur::kMostRays));
}

/// Blur_Samples holds where the scene has focal blur.
void override_blur(const parser::SceneOverrides& overrides, parser::SceneDesc& scene) {
  if (!overrides.blur_samples || !scene.camera || scene.camera->blur_samples <= 0) return;
  scene.camera->blur_samples = scene.camera->blur_samples_min = *overrides.blur_samples;
}

/// Runs `work` with so many threads for what it divides among them.
template <typename Work>
void with_threads(int threads, Work work) {
  if (threads <= 0) return work();
  tbb::task_arena(std::min(threads, tbb::this_task_arena::max_concurrency())).execute(work);
}

std::uint64_t light_buffer_bytes(const core::Scene& scene) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < scene.lights().size(); ++i) {
    if (const core::LightBuffer* const buffer = scene.light_buffer(i)) bytes += buffer->memory();
  }
  return bytes;
}

/// One view of a sheet is an ordinary picture.
const camera::LensSheet* lenses_of(const CameraSetup& camera) {
  return camera.sheet && !camera.view ? &camera.sheet->sheet() : nullptr;
}

}  // namespace

struct Session::Text {
  explicit Text(parser::Files& disk) : sources(disk), diagnostics(sources) {}
  parser::SourceManager sources;
  parser::Diagnostics diagnostics;
  parser::SceneDesc description;  ///< without its objects
  parser::ObjectPlaces places;
};

Session::Session(Reading reading, parser::Files& disk,
                 const std::function<void(parser::Diagnostics&)>& connect)
    : m_reading(std::move(reading)), m_text(std::make_unique<Text>(disk)) {
  if (connect) connect(m_text->diagnostics);
  with_threads(m_reading.threads, [this] { read(); });
}

Session::~Session() = default;

void Session::read() {
  parser::SceneDesc& description = m_text->description;
  parser::Diagnostics& diagnostics = m_text->diagnostics;
  const auto stop_if_asked = [cancel = m_reading.parser.cancel] {
    if (cancel && cancel->load()) throw parser::Cancelled();
  };
  const double before = cpu_seconds();
  const std::uint64_t held_before = core::heap_bytes();
  std::uint64_t only_read = 0;
  core::begin_stage("the scene was read");
  description = parser::read_descriptions(m_reading.scene, m_text->sources, diagnostics,
                                          m_reading.parser, &m_reads, &only_read);
  m_memory = {{"tokens", only_read}, {"descriptions", core::heap_bytes_since(held_before)}};
  const double read = cpu_seconds();
  override_blur(m_reading.build.overrides, description);
  m_rays_a_pixel = rays_a_pixel(description);

  parser::BuildOptions build = m_reading.build;
  const bool has_sheet =
      description.camera && description.camera->kind == parser::CameraKind::kLenticular;
  build.places = m_reading.names_objects || has_sheet ? &m_text->places : nullptr;
  stop_if_asked();
  core::begin_stage("its objects were built");
  core::SceneParts parts = parser::build_scene(description, diagnostics, build, &m_built);
  reduce(parts, m_reading.build.quality);
  stop_if_asked();
  const std::uint64_t pictures = parts.picture_bytes, textures = m_built.texture_bytes;
  const std::uint64_t built = core::heap_bytes_since(held_before);
  m_memory.push_back({"pictures", pictures});
  m_memory.push_back({"textures", textures});
  m_memory.push_back({"objects", built - std::min(built, pictures + textures)});
  core::begin_stage("its hierarchy was built");
  m_scene = std::make_unique<core::Scene>(std::move(parts), m_reading.compile);
  m_memory.push_back({"hierarchy", m_scene->hierarchy().memory()});
  core::begin_stage("the picture was made");
  m_text->places.sort_parts();
  m_read_cpu_s = read - before;
  m_build_cpu_s = cpu_seconds() - read;
}

bool Session::serves(const parser::ParserOptions& other) const {
  const parser::ParserOptions& own = m_reading.parser;
  const auto clocks = [](const parser::FrameClock& f) {
    return std::tie(f.clock, f.clock_on, f.clock_delta, f.initial_clock, f.final_clock);
  };
  const auto frames = [](const parser::FrameClock& f) {
    return std::tie(f.frame_number, f.initial_frame, f.final_frame);
  };
  return (!m_reads.clock || clocks(own.frame) == clocks(other.frame)) &&
         (!m_reads.frames || frames(own.frame) == frames(other.frame)) &&
         (!m_reads.width || own.image_width == other.image_width) &&
         (!m_reads.height || own.image_height == other.image_height) &&
         (!m_reads.now || !other.now || m_reads.now == other.now);
}

CameraSetup Session::camera(const CameraOptions& options) {
  if (!m_camera) {
    const parser::SceneDesc& scene = m_text->description;
    const auto textures = parser::texture_settings(scene, m_scene->settings(), m_reading.build);
    try {
      m_camera = parser::camera_request(scene.camera.value_or(parser::CameraDesc{}), textures);
    } catch (const parser::BuildError& error) {  // of a bokeh or a normal
      m_text->diagnostics.fail(error.where(), error.what());
    }
  }
  return make_camera(*m_camera, options, probe());
}

CameraSetup Session::another_view(const CameraSetup& first, const CameraOptions& options) const {
  return tool::another_view(first, *m_camera, options);
}

camera::SceneProbe Session::probe() const {
  return camera::probe_of(
      *m_scene,
      [this](const camera::ProbeHit& hit) {
        const parser::ObjectPlace* const place =
            m_text ? m_text->places.place_of(hit.id, hit.whole) : nullptr;
        return place ? parser::object_name(*place, m_text->sources) : hit.object;
      },
      core::frame_threads({.threads = m_reading.threads}));
}

const parser::CameraDesc* Session::camera_statement() const {
  return m_text && m_text->description.camera ? &*m_text->description.camera : nullptr;
}

void Session::fail_at_camera(const std::string& message) {
  m_text->diagnostics.fail(m_text->description.camera->where, message);
}

void Session::drop_text() { m_text.reset(); }

void Session::prepare(const camera::Camera& camera) {
  if (!m_reading.light_buffers) return;
  const std::uint64_t rays = std::uint64_t{camera.width()} * camera.height() * m_rays_a_pixel;
  // Cells of half the size would spare little.
  if (m_prepared_rays > 0 && rays <= 2 * m_prepared_rays) return;
  m_prepared_rays = rays;
  const double before = cpu_seconds();
  with_threads(m_reading.threads, [&] { m_scene->build_light_buffers(rays); });
  m_build_cpu_s += cpu_seconds() - before;
}

Plan Session::plan(const CameraSetup& camera, const FilmSettings& film) {
  const std::uint32_t width = camera.camera().width(), height = camera.camera().height();
  parser::check_picture_size(width, height, bytes_a_row(film.antialiasing, width),
                             machine_memory());
  prepare(camera.camera());
  Plan plan{camera, film, frame_shape(film, width, height), region_of(film.part, width, height)};
  plan.pixels = std::uint64_t{width} * height;
  if (const auto& region = plan.region)
    plan.pixels = std::uint64_t{region->right - region->left} * (region->bottom - region->top);
  shadow::RunReport& report = plan.report;
  report.width = width;
  report.height = height;
  report.band_height = plan.shape.band_height;
  report.bands = (height + report.band_height - 1) / report.band_height;
  report.threads = static_cast<int>(core::frame_threads({.threads = film.threads}));
  report.tests_counted = film.count_tests;
  report.pixel_order = film.pixel_order;
  report.shadow_cache = film.shadow_cache;
  report.memory = m_memory;
  report.memory.push_back({"light_buffers", light_buffer_bytes(*m_scene)});
  const double film_bytes =
      core::bytes_a_band_row(film.antialiasing, width) * std::min(report.band_height, height);
  report.memory.push_back({"film", static_cast<std::uint64_t>(film_bytes)});
  report.parse_cpu_s = std::exchange(m_read_cpu_s, 0.0);
  report.compile_cpu_s = std::exchange(m_build_cpu_s, 0.0);
  return plan;
}

bool Session::has_passes() const {
  const core::SceneSettings& settings = m_scene->settings();
  return settings.radiosity || (settings.photons && !settings.loaded_photons);
}

std::string Session::radiosity_lines(const CameraSetup& camera) const {
  const parser::ParserOptions& own = m_reading.parser;
  std::string out;
  if (m_reads.clock) out += clock_line(own.frame);
  if (m_reads.frames) out += frame_number_line(own.frame);
  if (m_reads.width) out += core::formed("image_width %d\n", own.image_width);
  if (m_reads.height) out += core::formed("image_height %d\n", own.image_height);
  return out + identity_lines(lattice_of(camera), radiosity_eye(*m_camera));
}

shadow::RunReport Session::render(const Plan& plan, const Outlets& outlets) {
  const FilmSettings& film = plan.film;
  const camera::LensSheet* const lenses = lenses_of(plan.camera);
  auto testers = shadowless_tester(film.quality);
  if (!testers) testers = shadow::make_tester_factory(film.shadow_cache);
  const shadow::RunLog log(*testers);
  const core::ShadowTesterFactory* asked = testers.get();
  if (film.log_shadows) asked = &log;
  const shadow::RunMeter meter(*asked,
                               lenses ? static_cast<std::uint32_t>(lenses->lens().pixels) : 0);
  if (shadow::follows_shadows(film.pixel_order)) asked = &meter;

  core::FrameOptions frame;
  frame.threads = film.threads;
  frame.count_tests = film.count_tests;
  frame.alpha = film.alpha;
  frame.antialiasing = film.antialiasing;
  frame.angles = film.angles;
  frame.bundles = film.bundles;
  frame.region = plan.region;
  frame.ledger = outlets.ledger;
  frame.cancel = outlets.cancel;
  const camera::Camera& camera = plan.camera.camera();
  const core::FilmColumns columns = core::traced_columns(camera, plan.shape, frame);
  const auto orders =
      shadow::make_band_orders(film.pixel_order, {columns.left, columns.right}, lenses, &meter);

  shadow::RunReport report = plan.report;
  core::PassList passes;
  const core::SceneSettings& settings = m_scene->settings();
  if (settings.radiosity || settings.photons) frame.illumination = &m_light;
  const bool shoots = settings.photons && !m_photons;
  if (shoots) {
    m_photons.emplace(*m_scene, m_light);
    if (m_photons->pass()) passes.add(*m_photons->pass());
  }
  core::Pass* gathers = nullptr;
  if (settings.radiosity && (!m_radiosity || !m_radiosity->serves(plan.camera))) {
    m_radiosity.emplace(*m_scene, plan.camera, radiosity_eye(*m_camera), *testers, m_light,
                        film.most_radiosity_samples);
    gathers = m_radiosity->begin(outlets.radiosity);
    if (gathers) passes.add(*gathers);
  }
  if (!passes.run({.threads = core::frame_threads(frame),
                   .levels = m_scene->deepest(),
                   .cancel = outlets.cancel,
                   .progress = outlets.progress,
                   .film_work = static_cast<double>(plan.pixels),
                   .ledger = outlets.passes})) {
    m_radiosity.reset();  // half done
    if (shoots) m_photons.reset();
    return report;
  }
  report.passes = passes.reports();
  if (m_photons) report.memory.push_back({"photons", m_photons->bytes()});
  if (m_light.irradiance) report.memory.push_back({"radiosity", m_light.irradiance->bytes()});
  if (outlets.radiosity && gathers) m_radiosity->keep(*outlets.radiosity);
  const double before = cpu_seconds();
  report.counters = core::render_frame(*m_scene, camera, plan.shape, *orders, *asked, frame,
                                       outlets.sink, passes.film_progress());
  report.render_cpu_s = cpu_seconds() - before;
  report.shadow_log = log.lights();
  return report;
}

std::vector<std::string> Session::advice() const {
  std::vector<std::string> out;
  for (const parser::WatchedSlope& slope : m_built.slopes) {
    if (const std::string text = slope.watch->advice(); !text.empty())
      out.push_back(slope.heading + text);
  }
  return out;
}

}  // namespace lentray::tool
