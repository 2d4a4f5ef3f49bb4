#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Types.h"

/// Converts port text to values by the rules of BehaviorTree.CPP: a number ends at the first
/// character that does not belong to it ("5abc" is 5), leading blanks and '+' are rejected, C
/// locale.
namespace bt {

std::optional<int> intFromText(std::string_view text);
std::optional<std::int64_t> unsignedFromText(std::string_view text);  // 0 … 4294967295
std::optional<double> doubleFromText(std::string_view text);
std::optional<bool> boolFromText(std::string_view text);  // 0 1 true TRUE True false FALSE False
std::optional<base::NodeStatus> statusFromText(std::string_view text);

/// Splits a queue at ';'. A trailing ';' is ignored.
std::vector<std::string> splitQueue(std::string_view list);

/// The number that a port of a numeric type reads from this text if the text has further characters
/// ("1,5" is read as 1). Empty if the whole text is a number or if it contains none.
std::optional<double> partiallyReadNumber(std::string_view text, PortType type);

/// Whether a port of this type accepts the constant.
bool isConvertible(std::string_view text, PortType type);

}  // namespace bt
