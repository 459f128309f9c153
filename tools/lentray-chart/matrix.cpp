#include "tools/lentray-chart/matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "core/base/formed.h"
#include "shadow/pixel_orders.h"
#include "shadow/tester_factory.h"

namespace lentray::chart {
namespace {

/// For ids: letters, digits and - alone.
std::string id_of(std::string text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain) out += c;
    if (!plain && !out.empty() && out.back() != '-') out += '-';
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return out;
}

struct Sampling {
  int method, depth;
  double threshold;
  bool jitter;
};

class Matrix {
 public:
  explicit Matrix(const MatrixRequest& request) : m(request) {}

  std::vector<Setting> all() {
    m_out.push_back({"plain", "your own options", Kind::exact, {}, true});
    if (wants(Kind::lens_model)) lens_models();
    if (wants(Kind::antialiasing)) antialiasing();
    if (wants(Kind::area_light)) area_lights();
    if (wants(Kind::focal_blur)) focal_blur();
    if (wants(Kind::media)) media();
    if (wants(Kind::radiosity)) radiosity();
    if (wants(Kind::photons)) photons();
    if (wants(Kind::subsurface)) subsurface();
    if (wants(Kind::depth)) depth();
    if (wants(Kind::quality)) quality();
    if (wants(Kind::exact)) exact();
    return m_out;
  }

 private:
  /// Combined ones are crossed of single ones, which are measured for it.
  bool wants(Kind kind) const {
    const bool crossed = kind != Kind::exact && kind != Kind::lens_model;
    const auto named = [&](Kind k) { return std::ranges::find(m.only, k) != m.only.end(); };
    return m.only.empty() || named(kind) || (crossed && named(Kind::combined));
  }

  void add(Kind kind, const std::string& id, const std::string& label,
           std::vector<std::string> options) {
    m_out.push_back({id_of(id), label, kind, std::move(options)});
  }

  /// A setting of one number a value, but the user's own: N of Name=N.
  void sweep(Kind kind, const std::string& name, const std::string& id, const std::string& label,
             std::vector<double> values, std::optional<double> own = {}) {
    if (!m.abilities.has(name)) return;
    if (own) std::erase(values, *own);
    for (const double value : values) {
      const std::string text = number_text(value);
      add(kind, id + "-" + text, label + " " + text, {name + "=" + text});
    }
  }

  std::vector<double> some(std::vector<double> all, std::vector<double> quick) const {
    return m.quick ? std::move(quick) : std::move(all);
  }

  void lens_models() {
    if (!m.facts.is_sheet) return;
    for (const char* model : {"paraxial", "pinhole"}) {
      add(Kind::lens_model, std::string("lens-") + model, std::string("lens model ") + model,
          {std::string("Lens_Model=") + model});
    }
    if (!m.abilities.has("Lens_Rays")) return;
    for (const double rays : some({4, 16, 64}, {16})) {
      add(Kind::lens_model, "lens-thick-" + number_text(rays),
          "lens model thick, " + number_text(rays) + " rays a pixel",
          {"Lens_Model=thick", "Lens_Rays=" + number_text(rays)});
    }
  }

  std::vector<Sampling> samplings() const {
    if (m.quick) {
      return {{1, 3, 0.3, false}, {1, 3, 0.1, false}, {1, 5, 0.03, false},
              {2, 3, 0.1, false}, {2, 4, 0.0, false}, {1, 3, 0.1, true}};
    }
    std::vector<Sampling> out;
    for (const int depth : {2, 3, 4, 5, 9}) out.push_back({1, depth, 0.1, false});
    for (const int depth : {1, 2, 3, 4}) out.push_back({2, depth, 0.1, false});
    for (const int method : {1, 2}) {
      for (const double threshold : {0.3, 0.03, 0.0}) out.push_back({method, 3, threshold, false});
    }
    out.push_back({1, 9, 0.0, false});
    out.push_back({2, 4, 0.0, false});
    for (const int method : {1, 2}) {
      for (const double threshold : {0.3, 0.1, 0.03}) out.push_back({method, 3, threshold, true});
    }
    return out;
  }

  bool is_own(const Sampling& s) const {
    const parser::RenderOptions& o = m.own;
    return o.antialias && o.sampling_method == s.method && o.antialias_depth == s.depth &&
           o.antialias_threshold == s.threshold && (o.jitter && o.jitter_amount > 0.0) == s.jitter;
  }

