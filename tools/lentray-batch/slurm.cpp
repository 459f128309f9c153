#include "tools/lentray-batch/slurm.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "tools/common/messages.h"
#include "tools/common/process.h"
#include "tools/common/shell_words.h"

namespace lentray::batch {
namespace {

constexpr double kPatience = 60.0;  ///< seconds for a command of Slurm's

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

std::string said_by(const std::vector<std::string>& command) {
  tool::RunResult result;
  try {
    result = tool::run_program(command, {}, kPatience);
  } catch (const std::runtime_error&) {
    throw std::runtime_error("--slurm: there is no '" + command[0] +
                             "': Debian's package slurm-client has it");
  }
  if (result.status != 0 || result.timed_out) {
    throw std::runtime_error("--slurm: " + command[0] + ": " +
                             (result.timed_out ? "no answer" : tool::one_line(result.output)));
  }
  return result.output;
}

}  // namespace

Slurm::Slurm(std::string options) : m_options(std::move(options)) {
  std::vector<std::string> command{"sinfo", "-h", "-o", "%C"};  // allocated/idle/other/total
  for (const std::string& word : words_of(m_options)) {
    if (word.starts_with("--partition=")) command.push_back(word);
  }
  int all = 0;
  for (const std::string& counts : words_of(said_by(command))) {
    all += std::atoi(counts.substr(counts.rfind('/') + 1).c_str());
  }
  m_processors = std::max(1, all);
}

std::string Slurm::submit(const std::filesystem::path& script, const std::string& tasks,
                          const std::filesystem::path& logs) const {
  std::vector<std::string> command{"sbatch",
                                   "--parsable",
                                   "--array=" + tasks,
                                   "--requeue",
                                   "--open-mode=append",
                                   "--job-name=lentray-batch",
                                   "--output=" + (logs / "task-%a.log").string()};
  tool::append(command, words_of(m_options));
  command.push_back(script.string());
  const std::string said = said_by(command);
  return said.substr(0, said.find_first_of(";\n"));
}

int Slurm::active(const std::string& job) const {
  const tool::RunResult result =
      tool::run_program({"squeue", "-h", "-r", "-j", job, "-o", "%T"}, {}, kPatience);
  if (result.output.find("Invalid job id") != std::string::npos) return 0;
  if (result.status != 0 || result.timed_out) return std::numeric_limits<int>::max();
  return static_cast<int>(std::ranges::count(result.output, '\n'));
}

}  // namespace lentray::batch
