// One input of the fuzzers of files: a picture, a font or a density file, used by a scene of a few objects that is
// read, built and traced by a few rays. What is wrong with the file ends in a message; everything else that goes
// wrong is a fault.
#pragma once

#include <cstdint>
#include <string>

namespace lentray::test {

/// PNG, GIF, JPEG, BMP, PPM, PGM, TIFF, OpenEXR and Radiance by their first bytes, else TARGA: as colours, heights,
/// normals and a choice of textures. Returns the message; empty: there is none.
std::string use_picture(const std::uint8_t* data, std::size_t size);

/// TrueType and OpenType fonts by their first bytes, else .df3. Returns as use_picture().
std::string use_data(const std::uint8_t* data, std::size_t size);

}  // namespace lentray::test