  void antialiasing() {
    if (m.own.antialias) add(Kind::antialiasing, "aa-off", "no antialiasing", {"-A"});
    for (const Sampling& s : samplings()) {
      if (is_own(s)) continue;
      const std::string method = std::to_string(s.method), depth = std::to_string(s.depth),
                        threshold = number_text(s.threshold);
      add(Kind::antialiasing,
          "aa-method" + method + "-depth" + depth + "-threshold" + threshold +
              (s.jitter ? "-jitter" : ""),
          "antialiasing, method " + method + ", depth " + depth + ", threshold " + threshold +
              (s.jitter ? ", jitter" : ""),
          {"+A" + threshold, "+AM" + method, "+R" + depth, s.jitter ? "+J" : "-J"});
    }
    if (!m.abilities.has("Antialias_Grid")) return;
    for (const double depth : some({2, 3, 4, 8}, {2, 4})) {
      const std::string text = number_text(depth);
      add(Kind::antialiasing, "aa-grid" + text,
          "antialiasing, " + text + " x " + text + " samples in every pixel",
          {"Antialias_Grid=" + text});
    }
  }

  void area_lights() {
    if (!m.facts.area_lights) return;
    sweep(Kind::area_light, "Area_Light_Samples", "area-samples", "area light samples",
          some({2, 3, 4, 6, 8, 12, 16}, {2, 4, 8}));
    sweep(Kind::area_light, "Area_Light_Adaptive", "area-adaptive", "adaptive area lights,",
          some({0, 1, 2}, {0}));
    if (!m.abilities.has("Area_Light_Adaptive")) return;
    add(Kind::area_light, "area-adaptive-off", "area lights with all their samples",
        {"Area_Light_Adaptive=off"});
  }

  void focal_blur() {
    if (!m.facts.focal_blur) return;
    sweep(Kind::focal_blur, "Blur_Samples", "blur-samples", "blur samples",
          some({4, 7, 19, 37, 75, 150, 300}, {7, 37, 150}));
  }

  void media() {
    if (!m.facts.media || !m.abilities.has("Media_Method")) return;
    const auto one = [&](int method, int intervals, int samples) {
      const std::string k = std::to_string(method), i = std::to_string(intervals),
                        s = std::to_string(samples);
      add(Kind::media, "media-method" + k + "-intervals" + i + "-samples" + s,
          "media, method " + k + ", " + i + (intervals == 1 ? " interval, " : " intervals, ") + s +
              " samples",
          {"Media_Method=" + k, "Media_Intervals=" + i, "Media_Samples=" + s});
    };
    if (m.quick) {
      one(3, 1, 5);
      one(3, 1, 20);
      one(1, 10, 1);
      return;
    }
    for (const int samples : {2, 5, 10, 20, 50}) one(3, 1, samples);
    for (const int intervals : {3, 10, 30}) one(1, intervals, 1);
    for (const int intervals : {3, 10, 30}) one(2, intervals, 1);
  }

  void radiosity() {
    const SceneFacts& facts = m.facts;
    if (facts.radiosity_count == 0) return;
    const auto each = [&](const char* name, const char* words, double own,
                          const std::vector<double>& values) {
      sweep(Kind::radiosity, std::string("Radiosity_") + name, "radiosity-" + id_of(words),
            std::string("radiosity, ") + words, values, own);
    };
    each("Count", "count", facts.radiosity_count,
         some({10, 35, 100, 200, 400, 800, 1600}, {35, 200, 800}));
    each("Error_Bound", "error bound", facts.radiosity_error,
         some({2, 1, 0.5, 0.25, 0.12}, {1, 0.25}));
    each("Nearest_Count", "nearest count", 0, some({1, 4, 10, 20}, {10}));
    each("Recursion_Limit", "recursion limit", facts.radiosity_bounces, some({1, 2, 3, 5}, {1, 3}));
  }

  void photons() {
    const SceneFacts& facts = m.facts;
    if (facts.photon_gather == 0) return;
    sweep(Kind::photons, "Photon_Count", "photons-count", "photons, count",
          some({1e3, 1e4, 1e5, 1e6}, {1e3, 1e5}), facts.photon_count);
    sweep(Kind::photons, "Photon_Gather", "photons-gather", "photons, gathered",
          some({25, 50, 100, 200, 400}, {50, 200}), facts.photon_gather);
  }

  void subsurface() {
    if (m.facts.subsurface_samples == 0) return;
    sweep(Kind::subsurface, "Subsurface_Samples", "subsurface-samples", "subsurface light, samples",
          some({10, 20, 50, 100, 200, 400}, {20, 200}), m.facts.subsurface_samples);
  }

  void depth() {
    if (m.facts.depth <= 1) return;
    std::vector<double> levels;
    for (const double level : some({1, 2, 3, 4, 6, 10, 20}, {1, 2, 10})) {
      const bool is_own = static_cast<int>(level) == m.facts.max_trace_level;
      const bool matters = level < m.facts.depth || m.facts.depth >= m.facts.max_trace_level;
      if (!is_own && matters) levels.push_back(level);
    }
    sweep(Kind::depth, "Max_Trace_Level", "trace-level", "trace level", levels);
    sweep(Kind::depth, "Adc_Bailout", "adc-bailout", "adc bailout",
          some({0.1, 0.03, 0.01, 0.001}, {0.1, 0.01}));
  }

