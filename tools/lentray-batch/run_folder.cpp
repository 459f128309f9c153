#include "tools/lentray-batch/run_folder.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/common/json_fields.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"

namespace lentray::batch {

namespace fs = std::filesystem;
using nlohmann::json;

static void json_members(auto& io, tool::Of<Work> auto& work) {
  io("name", work.item.name);
  io("band", work.item.band);
  io("bands", work.item.bands);
  io("first_row", work.item.first_row);
  io("last_row", work.item.last_row);
  io("seconds", work.item.seconds);
  io("source", work.scene.source);
  io("scene", work.scene.name);
  io("ini", work.scene.ini);
  io.given("frame", work.frame);
}

std::string name_of(const Item& item) {
  return item.bands > 1 ? item.name + "~" + std::to_string(item.band) : item.name;
}

void RunFolder::write(const std::vector<std::string>& words,
                      const std::vector<std::vector<Work>>& tasks) const {
  for (const char* folder : {"results", "scratch", "logs"}) fs::create_directories(m_path / folder);
  tool::write_whole(
      m_path / "command.json",
      tool::json_text({{"words", words}, {"folder", fs::current_path().string()}}, 1));
  std::string lines;
  for (const std::vector<Work>& task : tasks) {
    lines += tool::json_text(task) + "\n";
  }
  tool::write_whole(m_path / "tasks.jsonl", lines);
}

std::vector<std::string> RunFolder::words(fs::path& folder) const {
  const json all = tool::parse_json(tool::read_text(m_path / "command.json"));
  folder = all.at("folder").get<std::string>();
  return all.at("words").get<std::vector<std::string>>();
}

std::vector<Work> RunFolder::task(std::size_t number) const {
  std::ifstream file(m_path / "tasks.jsonl", std::ios::binary);
  std::string line;
  for (std::size_t i = 0; i <= number; ++i) {
    if (!std::getline(file, line))
      throw std::runtime_error("'" + m_path.string() + "' has no task " + std::to_string(number));
  }
  return tool::parse_json(line).get<std::vector<Work>>();
}

std::size_t RunFolder::tasks() const {
  std::ifstream file(m_path / "tasks.jsonl", std::ios::binary);
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);) ++count;
  return count;
}

std::map<std::string, Row> RunFolder::results() const {
  std::map<std::string, Row> out;
  std::error_code error;
  for (fs::directory_iterator at(m_path / "results", error), end; !error && at != end;
       at.increment(error)) {
    for (auto& [name, row] : rows_in(at->path())) out[name] = std::move(row);
  }
  return out;
}

}  // namespace lentray::batch
