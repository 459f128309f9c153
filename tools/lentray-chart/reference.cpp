#include "tools/lentray-chart/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace lentray::chart {
namespace {

/// Puts a step together of the ladders of its kinds.
class Ladder {
 public:
  Ladder(const MatrixRequest& request, int step, bool of_lens_models)
      : m(request), m_step(step), m_of_lens_models(of_lens_models) {}

  std::optional<ReferenceStep> step() {
    antialiasing();
    if (m.facts.area_lights) area_lights();
    if (m.facts.focal_blur) samples("Blur_Samples", "blur samples", 64.0, 2.0, 32768, 2.0);
    media();
    radiosity();
    photons();
    if (m.facts.subsurface_samples > 0) {
      samples("Subsurface_Samples", "samples of subsurface light", 100.0, kRoot, 20'000, kRoot);
    }
    lens();
    depth();
    m_out.options.emplace_back("+Q9");
    if (m_step > 0 && !m_grows) return std::nullopt;
    return m_out;
  }

 private:
  static constexpr double kRoot = std::numbers::sqrt2;

  void say(const std::string& text) { m_out.what += (m_out.what.empty() ? "" : "; ") + text; }

  void antialiasing() {
    static constexpr std::array kEvery{3, 4, 6, 8, 11, 16, 23, 32, 45, 64};
    // All samples of a picture share their points of the lens, so more of them are no better than
    // more points; and each ray has a place of its own in the pixel.
    static constexpr std::array kBlurred{3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    static constexpr std::array kRefined{3, 5, 7, 9};
    const bool every = m.abilities.has("Antialias_Grid");
    const std::span<const int> depths = !every               ? std::span<const int>(kRefined)
                                        : m.facts.focal_blur ? std::span<const int>(kBlurred)
                                                             : std::span<const int>(kEvery);
    const int last = static_cast<int>(depths.size()) - 1;
    const auto depth_at = [&](int step) {
      return depths[static_cast<std::size_t>(std::clamp(step, 0, last))];
    };
    const std::string depth = std::to_string(depth_at(m_step));
    m_out.options = every ? std::vector<std::string>{"Antialias_Grid=" + depth}
                          : std::vector<std::string>{"+A0", "+AM1", "+R" + depth, "-J"};
    say(depth + " x " + depth + " samples a pixel");
    grow(m_step <= last, std::pow(double(depth_at(m_step)) / depth_at(m_step - 1), 2.0));
  }

  void grow(bool grows, double work) {
    if (m_step == 0 || !grows) return;
    m_grows = true;
    m_out.work *= work;
  }

  /// From `first` on, times `factor` a step, which is `work` times the rays; up to `most`.
  void samples(const char* option, const char* label, double first, double factor, int most,
               double work) {
    if (!m.abilities.has(option)) return;
    const auto at = [&](int step) {
      return std::min(std::round(first * std::pow(factor, step)), double(most));
    };
    const std::string number = number_text(at(m_step));
    m_out.options.push_back(std::string(option) + "=" + number);
    say(number + " " + label);
    grow(at(m_step) > at(m_step - 1), work);
  }

  void area_lights() {
    samples("Area_Light_Samples", "samples of area lights each way", 4.0, kRoot, 1000, 2.0);
    if (m.abilities.has("Area_Light_Adaptive")) {
      m_out.options.emplace_back("Area_Light_Adaptive=off");
    }
  }

  void media() {
    if (!m.facts.media || !m.abilities.has("Media_Method")) return;
    m_out.options.insert(m_out.options.end(), {"Media_Method=3", "Media_Intervals=4"});
    samples("Media_Samples", "media samples in 4 intervals", 20.0, kRoot, 5000, kRoot);
  }

  /// Samples that lie closer, with more rays each and one bounce more.
  void radiosity() {
    if (m.facts.radiosity_count == 0 || !m.abilities.has("Radiosity_Count")) return;
    samples("Radiosity_Count", "rays of a sample of radiosity", 200.0, 2.0, 1600, 2.0);
    constexpr int kMostSteps = 6;  ///< an error bound of 0.03
    const int bounces = std::min(m.facts.radiosity_bounces + 1 + m_step, 20);
    const std::string error =
        number_text(0.25 * std::pow(1.0 / kRoot, std::min(m_step, kMostSteps)));
    m_out.options.insert(m_out.options.end(),
                         {"Radiosity_Error_Bound=" + error, "Radiosity_Nearest_Count=10",
                          "Radiosity_Recursion_Limit=" + std::to_string(bounces)});
    say("error bound " + error + ", " + std::to_string(bounces) + " bounces");
    grow(m_step <= kMostSteps, 2.0);
  }

  /// More photons, of which more are gathered in less space.
  void photons() {
    if (m.facts.photon_gather == 0) return;
    samples("Photon_Count", "photons", 200'000.0, 2.0, 1'000'000'000, 2.0);
    samples("Photon_Gather", "of them gathered", 200.0, kRoot, 10'000, kRoot);
  }

  void lens() {
    if (!m.facts.is_sheet) return;
    const bool has_thick = m.abilities.has("Lens_Rays");
    if (m_of_lens_models) {
      m_out.options.emplace_back(has_thick ? "Lens_Model=thick" : "Lens_Model=pinhole");
      say(has_thick ? "lens model thick" : "lens model pinhole");
    }
    if (has_thick && (m_of_lens_models || m.facts.lens_model == "thick")) {
      samples("Lens_Rays", "rays behind a lens", 32.0, 2.0, 1024, 2.0);
    }
  }

  void depth() {
    if (m.facts.depth <= 1) return;
    const auto at = [&](int step) {
      return std::min(256.0, m.facts.max_trace_level * std::pow(2.0, step + 1));
    };
    if (m.abilities.has("Max_Trace_Level")) {
      m_out.options.push_back("Max_Trace_Level=" + number_text(at(m_step)));
      say("trace level " + number_text(at(m_step)));
      grow(at(m_step) > at(m_step - 1), 1.2);
    }
    if (m.abilities.has("Adc_Bailout")) {
      const std::string bailout = number_text(0.001 * std::pow(0.5, m_step));
      m_out.options.push_back("Adc_Bailout=" + bailout);
      say("adc bailout " + bailout);
    }
  }

  const MatrixRequest& m;
  const int m_step;
  const bool m_of_lens_models;
  bool m_grows = false;
  ReferenceStep m_out;
};

}  // namespace

std::optional<ReferenceStep> reference_step(const MatrixRequest& request, int step,
                                            bool of_lens_models) {
  return Ladder(request, step, of_lens_models).step();
}

bool is_converged(double change, double smallest) {
  return 10.0 * change <= std::max(smallest, kSmallestError);
}

}  // namespace lentray::chart
