#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QString>

#include "sim2d/base/Types.h"

/// Lists as texts that people type.
namespace editor {

using base::Vec2;

/// "lookahead=0.6, stop_distance=0.5"
QString pairsText(const std::vector<std::pair<std::string, std::string>>& pairs);
/// Nothing when a part has no name or no value.
std::optional<std::vector<std::pair<std::string, std::string>>> pairsFromText(const QString& text);
/// "0.3 0.2; -0.3 0.2; -0.3 -0.2"
QString pointsText(const std::vector<Vec2>& points);
/// Nothing when a point is not two numbers.
std::optional<std::vector<Vec2>> pointsFromText(const QString& text);

/// Times or numbers in a list, as text: "2.0, 7.5".
QString listText(const std::vector<double>& values);
/// Nothing when a word is no number.
std::optional<std::vector<double>> listFromText(const QString& text);

}  // namespace editor
