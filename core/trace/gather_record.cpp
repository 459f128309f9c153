#include "core/trace/gather_record.h"

#include "core/base/byte_text.h"
#include "core/irradiance/cache_bytes.h"

namespace lentray::core {

std::vector<std::size_t> sizes_of(const IrradianceCache& cache) {
  std::vector<std::size_t> out;
  for (int depth = 0; depth < cache.depths(); ++depth)
    out.push_back(cache.store(depth).samples().size());
  return out;
}

std::string bytes_of(const GatherState& state, const IrradianceCache& cache,
                     const std::vector<std::size_t>& before) {
  std::string out;
  append_bytes(state.light.light, out);
  append_bytes(state.light.quality, out);
  append_bytes(state.light.is_kept, out);
  append_bytes(state.gathers, out);
  append_bytes(state.importance, out);
  for (std::size_t depth = 0; depth < before.size(); ++depth) {
    append_bytes(state.places[depth], out);
    append_bytes(state.counts[depth], out);
    const auto& samples = cache.store(static_cast<int>(depth)).samples();
    append_bytes(static_cast<std::uint64_t>(samples.size() - before[depth]), out);
    append_samples(samples, before[depth], out);
  }
  return out;
}

bool take_gather(std::string_view bytes, GatherState& state, IrradianceCache& cache) {
  std::uint8_t is_kept = 0;  // a bool holds no other byte than 0 and 1
  if (!take_bytes(bytes, state.light.light) || !take_bytes(bytes, state.light.quality) ||
      !take_bytes(bytes, is_kept) || !take_bytes(bytes, state.gathers) ||
      !take_bytes(bytes, state.importance))
    return false;
  state.light.is_kept = is_kept != 0;
  state.places.resize(static_cast<std::size_t>(cache.depths()));
  state.counts.resize(state.places.size());
  for (std::size_t depth = 0; depth < state.places.size(); ++depth) {
    std::uint64_t count = 0;
    if (!take_bytes(bytes, state.places[depth]) || !take_bytes(bytes, state.counts[depth]) ||
        !take_bytes(bytes, count) ||
        !take_samples(bytes, count, cache.store(static_cast<int>(depth))))
      return false;
  }
  return bytes.empty();
}

}  // namespace lentray::core
