// The journal of a picture in the making: a file beside it, a.png.lentray-state, that keeps what
// its film finds out (core/render/picture_ledger.h), so that a picture that was cut off is gone on
// with (+C).
//
// It is a WorkFile (tools/session/work_file.h) with records of pixels. Nothing is kept of the first
// second: a quick picture never has the file. 24 bytes a pixel; twice as many with antialiasing. A
// finished picture has no journal, but for the frames of an animation: theirs say that they are
// finished until the whole animation is. Errors: parser::OptionError. Threads: as the ledger; the
// rest one thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/image/spare_room.h"
#include "core/render/picture_ledger.h"
#include "tools/common/companion.h"
#include "tools/session/identity.h"
#include "tools/session/work_file.h"

namespace lentray::tool {

class PictureJournal final : public core::PictureLedger, public core::SpareRoom {
 public:
  /// Nothing is kept before `silence` has passed.
  PictureJournal(std::string picture, std::uint32_t width, std::uint32_t height, Identity identity,
                 std::chrono::milliseconds silence = std::chrono::seconds(1));

  /// What the journal says of its picture: an earlier run's identity. Empty: there is no journal.
  struct Earlier {
    Identity identity;
    bool is_finished = false;
  };
  static std::optional<Earlier> earlier(const std::string& picture);

  /// Nothing is kept of that picture any more, unless a run is at it.
  static void forget(const std::string& picture);
  /// Continues what there is. Throws as WorkFile::go_on().
  void go_on();
  /// The picture is in its place: nothing is kept, or that it is finished.
  void finish(bool say_so);
  /// The run is cut off in order: writes what is not written yet. False: there is nothing to go on
  /// with.
  bool keep();
  /// As WorkFile has it.
  std::string trouble() const { return m_work.trouble(); }

  const core::PixelSet* known(std::size_t stage) const override { return m_known[stage].get(); }
  void recall(std::size_t stage, std::uint32_t top, std::uint32_t bottom,
              const std::function<void(const core::Pixel&, const float*)>& tell) override;
  bool listens() const override { return m_work.listens(); }
  void add(std::size_t stage, const std::vector<core::Pixel>& pixels,
           const std::vector<float>& values) override;

  /// That the journal takes, or the one that an earlier run left.
  std::uint64_t bytes() override;
  /// Nothing is kept any more on the disk. What recall() may be asked for yet is held in memory.
  bool give() override;

 private:
  /// Where the pixels of a record are in the file.
  struct Place {
    std::uint64_t offset = 0;  ///< of its bytes
    std::uint32_t stage = 0, count = 0, first_row = 0, last_row = 0;
    std::string bytes{};  ///< instead of the file's, once that is given up
  };

  bool note_record(std::uint32_t stage, std::uint64_t place, const std::string& bytes);
  void read(const Place& place, std::string& bytes) const;

  const std::uint32_t m_width, m_height;
  WorkFile m_work;
  std::uint32_t m_recalled[kStages]{};  ///< rows above are not asked for again
  std::unique_ptr<core::PixelSet> m_known[kStages];
  std::vector<Place> m_places;
  std::mutex m_mutex;
};

}  // namespace lentray::tool
