// A scene that is read and built once, and rendered any number of times: what programs share that
// make pictures. World space. docs/architecture.md, "How a program uses a session", has a whole
// program. Errors, each worded for the user: parser::ParseError, parser::Cancelled,
// parser::OptionError, camera::CameraError, core::NoRoom, and what a sink throws. A session is used
// by one thread at a time; deep scenes want a deep stack (core::run_on_deep_stack). Sessions do not
// know of each other.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/pass/pass_ledger.h"
#include "core/render/band_sink.h"
#include "core/render/picture_ledger.h"
#include "core/render/progress.h"
#include "core/scene/scene.h"
#include "core/trace/illumination.h"
#include "parser/compile/scene.h"
#include "parser/interpreter/parser.h"
#include "shadow/report.h"
#include "tools/session/camera_setup.h"
#include "tools/session/film.h"
#include "tools/session/photon_run.h"
#include "tools/session/radiosity_run.h"

namespace lentray::tool {

/// How a scene is read and built.
struct Reading {
  std::string scene;               ///< its file
  parser::ParserOptions parser{};  ///< with the size and the clock that the scene may ask for
  parser::BuildOptions build{};    ///< without `places`
  core::CompileOptions compile{};
  bool light_buffers = true;
  bool names_objects = false;  ///< cameras will name objects with their places: lens sheets do
  int threads = 0;             ///< that build; 0: all of the machine
};

/// A picture that can be rendered: its size is known and fits, and the scene is ready for it.
struct Plan {
  const CameraSetup& camera;
  const FilmSettings& film;
  core::FrameShape shape{};
  std::optional<core::PixelRegion> region{};  ///< empty: all pixels
  std::uint64_t pixels = 0;                   ///< that are rendered
  shadow::RunReport report{};                 ///< what is known of the run before it is rendered
};

/// Where a picture goes and who hears of it; null: nobody.
struct Outlets {
  core::BandSink& sink;
  core::Progress* progress = nullptr;
  core::PictureLedger* ledger = nullptr;  ///< to continue the picture later
  core::PassLedger* passes = nullptr;     ///< the same of the work before it
  const std::atomic<bool>* cancel = nullptr;
  RadiosityStore* radiosity = nullptr;  ///< that was read: where radiosity is kept
};

class Session {
 public:
  /// `disk` must outlive it. `connect` is shown the diagnostics before anything is read.
  Session(Reading reading, parser::Files& disk,
          const std::function<void(parser::Diagnostics&)>& connect = {});
  ~Session();

  /// Whether the scene of another picture would be the same: what it asked for is.
  bool serves(const parser::ParserOptions& other) const;
  /// What the scene asked for besides files.
  const parser::PictureReads& reads() const { return m_reads; }
  const core::Scene& scene() const { return *m_scene; }
  const std::vector<std::string>& not_rendered() const { return m_built.not_rendered; }

  /// Looks through the scene's own camera, or the default one.
  CameraSetup camera(const CameraOptions& options);
  CameraSetup another_view(const CameraSetup& first, const CameraOptions& options) const;
  /// First hits, for reports about a sheet. Lives as long as the session.
  camera::SceneProbe probe() const;
  /// The scene's camera statement, or null; fail_at_camera() throws ParseError there.
  const parser::CameraDesc* camera_statement() const;
  [[noreturn]] void fail_at_camera(const std::string& message);
  /// Lets the scene's text go, once there is a camera: what is said from then on has no places.
  void drop_text();

  /// Light buffers as fine as pays for such pictures, unless they are there. plan() does it too.
  void prepare(const camera::Camera& camera);
  /// `camera` and `film` must outlive the plan.
  Plan plan(const CameraSetup& camera, const FilmSettings& film);
  /// Whether work comes before pictures. It is done once for all that look at one lens sheet.
  bool has_passes() const;
  /// What the radiosity of such a picture depends on besides files and options, as lines of an identity.
  std::string radiosity_lines(const CameraSetup& camera) const;
  /// After a cancel the sink lacks bands, and the report says little.
  shadow::RunReport render(const Plan& plan, const Outlets& outlets);
  /// Of all pictures; null: the scene has none, or none yet.
  const PhotonRun* photons() const { return m_photons ? &*m_photons : nullptr; }
  /// Of the last picture; null: the scene has none.
  const RadiosityRun* radiosity() const { return m_radiosity ? &*m_radiosity : nullptr; }
  /// What pictures have told about numbers that the scene gives, as warnings with their headings.
  std::vector<std::string> advice() const;

 private:
  struct Text;  ///< the scene's text and what was said there
  void read();

  const Reading m_reading;
  parser::PictureReads m_reads;
  std::unique_ptr<Text> m_text;
  std::optional<parser::CameraRequest> m_camera;
  std::uint64_t m_rays_a_pixel = 1;  ///< at most, without antialiasing
  std::unique_ptr<core::Scene> m_scene;
  std::uint64_t m_prepared_rays = 0;  ///< that the light buffers were made for
  core::Illumination m_light;         ///< that passes have left
  std::optional<PhotonRun> m_photons;
  std::optional<RadiosityRun> m_radiosity;
  parser::BuildReport m_built;
  core::MemoryStages m_memory;                     ///< of reading and building
  double m_read_cpu_s = 0.0, m_build_cpu_s = 0.0;  ///< that no plan has yet
};

}  // namespace lentray::tool
