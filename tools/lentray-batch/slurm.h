// Slurm's commands: sbatch, squeue, sinfo. Source: their manual pages, Slurm 22.05.
// Errors: std::runtime_error with what the command says. One thread.
#pragma once

#include <filesystem>
#include <string>

namespace lentray::batch {

class Slurm {
 public:
  /// `options`: of the user's, for sbatch. Throws where Slurm is not installed or does not answer.
  explicit Slurm(std::string options);

  /// Processors that the user's options may get, at least 1.
  int processors() const { return m_processors; }
  /// Submits a job array: script and the numbers of its tasks ("0-9", "3,5"). Its job's number.
  std::string submit(const std::filesystem::path& script, const std::string& tasks,
                     const std::filesystem::path& logs) const;
  /// How many of a job's tasks wait or run. Slurm that does not answer for a while counts as many.
  int active(const std::string& job) const;

 private:
  std::string m_options;
  int m_processors = 1;
};

}  // namespace lentray::batch
