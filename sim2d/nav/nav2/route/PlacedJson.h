#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

namespace sim2d::nav2 {

/// A value of a JSON text with the place at which it ends (of an object or a list: begins), for
/// messages. Private to the folder.
struct PlacedJson {
  enum class Kind { Null, Bool, Number, Text, List, Object };
  Kind kind = Kind::Null;
  bool isTrue = false;
  double number = 0.0;
  std::string text;
  std::vector<PlacedJson> items;                            // of a list
  std::vector<std::pair<std::string, PlacedJson>> members;  // of an object, in their order
  int line = 0, column = 0;                                 // from 1

  const PlacedJson* find(const std::string& key) const;  // null: it has no such member
};

/// None with an error of line and column: no JSON, or nested more than 64 deep.
std::optional<PlacedJson> parsePlacedJson(const std::string& text, const std::string& file,
                                          base::Diagnostics& problems);

}  // namespace sim2d::nav2
