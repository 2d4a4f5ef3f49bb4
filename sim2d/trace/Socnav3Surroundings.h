#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "sim2d/trace/JsonInput.h"

/// Parts of a SocNav3 file; private to the folder.
namespace sim2d {

/// The first of these members that an object has; null: it has none, or is no object.
const nlohmann::json* jsonMember(const nlohmann::json& of,
                                 std::initializer_list<const char*> names);
/// The first of these that is a finite number.
std::optional<double> jsonNumber(const nlohmann::json& of,
                                 std::initializer_list<const char*> names);

/// [m] of a body: its "radius", or half of the larger side of its "shape".
std::optional<double> socnav3Radius(const nlohmann::json& body);

/// Adds "walls", "objects" and "grid" of the first of the places that has them. Elements that
/// cannot be parsed are left out, with a warning.
void readSocnav3Surroundings(const std::vector<const nlohmann::json*>& places,
                             const ForeignInput& input, TrackFile& file);

}  // namespace sim2d
