#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Types.h"

/// Text of a port as a value, by the rules of BehaviorTree.CPP: numbers end at the first character
/// that does not belong to them ("5abc" is 5), no blank and no '+' in front, C locale.
namespace bt {

std::optional<int> intFromText(std::string_view text);
std::optional<std::int64_t> unsignedFromText(std::string_view text);  // 0 … 4294967295
std::optional<double> doubleFromText(std::string_view text);
std::optional<bool> boolFromText(std::string_view text);  // 0 1 true TRUE True false FALSE False
std::optional<base::NodeStatus> statusFromText(std::string_view text);

/// The elements of a queue, separated by ';'; a trailing ';' is ignored.
std::vector<std::string> elementsOf(std::string_view list);

/// The number that a port of a numeric type is given by this text, when that is not all that
/// stands there ("1,5" is 1); nothing when it is, and for text without a number.
std::optional<double> cutNumber(std::string_view text, PortType type);

/// Whether a constant can be given to a port of this type.
bool isConvertible(std::string_view text, PortType type);

}  // namespace bt
