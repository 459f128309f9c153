#include "tools/session/going_on.h"

#include <filesystem>

#include "parser/options/options.h"
#include "tools/session/pass_file.h"
#include "tools/session/picture_journal.h"

namespace lentray::tool {

bool is_file_place(const std::string& picture) {
  std::error_code error;
  const auto status = std::filesystem::status(picture, error);
  return !picture.empty() && picture != "-" &&
         (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status));
}

bool is_finished(const std::string& picture, const Identity& identity, const std::string& scene) {
  const auto earlier = PictureJournal::earlier(picture);
  if (earlier) {
    Identity now = identity;
    now.seen = earlier->identity.seen;
    std::string why = difference(earlier->identity, now);
    if (why.empty() && !scene.empty()) why = change_in(now.seen, scene);
    if (!why.empty()) {
      throw parser::OptionError("'" + picture + "' cannot be continued: " + why +
                                (earlier->is_finished ? " since the frame was made" : "") +
                                " (without +C everything is begun anew)");
    }
  }
  return std::filesystem::exists(picture) && (!earlier || earlier->is_finished);
}

std::optional<double> moment_of(const std::string& picture) {
  if (const auto journal = PictureJournal::earlier(picture)) return journal->identity.seen.now;
  const auto passes = PassFile::earlier(picture);
  return passes ? passes->seen.now : std::nullopt;
}

}  // namespace lentray::tool
