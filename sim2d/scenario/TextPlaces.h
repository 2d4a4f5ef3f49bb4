#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"

/// Places in the text of a scenario for what is said about its meaning.
namespace sim2d {

/// Gives what is said about lines of the file `path` the column at which the line's key begins.
void addColumns(base::Diagnostics& diagnostics, const std::string& path);

/// Gives what is said about the file `path` without a line the place of the first of these keys
/// that is there, dotted from the top: "hunav_loader.ros__parameters.map".
void addPlaceOfKey(base::Diagnostics& diagnostics, const std::string& path,
                   const std::vector<std::string>& keys);

/// The same for what `findMap` says of the scenario in the file `path`: the key that names the map.
void addPlaceOfMap(base::Diagnostics& diagnostics, const std::string& path);

}  // namespace sim2d
