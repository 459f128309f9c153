#include "tools/lentray-batch/estimate.h"

#include <algorithm>
#include <deque>
#include <nlohmann/json.hpp>

#include "core/render/film.h"
#include "tools/session/requests.h"
#include "tools/common/json_text.h"
#include "tools/common/process.h"
#include "tools/common/shell_words.h"

namespace lentray::batch {

using nlohmann::json;

namespace {

constexpr double kCoarse = 8.0;  ///< times fewer columns and rows
constexpr double kLeastWidth = 48.0, kLeastHeight = 12.0;
constexpr double kStart = 0.03;  ///< seconds that starting a program takes
constexpr double kLongestProbe =
    60.0;  ///< seconds of a coarse render; what takes longer is taken for that much

Estimate bare(const Job& job) {
  Estimate e;
  e.name = job.name();
  e.fixed = kStart;
  const parser::RenderOptions& o = job.options();
  const bool is_part = o.start_column || o.end_column || o.start_row || o.end_row;
  // Errors that dithering passes on do not end at a band's edge.
  const bool passes_on = o.dither && (o.dither_type == core::DitherMethod::line ||
                                      o.dither_type == core::DitherMethod::plane ||
                                      o.dither_type == core::DitherMethod::floyd_steinberg);
  if (!is_part && !passes_on && o.type == core::FileType::png)
    e.rows = static_cast<std::int64_t>(rows_of_file(o));
  e.grain = core::Film::rows_together(tool::film_settings(o).antialiasing);
  return e;
}

/// A render of few pixels under way.
struct Coarse {
  const Job* job = nullptr;
  std::string statistics;
  double scale = 1.0;  ///< pixels of the picture to those of this render
  std::unique_ptr<tool::Child> child;
};

Coarse start(const Plan& plan, const Job& job, const std::string& place) {
  const parser::RenderOptions& o = job.options();
  const auto fewer = [](double size, double least) {
    return std::min(size, std::max(least, std::ceil(size / kCoarse)));
  };
  const double width = fewer(size_of(o).width, kLeastWidth),
               height = fewer(size_of(o).height, kLeastHeight);
  const std::string columns = std::to_string(static_cast<int>(width)),
                    rows = std::to_string(static_cast<int>(height));
  Coarse coarse;
  coarse.job = &job;
  // Lentray adds the digits of frames and views.
  coarse.statistics = place + (job.frame() ? job.frame()->digits : "") + ".json";
  coarse.scale = size_of(o).pixels() / (width * height);
  tool::Launch launch;
  enter_folder(launch, plan, job.scene());
  launch.log = place + ".log";
  launch.command = {plan.arguments.lentray.string()};
  tool::append(launch.command, job.words());
  tool::append(launch.command, {word_of(job.scene()), "-F", "-V", "+WT1", "Count_Tests=Off",
                                "Scene_Writes=memory", "Statistics_File=" + place + ".json"});
  if (o.animation.views.count > 0) {  // the sheet stays as it is
    launch.command.push_back("View_Size=" + columns + "x" + rows);
  } else {
    tool::append(launch.command, {"+W" + columns, "+H" + rows});
  }
  coarse.child = std::make_unique<tool::Child>(launch);
  return coarse;
}

void read(const Coarse& coarse, const tool::Ended& ended, Estimate& e) {
  const json all = tool::json_if_any(tool::file_bytes(coarse.statistics));
  if (ended.status == 0 && all.is_object()) {
    const json& time = all.at("time");
    e.fixed =
        kStart + time.at("parse_cpu_s").get<double>() + time.at("compile_cpu_s").get<double>();
    e.rendering = time.at("render_cpu_s").get<double>() * coarse.scale;
  } else {
    e.fixed = ended.cpu;
    e.rendering = ended.wall >= kLongestProbe ? kLongestProbe * coarse.scale : 0.0;
  }
}

/// From a row of the same picture, whatever has changed since.
bool from_earlier(const Job& job, const std::map<std::string, Row>& earlier, Estimate& e) {
  const auto at = earlier.find(job.name());
  if (at == earlier.end() || at->second.rendering <= 0.0 || at->second.width == 0) return false;
  const Row& row = at->second;
  e.fixed = kStart + row.reading + row.building;
  e.rendering = row.rendering * size_of(job.options()).pixels() /
                (static_cast<double>(row.width) * row.height);
  return true;
}

}  // namespace

std::optional<std::vector<Estimate>> estimates_of(const Plan& plan, const std::vector<Job*>& jobs,
                                                  const std::map<std::string, Row>& earlier) {
  std::vector<Estimate> out;
  std::map<std::string, std::size_t> first;  // of a scene's frames
  std::vector<std::size_t> same_as;
  std::deque<std::size_t> waiting;
  for (const Job* job : jobs) {
    const std::size_t i = out.size();
    out.push_back(bare(*job));
    same_as.push_back(first.emplace(job->scene().name, i).first->second);
    if (same_as[i] == i && !from_earlier(*job, earlier, out[i])) waiting.push_back(i);
  }
  const tool::TemporaryFolder folder;
  std::map<std::size_t, Coarse> running;
  const auto most = static_cast<std::size_t>(plan.processors);
  while (!waiting.empty() || !running.empty()) {
    while (!waiting.empty() && running.size() < most) {
      const std::size_t i = waiting.front();
      waiting.pop_front();
      try {
        running[i] = start(plan, *jobs[i], (folder / std::to_string(i)).string());
      } catch (const std::runtime_error&) {
        // The picture's own run tells it.
      }
    }
    if (tool::wait_for_news(std::chrono::milliseconds(200)) != 0) return std::nullopt;
    std::erase_if(running, [&out](auto& entry) {
      auto& [i, coarse] = entry;
      const auto ended = coarse.child->ended();
      if (ended) read(coarse, *ended, out[i]);
      if (!ended && coarse.child->seconds() > kLongestProbe) coarse.child->kill();
      return ended.has_value();
    });
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].fixed = out[same_as[i]].fixed;
    out[i].rendering = out[same_as[i]].rendering;
  }
  return out;
}

}  // namespace lentray::batch
