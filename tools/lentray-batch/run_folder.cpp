#include "tools/lentray-batch/run_folder.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/common/json_text.h"
#include "tools/common/process.h"

namespace lentray::batch {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json to_json(const Work& work) {
  const Item& i = work.item;
  json out{{"name", i.name},
           {"band", i.band},
           {"bands", i.bands},
           {"first_row", i.first_row},
           {"last_row", i.last_row},
           {"seconds", i.seconds},
           {"source", work.scene.source.string()},
           {"scene", work.scene.name},
           {"ini", work.scene.ini.string()}};
  if (work.frame) out["frame"] = *work.frame;
  return out;
}

Work work_of(const json& from) {
  Work work;
  from.at("name").get_to(work.item.name);
  from.at("band").get_to(work.item.band);
  from.at("bands").get_to(work.item.bands);
  from.at("first_row").get_to(work.item.first_row);
  from.at("last_row").get_to(work.item.last_row);
  from.at("seconds").get_to(work.item.seconds);
  work.scene.source = from.at("source").get<std::string>();
  from.at("scene").get_to(work.scene.name);
  work.scene.ini = from.at("ini").get<std::string>();
  if (from.contains("frame")) work.frame = from.at("frame").get<int>();
  return work;
}

}  // namespace

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
    json list = json::array();
    for (const Work& work : task) list.push_back(to_json(work));
    lines += tool::json_text(list) + "\n";
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
  std::vector<Work> out;
  for (const json& work : tool::parse_json(line)) out.push_back(work_of(work));
  return out;
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
    std::ifstream file(at->path(), std::ios::binary);
    for (std::string line; std::getline(file, line);) {
      const json parsed = tool::json_if_any(line);
      if (parsed.is_discarded()) continue;  // being written
      try {
        Row row = row_of(parsed);
        out[row.name] = std::move(row);
      } catch (const std::invalid_argument&) {
      }
    }
  }
  return out;
}

}  // namespace lentray::batch
