// The file of `save_file`: the number of those on surfaces (32 bits), these, and the same
// of those in media, which older files lack. Little-endian; 20 bytes a photon. Pure functions of bytes.
// Source: files that POV-Ray 3.7 wrote.
#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/photon/photon_maps.h"

namespace lentray::core {

/// The bytes are no photons: "it ends within its photons".
struct BadPhotonFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Both in the order of their trees, as the file has them.
void write_photon_file(std::ostream& out, const std::vector<Photon>& surface,
                       const std::vector<Photon>& media);

/// Throws BadPhotonFile.
PhotonMaps read_photon_file(std::string_view bytes);

}  // namespace lentray::core
