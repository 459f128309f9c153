#include "tests/fuzz/journal_input.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "parser/options/options.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/memory_files.h"
#include "tests/fuzz/sealed_file.h"
#include "tools/session/pass_file.h"
#include "tools/session/picture_journal.h"
#include "tools/session/radiosity_store.h"
#include "tools/session/session.h"

namespace lentray::test {
namespace {

constexpr std::uint32_t kWidth = 12, kHeight = 9;
constexpr std::chrono::milliseconds kAtOnce{0};

/// seeds.py has the same.
constexpr const char* kPlain =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { location <0, 1, -4> look_at 0 } light_source { <3, 5, -4>, 1 }\n"
    "plane { y, -1 pigment { checker rgb 1 rgb 0 } } sphere { 0, 1 pigment { rgb x } }\n";
constexpr const char* kPassing =
    "#version 3.7; global_settings { assumed_gamma 1 photons { spacing 0.3 media 0 }\n"
    "radiosity { count 8 error_bound 1 recursion_limit 2 } }\n"
    "camera { location <0, 1, -4> look_at 0 } light_source { <3, 5, -4>, 1 }\n"
    "plane { y, -1 pigment { rgb 1 } } sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 }\n"
    "photons { target refraction on reflection on } }\n";

/// The picture as a file's integers, which is what becomes of any float.
class Picture final : public core::BandSink {
 public:
  void put(const core::Image& band, std::uint32_t) override {
    for (const float value : band.rgba) m_sum += core::quantised(value, {});
  }

 private:
  std::uint64_t m_sum = 0;
};

class SmallRun {
 public:
  explicit SmallRun(const char* scene) {
    m_files.add("scene.pov", scene);
    tool::Reading reading;
    reading.scene = "scene.pov";
    reading.threads = 1;
    m_session.emplace(reading, m_files, [](parser::Diagnostics& diagnostics) {
      for (std::size_t i = 0; i < parser::kStreams; ++i)
        diagnostics.connect(static_cast<parser::Stream>(i), {});
    });
    tool::CameraOptions look;
    look.width = kWidth;
    look.height = kHeight;
    m_camera.emplace(m_session->camera(look));
  }
  void render(core::AntialiasingMethod method, core::PictureLedger* ledger,
              core::PassLedger* passes, tool::RadiosityStore* store) {
    tool::FilmSettings film;
    film.threads = 1;
    film.antialiasing.method = method;
    Picture picture;
    m_session->render(m_session->plan(*m_camera, film),
                      {.sink = picture, .ledger = ledger, .passes = passes, .radiosity = store});
  }

 private:
  const MemoryFiles::Library m_library;
  MemoryFiles m_files{m_library};
  std::optional<tool::Session> m_session;
  std::optional<tool::CameraSetup> m_camera;
};

void continue_picture(const InputFile& file) {
  static SmallRun run(kPlain);
  const std::string picture = file.begin() + ".png";
  const auto earlier = tool::PictureJournal::earlier(picture);
  if (!earlier) return;
  using enum core::AntialiasingMethod;
  for (const auto method : {kPlain, kCentres, kCorners, kSpread, kGrid}) {
    tool::PictureJournal journal(picture, kWidth, kHeight, earlier->identity, kAtOnce);
    journal.go_on();
    run.render(method, &journal, nullptr, nullptr);
    journal.keep();
  }
  tool::PictureJournal given(picture, kWidth, kHeight, earlier->identity, kAtOnce);
  given.go_on();
  given.give();
}

void continue_passes(const InputFile& file, const tool::Identity& identity) {
  tool::PassFile passes(file.begin() + ".png", identity, kAtOnce);
  passes.go_on();
  SmallRun(kPassing).render(core::AntialiasingMethod::kPlain, nullptr, &passes, nullptr);
}

void use_light(const InputFile& file, const tool::Identity& identity) {
  parser::RenderOptions options;
  options.radiosity_file = file.path();
  options.radiosity_from_file = true;
  tool::RadiosityStore store(options, identity);
  store.read();
  SmallRun(kPassing).render(core::AntialiasingMethod::kPlain, nullptr, nullptr, &store);
}

const char* end_of_name(OwnFile kind) {
  switch (kind) {
    case OwnFile::journal: return ".png.lentray-state";
    case OwnFile::passes: return ".png.lentray-passes.part";
    case OwnFile::light: return ".lentray-light";
    default: return ".rca";
  }
}

void use_own_file(const std::string& bytes) {
  const OwnFile kind = own_file(bytes);
  const InputFile file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                       end_of_name(kind));
  if (kind == OwnFile::journal) return continue_picture(file);
  const tool::Identity identity = tool::Identity::of_text(identity_text(bytes));
  if (kind == OwnFile::passes) return continue_passes(file, identity);
  use_light(file, identity);
}

}  // namespace

std::string use_journal(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    use_own_file(sealed(bytes));
  } catch (const parser::OptionError& error) {
    return error.what();
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

}  // namespace lentray::test
