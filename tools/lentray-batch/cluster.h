// A batch on a cluster: pictures and bands of large ones are tasks of a job array; rows are collected as workers write
// them; what a lost node left is run again by Slurm, and what its array left is submitted again.
// Errors: std::runtime_error. One thread.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tools/lentray-batch/job.h"
#include "tools/lentray-batch/manifest.h"
#include "tools/lentray-batch/progress.h"
#include "tools/lentray-batch/run_folder.h"
#include "tools/lentray-batch/slurm.h"

namespace lentray::batch {

class Cluster {
 public:
  Cluster(const Plan& plan, Manifest& manifest, BatchProgress& progress);

  /// Makes the pictures of these jobs, which take over the rows. False if a signal stopped the waiting; the array goes on.
  bool run(const std::vector<Job*>& jobs);

 private:
  bool go_on();
  bool results_fit() const;
  bool prepare(const std::vector<Job*>& jobs);
  std::filesystem::path write_script() const;
  void submit();
  bool wait();
  void collect();
  void take(const Row& row);
  std::string rows_of_bands(const std::string& name) const;
  void merge(const std::string& name, const std::vector<Row>& bands);

  const Plan& m_plan;
  Manifest& m_manifest;
  BatchProgress& m_progress;
  const Slurm m_slurm;
  const std::filesystem::path m_root;  ///< of all runs
  std::map<std::string, Job*> m_jobs;  ///< those without a row, by name
  std::unique_ptr<RunFolder> m_folder;
  std::vector<std::vector<Work>> m_tasks;
  std::map<std::string, std::map<int, Row>>
      m_bands;  ///< by the picture's name and the band's number
  std::map<std::string, int> m_band_count;
  std::set<std::string> m_taken;  ///< names of rows that were seen
  std::string m_job;
  int m_submissions = 0;
};

}  // namespace lentray::batch
