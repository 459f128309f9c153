#include "tools/lentray/stock_form.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <string_view>

#include "core/base/formed.h"
#include "parser/base/shown.h"
#include "tools/common/version.h"
#include "tools/lentray/run.h"
#include "tools/session/stock_radiosity.h"

namespace lentray::tool {
namespace {

using parser::RenderOptions;
using parser::Stream;

constexpr std::size_t kWidth = 76;  ///< of rules and titles

/// What belongs to no stream goes to the console alone, and always.
void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// "==== [Parsing...] ======", which is as wide as a rule.
std::string title(const std::string& what) {
  std::string text = "==== [" + what + "...] ";
  text.resize(std::max(kWidth, text.size()), '=');
  return text + "\n";
}

std::string rule() {
  std::string text(kWidth, '-');
  return text.append(1, '\n');
}

parser::Heading stock_heading(const parser::SourceManager& sources, const parser::Location& where,
                              std::string_view severity) {
  const std::string kind = severity == "error" ? "Parse Error: " : "Parse Warning: ";
  if (where.file == 0) return {kind, ""};
  const parser::Position at = sources.position(where);
  return {"File '" + parser::shown_name(sources.name(where.file)) + "' line " +
              std::to_string(at.line) + ": " + kind,
          // POV-Ray breaks long messages, and goes on with a blank: readers expect such a line.
          " in column " + std::to_string(at.column) + "\n"};
}

const char* on_off(bool on) { return on ? "On" : "Off"; }

struct TypeName {
  core::FileType type;
  const char* name;
};
constexpr TypeName kTypes[] = {
    {core::FileType::png, "PNG"},     {core::FileType::tiff, "TIFF"},
    {core::FileType::exr, "EXR"},     {core::FileType::targa, "Targa"},
    {core::FileType::ppm, "PPM"},     {core::FileType::compressed_targa, "RLE Targa"},
    {core::FileType::jpeg, "JPEG"},   {core::FileType::bmp, "BMP"},
    {core::FileType::radiance, "HDR"}};

std::string output_line(const RenderOptions& o, const std::string& output) {
  if (output.empty()) return "  Output file: Disabled\n";
  RenderOptions asked = o;
  core::FileType type = o.type;
  parser::output_path(asked, type);
  const auto* row = std::find_if(std::begin(kTypes), std::end(kTypes),
                                 [&](const TypeName& one) { return one.type == type; });
  const bool deep = o.bits > 8 && (type == core::FileType::png || type == core::FileType::ppm);
  const std::string depth = o.grayscale
                                ? std::string("grayscale")
                                : core::formed("%d bpp%s", (o.alpha ? 4 : 3) * (deep ? 16 : 8),
                                               o.alpha ? " with alpha" : "");
  return "  Output file.........." + (output == "-" ? "stdout" : output) + ", " + depth + " " +
         row->name + "\n";
}

/// Seconds in words, behind a label; then who took them.
std::string time_lines(const char* label, double seconds, int threads, double cpu_seconds) {
  const auto whole = static_cast<long>(seconds);
  return core::formed("  %-16s%3ld hours %2ld minutes %2ld seconds (%.3f seconds)\n", label,
                      whole / 3600, whole / 60 % 60, whole % 60, seconds) +
         core::formed("              using %d thread(s) with %.3f CPU-seconds total\n", threads,
                      cpu_seconds);
}

std::string count_line(const char* label, std::uint64_t count) {
  return count == 0 ? ""
                    : core::formed("%-17s%18llu\n", label, static_cast<unsigned long long>(count));
}

/// Several lines over each other on a terminal, as POV-Ray's: all but the last end in CR alone.
class PixelLines final : public core::Progress {
 public:
  explicit PixelLines(std::uint64_t pixels) : m_pixels(pixels) {}
  ~PixelLines() override {
    if (m_said > 0) std::fputs("\n", stderr);
  }
  /// Pixels differ in what they cost: so many cost as much as what is done.
  void advance(double fraction_done, double /*seconds_left*/) override {
    const std::lock_guard lock(m_mutex);
    const auto done = static_cast<std::uint64_t>(
        std::floor(std::min(fraction_done, 1.0) * static_cast<double>(m_pixels)));
    if (done <= m_said) return;
    m_said = done;
    std::fprintf(stderr, "Rendered %llu of %llu pixels (%llu%%)\r",
                 static_cast<unsigned long long>(done), static_cast<unsigned long long>(m_pixels),
                 static_cast<unsigned long long>(done * 100 / m_pixels));
    std::fflush(stderr);
  }

