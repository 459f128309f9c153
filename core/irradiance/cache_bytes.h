// A cache of radiosity as bytes, and back: all that a picture reads of it, bit for bit. Bytes are of this
// machine's kind, and say nothing of the scene: whoever keeps them says what they are of, and puts a checksum
// beside them. Pure functions.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/irradiance/irradiance_cache.h"

namespace lentray::core {

std::string bytes_of(const IrradianceCache& cache);

/// Null if they are no such cache. The samples are those of the settings' depths.
std::shared_ptr<IrradianceCache> cache_of(std::string_view bytes, const RadiositySettings& settings,
                                          const Vec3& eye);

/// Samples behind each other, each of the same size.
void append_samples(const std::vector<IrradianceSample>& samples, std::size_t first,
                    std::string& bytes);
/// Takes so many samples from the front; false if there are fewer.
bool take_samples(std::string_view& bytes, std::size_t count, SampleStore& store);

}  // namespace lentray::core
