#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "sim2d/trace/ForeignReaders.h"

/// JSON of other programs; private to the folder.
namespace sim2d {

/// None: the text is not JSON, which is noted with line and column.
std::optional<nlohmann::json> parseJsonInput(const ForeignInput& input);

}  // namespace sim2d