  void quality() {
    for (const int level : m.facts.quality_levels) {
      const std::string text = std::to_string(level);
      add(Kind::quality, "quality-" + text, "quality " + text, {"+Q" + text});
    }
  }

  void named(const char* option, const char* id, const char* label, const std::string& own,
             std::span<const std::string_view> names, const std::string& quick) {
    for (const std::string_view name : names) {
      const std::string text(name);
      if (parser::same_word(text, own) || (m.quick && text != quick)) continue;
      add(Kind::exact, std::string(id) + "-" + text, std::string(label) + " " + text,
          {std::string(option) + "=" + text});
    }
  }

  void exact() {
    named("Pixel_Order", "order", "pixel order", m.own.pixel_order, shadow::order_names(), "rows");
    named("Shadow_Cache", "cache", "shadow cache", m.own.shadow_cache, shadow::tester_names(),
          "off");
    constexpr std::size_t kLongList = 300;  ///< objects that may be tried one after another
    static constexpr std::array<std::string_view, 3> kAll{"bvh", "grid", "list"};
    const std::size_t count = m.facts.objects > kLongList ? 2 : 3;
    named("Accelerator", "accelerator", "accelerator", m.own.accelerator,
          std::span(kAll).first(count), "grid");
    const bool has_buffer = m.own.light_buffer;
    add(Kind::exact, has_buffer ? "light-buffer-off" : "light-buffer-on",
        has_buffer ? "without light buffers" : "with light buffers", {has_buffer ? "-UL" : "+UL"});
    if (!m.quick) add(Kind::exact, "band-height-16", "bands of 16 rows", {"Band_Height=16"});
    if (m.abilities.has("Specialised_Paths")) {
      add(Kind::exact, "paths-general", "without specialised paths", {"Specialised_Paths=Off"});
    }
    if (m.processors > 1 && m.own.threads == 1) {
      add(Kind::exact, "threads-2", "two threads", {"+WT2"});
    }
  }

  const MatrixRequest& m;
  std::vector<Setting> m_out;
};

/// The fastest, the least error, and the one in the middle of the front between them.
std::vector<const Point*> levels_of(const std::vector<Point>& points, Kind kind) {
  std::vector<const Point*> of_kind;
  for (const Point& p : points) {
    if (p.setting.kind == kind && p.is_known()) of_kind.push_back(&p);
  }
  std::ranges::stable_sort(of_kind, {}, [](const Point* p) { return p->seconds(); });
  std::vector<const Point*> front;
  for (const Point* p : of_kind) {
    if (front.empty() || p->error->rms < front.back()->error->rms) front.push_back(p);
  }
  if (front.size() <= 3) return front;
  return {front.front(), front[front.size() / 2], front.back()};
}

}  // namespace

std::string number_text(double value) {
  return core::formed(value == std::floor(value) ? "%.0f" : "%.6g", value);
}

std::vector<Setting> settings_of(const MatrixRequest& request) { return Matrix(request).all(); }

std::vector<Setting> combined_settings(const std::vector<Point>& points, bool quick) {
  std::vector<std::vector<const Point*>> kinds;
  for (const Kind kind : kKinds) {
    if (kind == Kind::lens_model || kind >= Kind::combined) continue;
    std::vector<const Point*> levels = levels_of(points, kind);
    if (levels.empty()) continue;
    levels.insert(levels.begin(), nullptr);  // as the user has it
    kinds.push_back(std::move(levels));
  }
  std::size_t count = 1;
  for (const auto& levels : kinds) count *= levels.size();
  std::vector<Setting> all;
  for (std::size_t i = 0; i < count; ++i) {
    Setting s{"both", "", Kind::combined, {}};
    int parts = 0;
    std::size_t rest = i;
    for (const auto& levels : kinds) {
      const Point* const level = levels[rest % levels.size()];
      rest /= levels.size();
      if (level == nullptr) continue;
      ++parts;
      s.id += "-" + level->setting.id;
      s.label += (s.label.empty() ? "" : "; ") + level->setting.label;
      s.options.insert(s.options.end(), level->setting.options.begin(),
                       level->setting.options.end());
    }
    if (parts > 1) all.push_back(std::move(s));
  }
  const std::size_t most = quick ? 4 : 24;
  if (all.size() <= most) return all;
  std::vector<Setting> out;
  for (std::size_t i = 0; i < most; ++i) out.push_back(all[(2 * i + 1) * all.size() / (2 * most)]);
  return out;
}

bool stock_has(const Setting& setting) {
  if (setting.is_plain || setting.kind == Kind::quality) return true;
  return setting.kind == Kind::antialiasing &&
         std::ranges::none_of(setting.options, [](const std::string& option) {
           return option.starts_with("Antialias_Grid=");
         });
}

}  // namespace lentray::chart
