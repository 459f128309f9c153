// What a run says, in the form of POV-Ray 3.7.0: what programs that call it read of its standard
// error. docs/options.md lists what is there and what is not.
// Source: stock's lines with standard error in a pipe; tests/compat/reading_callers.py holds them.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/lentray/message_form.h"

namespace lentray::tool {

class StockForm final : public MessageForm {
 public:
  using MessageForm::MessageForm;

  std::string warning(const std::string& text) const override;
  std::string error(const std::string& text) const override;
  parser::HeadingMaker headings() const override;

  void begin_run() override;
  void begin_frame(const parser::RenderOptions& options, const parser::FrameClock& clock,
                   std::size_t number, std::size_t count) override;
  void begin_reading(const parser::RenderOptions& options, const parser::FrameClock& clock,
                     const std::string& output) override;
  void begin_rendering(const parser::RenderOptions& options, const shadow::RunReport& report,
                       std::uint64_t pixels) override;
  std::unique_ptr<core::Progress> progress() const override;
  std::string radiosity(const RadiosityRun& run) const override;
  void end_picture(const parser::RenderOptions& options, const shadow::RunReport& report,
                   const std::string& output) override;
  void keep_picture(const std::string& output) override;
  void end_run(int status) override;

 private:
  bool m_rendering = false;                         ///< a picture's scene is read
  std::uint64_t m_pixels = 0;                       ///< of that picture
  std::chrono::steady_clock::time_point m_start{};  ///< of its rendering
};

/// What a program of that name is called, with what it stands in for; two lines.
std::string stock_title();
/// Stands before what is wrong with a command line.
std::string stock_option_problem(const std::string& program,
                                 const std::vector<std::string>& arguments);

}  // namespace lentray::tool
