// What a run says of itself, and in which form: lentray's own (message_form.cpp), or POV-Ray's, for
// programs that read POV-Ray's lines (stock_form.h). Chosen once a run. One thread, but for the
// progress.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/render/progress.h"
#include "parser/options/options.h"
#include "parser/source/diagnostics.h"
#include "shadow/report.h"
#include "tools/lentray/text_streams.h"
#include "tools/session/radiosity_run.h"

namespace lentray::tool {

class MessageForm {
 public:
  explicit MessageForm(TextStreams& texts) : m_texts(texts) {}
  virtual ~MessageForm() = default;
  MessageForm(const MessageForm&) = delete;
  MessageForm& operator=(const MessageForm&) = delete;

  TextStreams& texts() const { return m_texts; }

  // Texts about what has no place in the scene, without the end of their line.
  virtual std::string warning(const std::string& text) const = 0;
  virtual std::string error(const std::string& text) const = 0;
  /// Those about a place in the scene.
  virtual parser::HeadingMaker headings() const = 0;

  // The events of a run that renders, in this order. Frames and pictures come again.
  virtual void begin_run() {}
  /// `number` of `count` pictures, which the run makes one after another.
  virtual void begin_frame(const parser::RenderOptions& options, const parser::FrameClock& clock,
                           std::size_t number, std::size_t count) = 0;
  /// `output`: the picture's file, or empty.
  virtual void begin_reading(const parser::RenderOptions&, const parser::FrameClock&,
                             const std::string& /*output*/) {}
  /// The scene is read and built; `pixels` of the report's picture will be rendered.
  virtual void begin_rendering(const parser::RenderOptions&, const shadow::RunReport&,
                               std::uint64_t /*pixels*/) {}
  virtual std::unique_ptr<core::Progress> progress() const = 0;
  /// What is said of the samples of radiosity.
  virtual std::string radiosity(const RadiosityRun& run) const { return run.text(); }
  virtual void end_picture(const parser::RenderOptions& options, const shadow::RunReport& report,
                           const std::string& output) = 0;
  /// With +C: instead of all from begin_reading() on.
  virtual void keep_picture(const std::string& output) = 0;
  /// `status`: see tools/lentray/run.h. Comes after the error, if there is one.
  virtual void end_run(int /*status*/) {}

 private:
  TextStreams& m_texts;
};

/// `as_stock`: POV-Ray's.
std::unique_ptr<MessageForm> make_message_form(bool as_stock, TextStreams& texts);

}  // namespace lentray::tool
