// What a batch keeps for itself in DIR/.lentray-batch: a lock, files of runs, thumbnails, and a reserve of disk space.
// Errors: std::runtime_error, worded for the user. One thread.
#pragma once

#include <filesystem>
#include <string>

#include "tools/common/own_folder.h"

namespace lentray::batch {

class StateFolder : public tool::OwnFolder {
 public:
  /// alone: the batch itself, one at a time; shared: a worker of the batch.
  enum class Access { alone, shared };
  /// Makes `out` and what belongs to it. Throws where that cannot be done, and while another batch works there.
  explicit StateFolder(const std::filesystem::path& out, Access access = Access::alone)
      : OwnFolder(out, "lentray-batch", access == Access::alone) {}
  ~StateFolder();

  /// A file of the run of a picture under that key, such as "log"; its folder is made.
  std::filesystem::path file(const std::string& name, const std::string& key,
                             const std::string& kind) const;
  /// Where runs keep passes of radiosity, which pictures share; '/' ends it.
  std::string radiosity_folder() const { return (path() / "radiosity" / "").string(); }
  void forget_radiosity() const;
  /// Of all keys of that picture but this one.
  void forget_others(const std::string& name, const std::string& key) const;
  /// Keeps room on the disk for the rows and the page of so many pictures, where there is as much.
  void reserve(std::size_t pictures) const;
  /// Gives the reserve back to a disk that is full, so that rows and page can still be written. False: it is gone already.
  bool free_reserve() const;

 private:
  std::filesystem::path begin_of(const std::string& name) const;
};

}  // namespace lentray::batch
