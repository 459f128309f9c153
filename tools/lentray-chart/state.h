// What a chart keeps in DIR/.lentray-chart, so that a stopped one goes on: its points, its reference, and which files
// its scene read. One thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/common/own_folder.h"
#include "tools/lentray-chart/chart.h"
#include "tools/lentray-chart/facts.h"
#include "tools/session/seen.h"

namespace lentray::chart {

struct ChartState {
  std::string key{};     ///< program, scene and options: a chart of others begins anew
  std::string matrix{};  ///< which settings were asked for: crossed ones hold for these alone
  tool::Seen seen{};     ///< by its scene; absolute paths
  SceneFacts facts{};
  Chart chart{};
};

/// As JSON. What was written is read back equal, but for what derive() finds.
std::string text_of(const ChartState& state);
/// Throws std::runtime_error for text that is no such state.
ChartState state_of(const std::string& text);

/// Errors: std::runtime_error, worded for the user, where the folder cannot be made or written, and while another
/// chart is made there.
class ChartFolder : public tool::OwnFolder {
 public:
  explicit ChartFolder(const std::filesystem::path& out);

  const std::filesystem::path& out() const { return m_out; }
  std::filesystem::path own(const std::string& name) const { return path() / name; }
  /// A file of out(): "pictures/a.png". A state may be a stranger's: throws std::runtime_error for one elsewhere.
  std::filesystem::path file(const std::string& relative) const;

  /// Nothing: there is none. Throws std::runtime_error for one that is damaged.
  std::optional<ChartState> load() const;
  void save(const ChartState& state) const;
  void remove_pictures() const;

 private:
  std::filesystem::path m_out;
};

}  // namespace lentray::chart
