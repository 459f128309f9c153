// How much memory the process may take, and whether that leaves room for something large. There is one limit for
// the process, because the system counts memory by process: set it before threads start. Errors: NoRoom. Threads:
// any number.
#pragma once

#include <stdexcept>
#include <string>

namespace lentray::core {

/// Its text says how much is wanted and how much there is.
class NoRoom : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bytes the process holds now, in memory proper; 0 where the system does not say.
double resident_bytes();

/// Bytes; infinity, as at first: no limit.
void limit_memory(double bytes);
double memory_limit();

/// Before something large is made: throws NoRoom if `bytes` more than what is held now go beyond the limit. Smaller
/// things are not asked about.
void check_room(double bytes);

/// As a reader wants it, in powers of 1000: "1.5 GB".
std::string memory_text(double bytes);

}  // namespace lentray::core
