#include "tools/lentray-chart/runner.h"

#include <signal.h>

#include <chrono>
#include <optional>

#include "tools/common/child.h"
#include "tools/common/messages.h"
#include "tools/common/process.h"

namespace lentray::chart {

Outcome Runner::run(const std::vector<std::string>& command, double cpu_limit) const {
  constexpr std::chrono::milliseconds kOften{200};
  constexpr double kPatience = 5.0;  ///< s for a program that was asked to stop
  tool::Launch launch;
  launch.command = command;
  launch.log = m_log;
  launch.cpu_limit = cpu_limit;
  tool::Child child(launch);
  std::optional<tool::Ended> ended;
  while (!(ended = child.ended())) {
    if (tool::wait_for_news(kOften) == 0) continue;
    child.ask_to_stop();
    const double asked = child.seconds();
    while (!child.ended() && child.seconds() < asked + kPatience) tool::wait_for_news(kOften);
    throw Stopped{};
  }
  Outcome outcome{ended->status, ended->cpu, tool::read_text(m_log)};
  outcome.over_limit = cpu_limit > 0.0 && (outcome.status == 128 + SIGXCPU ||
                                           (outcome.status != 0 && outcome.cpu_s >= cpu_limit));
  return outcome;
}

std::string reason_of(const Outcome& outcome, const std::string& program) {
  if (outcome.over_limit) return "it took too long";
  if (outcome.status > 128) return "ended by signal " + std::to_string(outcome.status - 128);
  if (outcome.status == 127 && outcome.output.empty()) {
    return "cannot start '" + program + "': is it installed?";
  }
  std::string text = tool::last_error(outcome.output);
  if (text.starts_with("lentray: ")) text.erase(0, 9);
  return text.empty() ? "exit status " + std::to_string(outcome.status) : text;
}

}  // namespace lentray::chart