 private:
  const std::uint64_t m_pixels;
  std::mutex m_mutex;
  std::uint64_t m_said = 0;
};

}  // namespace

std::string stock_title() {
  return core::formed(
      "POV-Ray %s compatible: Lentray %s\n\nThis is not POV-Ray, but a renderer that "
      "reads its scenes and options.\n",
      kPovRayVersion, kVersion);
}

std::string stock_option_problem(const std::string& program,
                                 const std::vector<std::string>& arguments) {
  std::string text = "\nProblem with option setting\n" + parser::shown_name(program);
  for (const std::string& argument : arguments) text += " " + parser::shown_name(argument);
  return text + "\n";
}

std::string StockForm::warning(const std::string& text) const {
  return std::string(m_rendering ? "Render" : "Parse") + " Warning: " + text;
}

std::string StockForm::error(const std::string& text) const {
  return std::string(m_rendering ? "Render" : "Parse") + " Error: " + text;
}

parser::HeadingMaker StockForm::headings() const { return stock_heading; }

void StockForm::begin_run() { say(stock_title() + "\n"); }

void StockForm::begin_frame(const RenderOptions&, const parser::FrameClock&, std::size_t number,
                            std::size_t count) {
  say(core::formed("\nRendering frame %zu of %zu\n", number, count));
}

void StockForm::begin_reading(const RenderOptions& o, const parser::FrameClock& clock,
                              const std::string& output) {
  m_rendering = false;
  std::string text = "Parser Options\n  Input file: " + o.input + "\n";
  text += core::formed("  Clock value: %8.3f  (Animation %s)\n", clock.clock,
                       clock.clock_on ? "on" : "off");
  text += "Image Output Options\n";
  text += core::formed("  Image resolution.....%lld by %lld", static_cast<long long>(o.width),
                       static_cast<long long>(o.height));
  const bool is_part = o.start_row || o.end_row || o.start_column || o.end_column;
  if (!is_part) {
    text += core::formed(" (rows 1 to %lld, columns 1 to %lld)", static_cast<long long>(o.height),
                         static_cast<long long>(o.width));
  }
  text += ".\n" + output_line(o, output);
  text += core::formed("  Continued trace......%s\n", on_off(o.continues));
  texts().write(Stream::kRender, text);
  say(title("Parsing"));
}

void StockForm::begin_rendering(const RenderOptions& o, const shadow::RunReport& report,
                                std::uint64_t pixels) {
  texts().write(Stream::kStatistics,
                rule() + "Parser Time\n" +
                    time_lines("Parse Time:", report.parse_cpu_s, 1, report.parse_cpu_s) +
                    time_lines("Bounding Time:", report.compile_cpu_s, 1, report.compile_cpu_s) +
                    rule());
  std::string text = core::formed("Render Options\n  Quality:  %d\n", o.quality);
  text += core::formed("  Antialiasing.........%s", on_off(o.antialias));
  if (o.antialias) {
    text += core::formed("  (Method %d, Threshold %.3f, Depth %d, Jitter %.2f, Gamma %.2f)",
                         o.sampling_method, o.antialias_threshold, o.antialias_depth,
                         o.jitter ? o.jitter_amount : 0.0, o.antialias_gamma);
  }
  texts().write(Stream::kRender, text + "\n");
  say(title("Rendering"));
  m_rendering = true;
  m_pixels = pixels;
  m_start = std::chrono::steady_clock::now();
}

std::unique_ptr<core::Progress> StockForm::progress() const {
  return std::make_unique<PixelLines>(m_pixels);
}

std::string StockForm::radiosity(const RadiosityRun& run) const {
  return stock_radiosity_text(run.report());
}

void StockForm::end_picture(const RenderOptions&, const shadow::RunReport& report,
                            const std::string&) {
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
  const core::Counters& c = report.counters;
  core::ShadowCounts shadow;
  for (const core::ShadowCounts& light : c.lights) shadow.add(light);
  const std::uint64_t samples = c.camera_rays > m_pixels ? c.camera_rays - m_pixels : 0;
  const bool is_part = m_pixels < std::uint64_t{report.width} * report.height;
  std::string text = rule() + "Render Statistics";
  text += is_part ? " (Partial Image Rendered)\n" : "\n";
  text += core::formed("Image Resolution %u x %u\n", report.width, report.height) + rule();
  text += core::formed(
      "Pixels:   %15llu   Samples: %15llu   Smpls/Pxl: %.2f\n",
      static_cast<unsigned long long>(m_pixels), static_cast<unsigned long long>(samples),
      static_cast<double>(samples) / static_cast<double>(std::max<std::uint64_t>(m_pixels, 1)));
  text +=
      core::formed("Rays:     %15llu\n", static_cast<unsigned long long>(
                                             c.camera_rays + c.reflected_rays + c.refracted_rays)) +
      rule();
  text += count_line("Shadow Rays:", shadow.rays) + count_line("Shadowed Rays:", shadow.blocked) +
          count_line("Reflected Rays:", c.reflected_rays) +
          count_line("Refracted Rays:", c.refracted_rays) + rule();
  text +=
      core::formed("Peak Memory:      %14.0f MB\n", static_cast<double>(report.peak_bytes) * 1e-6);
  text +=
      "Render Time:\n" + time_lines("Trace Time:", seconds, report.threads, report.render_cpu_s);
  texts().write(Stream::kStatistics, text);
  m_rendering = false;
}

void StockForm::keep_picture(const std::string&) {
  texts().write(Stream::kRender, "File already rendered and continue requested; skipping.\n");
}

void StockForm::end_run(int status) {
  switch (status) {
    case kDone: return say("POV-Ray finished\n\n");
    case kAborted: return say("Render cancelled by user\n\n");
    default:
      return say(std::string("Fatal error in ") +
                 (m_rendering ? "renderer: The picture is not whole.\n"
                              : "parser: Cannot parse input.\n") +
                 "Render failed\n\n");
  }
}

}  // namespace lentray::tool
