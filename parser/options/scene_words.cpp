#include "parser/options/scene_words.h"

#include <algorithm>

#include "parser/options/create_ini.h"
#include "parser/options/options.h"

namespace lentray::parser {
namespace {

using Names = std::vector<std::string>;
using Options = RenderOptions;

Names one(std::string name) { return name.empty() ? Names{} : Names{std::move(name)}; }

template <std::string Options::*member>
Names name_in(const Options& o) {
  return one(o.*member);
}
template <std::string Options::*member>
void clear(Options& o) {
  (o.*member).clear();
}

Names commands(const Options& o) {
  Names out;
  for (const ShellCommand& command : o.commands) {
    if (!command.text.empty()) out.push_back(command.text);
  }
  return out;
}

template <std::string Options::*member>
constexpr FileOption text_file(std::string_view name) {
  return {name, FileUse::kWrites, name_in<member>, clear<member>};
}

constexpr FileOption kFileOptions[] = {
    {"Input_File_Name", FileUse::kReads, name_in<&Options::input>},
    {"Include_Header", FileUse::kReads, name_in<&Options::include_header>},
    {"Library_Path", FileUse::kSearches, [](const Options& o) { return o.library_paths; }},
    {"Output_File_Name", FileUse::kWrites, name_in<&Options::output>},
    {"Create_Ini", FileUse::kWrites, [](const Options& o) { return one(ini_path(o)); },
     [](Options& o) { o.create_ini = false; }},
    {"Radiosity_File_Name", FileUse::kWrites, name_in<&Options::radiosity_file>,
     [](Options& o) {
       o.radiosity_file = Options{}.radiosity_file;
       o.radiosity_to_file = false;
     }},
    text_file<&Options::debug_file>("Debug_File"),
    text_file<&Options::fatal_file>("Fatal_File"),
    text_file<&Options::render_file>("Render_File"),
    text_file<&Options::statistic_file>("Statistic_File"),
    text_file<&Options::warning_file>("Warning_File"),
    text_file<&Options::all_file>("All_File"),
    text_file<&Options::statistics_file>("Statistics_File"),
    text_file<&Options::dependencies_file>("Dependencies_File"),
    text_file<&Options::view_cameras>("View_Cameras"),
    {"commands", FileUse::kRuns, commands},
};

bool holds(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

std::span<const FileOption> file_options() { return kFileOptions; }

FileNames file_names(const RenderOptions& options) {
  FileNames out;
  for (const FileOption& option : kFileOptions) out.push_back(option.values(options));
  return out;
}

void add_scene_words(RenderOptions& options, const FileNames& before, const std::string& where) {
  for (std::size_t i = 0; i < std::size(kFileOptions); ++i) {
    for (std::string& name : kFileOptions[i].values(options)) {
      if (!holds(before[i], name))
        options.scene_words.push_back({&kFileOptions[i], std::move(name), where});
    }
  }
}

std::vector<SceneWord> scene_words_that_hold(const RenderOptions& options) {
  std::vector<SceneWord> out;
  std::ranges::copy_if(options.scene_words, std::back_inserter(out), [&](const SceneWord& word) {
    return holds(word.option->values(options), word.value);
  });
  return out;
}

}  // namespace lentray::parser
