#include "tools/lentray/message_form.h"

#include "camera/text.h"
#include "core/base/formed.h"
#include "tools/common/progress_bar.h"
#include "tools/lentray/run_summary.h"
#include "tools/lentray/stock_form.h"

namespace lentray::tool {
namespace {

using parser::RenderOptions;

/// Of a frame, or of a view: "View 3 of 8 (number 2)".
std::string frame_line(const RenderOptions& one, const parser::FrameClock& clock,
                       std::size_t number, std::size_t count) {
  if (one.animation.views.count > 0) {
    return core::formed("View %zu of %zu (number %u)", number, count,
                        parser::rendered_view(one).value_or(0)) +
           (clock.clock_on ? ", clock " + camera::format(clock.clock) : "") + "\n";
  }
  return core::formed("Frame %d (%zu of %zu), clock %g\n", clock.frame_number, number, count,
                      clock.clock);
}

class OwnForm final : public MessageForm {
 public:
  using MessageForm::MessageForm;

  std::string warning(const std::string& text) const override { return "warning: " + text; }
  std::string error(const std::string& text) const override { return "lentray: " + text; }
  parser::HeadingMaker headings() const override { return parser::own_heading; }

  void begin_frame(const RenderOptions& options, const parser::FrameClock& clock,
                   std::size_t number, std::size_t count) override {
    if (!options.verbose) return;
    texts().write(parser::Stream::kRender, frame_line(options, clock, number, count));
  }
  std::unique_ptr<core::Progress> progress() const override {
    return std::make_unique<ProgressBar>("Rendering");
  }
  void end_picture(const RenderOptions& options, const shadow::RunReport& report,
                   const std::string& output) override {
    const std::string text = summary(options, report, output);
    if (options.verbose) {
      texts().write(parser::Stream::kStatistics, text);
    } else {
      texts().log(parser::Stream::kStatistics, text);
      if (output.empty()) texts().write(parser::Stream::kRender, no_picture(options) + "\n");
    }
  }
  void keep_picture(const std::string& output) override {
    texts().write(parser::Stream::kRender, output + ": there already, and kept (+C)\n");
  }
};

}  // namespace

std::unique_ptr<MessageForm> make_message_form(bool as_stock, TextStreams& texts) {
  if (as_stock) return std::make_unique<StockForm>(texts);
  return std::make_unique<OwnForm>(texts);
}

}  // namespace lentray::tool
