// The files of a run: what it read, and what its outputs are for. No output takes the place of an input, and no
// two outputs are one file. Files are distinguished by device and inode, so that links, hard links and other ways to
// write a name make no difference. Only plain files count. One memory for the whole process.
// Errors: ImageError. Threads: any.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace lentray::core {

/// This run reads the file. What is not there, or is no plain file, is passed over.
void note_input(const std::filesystem::path& path);
/// The same of a file that is open already.
void note_input(const struct stat& status, const std::filesystem::path& path);

/// This run made the file: what it reads of it later is its own.
void note_made(const std::filesystem::path& path);

/// Whether the run made the file that is there.
bool is_made(const std::filesystem::path& path);

/// Whether the run has read the file that is there.
bool is_input(const std::filesystem::path& place);
/// Throws if the run has read the file that is there; the message says under which name.
void check_not_input(const std::filesystem::path& place);

/// The file is the output that `what` names: "+O", "Statistics_File". Throws if it is an input, or if another
/// output is that file, be it there already or not.
void claim_output(const std::filesystem::path& place, std::string_view what);

/// The same for a file that is asked for before anything is computed, so that no work is lost on it: throws too if
/// it cannot be written (check_writable()). Says nothing of no file and of standard output, "-".
void claim_writable(const std::filesystem::path& place, std::string_view what);

/// For tests: nothing was read or claimed.
void forget_run_files();

}  // namespace lentray::core
