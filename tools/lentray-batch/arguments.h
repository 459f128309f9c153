// The command line of lentray-batch: its own options (--name), folders and scenes, and lentray's options, which hold
// for every scene. Relative paths in these are made absolute, for every scene is rendered in its own folder.
// Errors: parser::OptionError, worded for the user. Reads INI files; pure otherwise.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/image/compare.h"

namespace lentray::batch {

struct Arguments {
  std::vector<std::filesystem::path> inputs;  ///< folders and scenes, as given
  std::filesystem::path out;                  ///< the batch's folder, absolute
  std::vector<std::string> for_lentray;       ///< in order; paths are absolute
  bool restricts = true;                      ///< Restrict_IO=On: scenes are strangers'
  bool frames = false;                        ///< animations are rendered; else a still of each
  bool views = false;         ///< the views of integral images as pictures of their own
  bool compare = false;       ///< stock beside each
  bool scene_ini = true;      ///< scene.ini beside scene.pov holds for that scene
  bool retry = false;         ///< what failed is tried again though nothing has changed
  bool quiet = false;         ///< no progress
  int jobs = 0;               ///< scenes at a time; 0: as many as there are processors
  double time_limit = 0.0;    ///< seconds a scene; 0: none
  double memory_limit = 0.0;  ///< bytes a scene; 0: half of the machine's
  std::filesystem::path lentray, diff, merge;  ///< programs
  bool slurm = false;                          ///< pictures are made by jobs of Slurm
  double task_time = 0.0;  ///< seconds a task of Slurm should take; 0: by the work and the nodes
  std::string sbatch;      ///< further options of sbatch
  std::filesystem::path
      worker;  ///< the folder of a run of Slurm whose task is to be done; empty: no worker
  int task = 0;
  std::vector<std::string> words;  ///< the command line
  std::string povray = "povray";
  std::optional<core::Grade> asked;  ///< what every scene must reach
  std::filesystem::path table;       ///< Markdown; empty: none
  std::string noise;                 ///< lentray-diff's --noise; empty: its default
};

Arguments parse_arguments(const std::vector<std::string>& words);
std::string usage();

}  // namespace lentray::batch
