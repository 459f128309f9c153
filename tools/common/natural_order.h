// Files that a shell has put in order letter by letter, IMG_1, IMG_10, IMG_2, in the order in which they were numbered.
// Errors: none. Pure, but for the user's locale.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lentray::tool {

/// In natural order runs of digits count as numbers. A minus is their sign where behind the same text other numbers have a
/// plus or none: v-1, v0, v1, but frame-1, frame-2. What is alike by that is compared letter by letter.
/// The files in natural order, if they are in the order that a shell puts them in and that is another one. Else they are
/// in natural order already, or somebody chose the order: nothing.
std::optional<std::vector<std::filesystem::path>> natural_order_instead(
    const std::vector<std::filesystem::path>& files);

/// "pictures taken in natural order: a1.png, a2.png, ..., a12.png".
std::string natural_order_line(const std::vector<std::filesystem::path>& files);

}  // namespace lentray::tool
