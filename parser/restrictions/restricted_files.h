// The disk of a scene that is not trusted (Restrict_IO=On): every file is opened first and judged by
// where the opened file lies, so that a link or folder exchanged in between changes nothing.
// Only plain files are opened. A file is never made, changed or emptied before it is judged.
// Errors: FileRefused, naming the rule. One thread.
#pragma once

#include <map>
#include <utility>

#include "parser/files/files.h"
#include "parser/files/opened_file.h"
#include "parser/restrictions/file_rules.h"

namespace lentray::parser {

class RestrictedFiles final : public Files {
 public:
  explicit RestrictedFiles(FileRules rules) : m_rules(std::move(rules)) {}

  bool exists(const std::string& path) const override;
  std::optional<std::string> read(const std::string& path) const override;
  std::optional<std::string> read_scene(const std::string& path) const override;
  std::string hold(const std::string& path) override;
  bool may_write(const std::string& path) const override;
  std::unique_ptr<FileWriter> open(const std::string& path, bool append) override;

 private:
  Descriptor judged(const std::string& path) const;
  Descriptor judged_to_write(const std::string& path) const;
  Descriptor judged_folder(const std::string& path) const;

  FileRules m_rules;
  std::map<std::pair<dev_t, ino_t>, Descriptor>
      m_held;  ///< what is held lends its number to no other file
};

}  // namespace lentray::parser
