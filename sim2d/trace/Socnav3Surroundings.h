#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "sim2d/trace/JsonInput.h"

/// Parts of SocNav3 files. Private to the folder.
namespace sim2d {

/// The first existing member of an object; null: none, or not an object.
const nlohmann::json* jsonMember(const nlohmann::json& of,
                                 std::initializer_list<const char*> names);
/// The same, as a finite number.
std::optional<double> jsonNumber(const nlohmann::json& of,
                                 std::initializer_list<const char*> names);

/// Radius [m] of a body: "radius", or half of the larger side of "shape".
std::optional<double> socnav3Radius(const nlohmann::json& body);

/// Reads "walls", "objects" and "grid" from the first of `places` that has them. Invalid elements
/// are omitted with a warning.
void readSocnav3Surroundings(const std::vector<const nlohmann::json*>& places,
                             const TrackInput& input, TrackFile& file);

}  // namespace sim2d
