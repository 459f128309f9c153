#include "tools/lentray-batch/picture_run.h"

#include <algorithm>

namespace lentray::batch {

bool PictureRun::take(Job& job) {
  if (!job.is_view_after(*m_jobs.back())) return false;
  m_jobs.push_back(&job);
  return true;
}

double PictureRun::room() const {
  double bytes = 0.0;
  for (const Job* job : m_jobs) bytes += job->room(job == m_jobs.front());
  return bytes;
}

tool::Launch PictureRun::launch(int threads, double memory) {
  const auto can_go_on = [](const Job* job) { return job->can_go_on(); };
  const bool goes_on = std::ranges::any_of(m_jobs, can_go_on);
  for (const Job* job : m_jobs) {
    if (goes_on && !job->can_go_on()) job->drop_picture();  // which +C would keep
  }
  const tool::Launch launch = job().render(*m_jobs.back(), goes_on, threads, memory);
  for (Job* job : m_jobs) job->prepare(launch);
  m_threads = threads;
  m_told = {};
  m_made = 0;
  job().begin(m_threads);
  return launch;
}

Job* PictureRun::made() {
  if (m_jobs.size() < 2 || !job().is_made()) return nullptr;
  Job* const made = m_jobs.front();
  const tool::Ended part = made->part();
  made->rendered(part, false);
  m_told.wall += part.wall;
  m_told.cpu += part.cpu;
  if (m_made++ == 0) m_reading = made->row().reading + made->row().building;
  m_can_be_made = true;
  m_jobs.pop_front();
  job().begin(m_threads);
  return made;
}

tool::Ended PictureRun::rest(tool::Ended ended) const {
  ended.wall = std::max(0.0, ended.wall - m_told.wall);
  ended.cpu = std::max(0.0, ended.cpu - m_told.cpu);
  return ended;
}

bool PictureRun::is_worth_stopping() const {
  const double each = m_made > 0 ? (m_told.wall - m_reading) / m_made : 0.0;
  return each * static_cast<double>(m_jobs.size()) > 2.0 * m_reading;
}

bool PictureRun::is_of_scene(bool was_ended, const std::string& reason) {
  if (m_can_be_made) return false;
  if (was_ended) return !job().is_read();
  const bool is_same = reason == m_failed_with;
  m_failed_with = reason;
  return is_same;
}

}  // namespace lentray::batch
