#include "tools/lentray-chart/probe.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/common/json_fields.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"
#include "tools/lentray-chart/errors.h"

namespace lentray::chart {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Small pictures of the scene, which show what an option changes.
class SmallPictures {
 public:
  explicit SmallPictures(const Session& session) : m_session(session) {
    constexpr unsigned kLongest = 96;  ///< pixels
    const SceneFacts& facts = session.state.facts;
    const unsigned longest = std::max({facts.width, facts.height, 1u});
    const unsigned part = (longest + kLongest - 1) / kLongest;
    m_size = {"+W" + std::to_string(std::max(8u, facts.width / part)),
              "+H" + std::to_string(std::max(8u, facts.height / part)), "-A"};
  }

  /// Nothing if it cannot be rendered.
  std::optional<core::StoredImage> picture(const std::vector<std::string>& options) const {
    std::vector<std::string> all = m_size;
    all.insert(all.end(), options.begin(), options.end());
    const std::string name = ".lentray-chart/probe.png";
    if (m_session.render(all, name).status != 0) return std::nullopt;
    return shown_picture(m_session.folder.file(name));
  }

  /// Of the picture before.
  json statistics() const {
    return tool::parse_json(tool::read_text(m_session.folder.own("statistics.json")));
  }

 private:
  const Session& m_session;
  std::vector<std::string> m_size;
};

bool same(const core::StoredImage& a, const core::StoredImage& b) {
  return error_of(a, b).largest == 0.0;
}

/// Levels whose picture no level above them has, from the user's own on.
std::vector<int> quality_levels(const SmallPictures& small, const core::StoredImage& own,
                                int own_level) {
  std::vector<core::StoredImage> seen{own};
  std::vector<int> levels;
  for (int level = std::min(own_level - 1, 8); level >= 0; --level) {
    auto picture = small.picture({"+Q" + std::to_string(level)});
    if (!picture) continue;
    const bool is_new =
        std::ranges::none_of(seen, [&](const core::StoredImage& s) { return same(s, *picture); });
    if (!is_new) continue;
    levels.push_back(level);
    seen.push_back(std::move(*picture));
  }
  return levels;
}

void look_at_pictures(Session& session) {
  SceneFacts& facts = session.state.facts;
  const SmallPictures small(session);
  const auto own = small.picture({});
  if (!own) return;  // the plain setting will say why
  const json statistics = small.statistics();
  if (statistics.contains("lens")) facts.lens_model = statistics.at("lens").value("model", "");
  const auto rays = [](const json& s) {
    return s.value("/rays/camera"_json_pointer, std::uint64_t{0});
  };
  if (session.request.abilities.has("Blur_Samples") && small.picture({"Blur_Samples=4"})) {
    facts.focal_blur = rays(small.statistics()) != rays(statistics);
  }
  if (wants(session.arguments, Kind::quality) || wants(session.arguments, Kind::combined)) {
    facts.quality_levels = quality_levels(small, *own, session.request.own.quality);
  }
}

}  // namespace

Abilities abilities_of(const Session& session) {
  const std::string program = session.arguments.lentray.string();
  const Outcome help = session.runner.run({program, "--help=all"});
  if (help.status != 0) throw std::runtime_error(reason_of(help, program));
  return Abilities(help.output);
}

void probe_scene(Session& session) {
  const fs::path dependencies = session.folder.own("read.json");
  const std::int64_t before = tool::now();
  const Outcome said = session.lentray({"--explain", "Dependencies_File=" + dependencies.string()});
  if (said.status != 0) {
    throw std::runtime_error("lentray cannot read the scene: " +
                             reason_of(said, session.arguments.lentray.string()));
  }
  session.state.seen =
      tool::seen_in(tool::parse_json(tool::read_text(dependencies)), fs::current_path(), before);
  session.state.facts = facts_of(said.output);
  session.state.facts.width = static_cast<unsigned>(session.request.own.width);
  session.state.facts.height = static_cast<unsigned>(session.request.own.height);
  look_at_pictures(session);
}

}  // namespace lentray::chart
