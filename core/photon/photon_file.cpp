#include "core/photon/photon_file.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <type_traits>

namespace lentray::core {
namespace {

static_assert(std::endian::native == std::endian::little && std::is_trivially_copyable_v<Photon>);

std::vector<Photon> read_list(std::string_view& bytes) {
  std::int32_t count = 0;
  if (bytes.size() < sizeof(count)) throw BadPhotonFile("it ends before its photons");
  std::memcpy(&count, bytes.data(), sizeof(count));
  bytes.remove_prefix(sizeof(count));
  if (count < 0 || static_cast<std::size_t>(count) > bytes.size() / sizeof(Photon)) {
    throw BadPhotonFile("it ends within its photons");
  }
  std::vector<Photon> photons(static_cast<std::size_t>(count));
  const std::size_t size = photons.size() * sizeof(Photon);
  if (size > 0) std::memcpy(photons.data(), bytes.data(), size);
  bytes.remove_prefix(size);
  for (const Photon& photon : photons) {
    if (photon.axis > 2) throw BadPhotonFile("a photon in it splits on no axis");
    for (const float place : photon.place) {
      if (!std::isfinite(place)) throw BadPhotonFile("a photon in it lies nowhere");
    }
  }
  return photons;
}

void write_list(std::ostream& out, const std::vector<Photon>& photons) {
  const auto count = static_cast<std::int32_t>(photons.size());
  out.write(reinterpret_cast<const char*>(&count), sizeof(count));
  for (Photon photon : photons) {
    photon.hidden_by = 0;
    out.write(reinterpret_cast<const char*>(&photon), sizeof(photon));
  }
}

}  // namespace

void write_photon_file(std::ostream& out, const std::vector<Photon>& surface,
                       const std::vector<Photon>& media) {
  write_list(out, surface);
  write_list(out, media);
}

PhotonMaps read_photon_file(std::string_view bytes) {
  PhotonMaps maps;
  maps.are_trees = true;
  maps.surface = read_list(bytes);
  if (!bytes.empty()) maps.media = read_list(bytes);
  return maps;
}

}  // namespace lentray::core
