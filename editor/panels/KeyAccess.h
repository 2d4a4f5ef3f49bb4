#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "editor/panels/PropertyPage.h"

namespace editor {

/// Keys over members of one type of entity.
template <class T>
NumberKey numberKey(const QString& label, const QString& unit, const NumberField::Range& range,
                    std::optional<double> T::*member, double fallback) {
  NumberKey key;
  key.label = label;
  key.unit = unit;
  key.range = range;
  key.get = memberOf(member);
  key.set = intoMember(member);
  key.fallback = [fallback](const Entity&) { return fallback; };
  return key;
}

/// A plain number that is always written.
template <class T>
NumberKey numberKey(const QString& label, const QString& unit, const NumberField::Range& range,
                    double T::*member) {
  NumberKey key;
  key.label = label;
  key.unit = unit;
  key.range = range;
  key.get = [member](const Entity& entity) { return std::optional(std::get<T>(entity).*member); };
  key.set = [member](Entity& entity, std::optional<double> value) {
    if (value) {
      std::get<T>(entity).*member = *value;
    }
  };
  return key;
}

/// Any number, by a function that gives the place where it is kept.
template <class Place>
NumberKey placedKey(const QString& label, const QString& unit, const NumberField::Range& range,
                    double fallback, Place place) {
  NumberKey key;
  key.label = label;
  key.unit = unit;
  key.range = range;
  using Kept = std::decay_t<decltype(*place(std::declval<Entity&>()))>;
  key.get = [place](const Entity& entity) -> std::optional<double> {
    Entity copy = entity;
    const std::optional<Kept>& kept = place(copy);
    return kept ? std::optional(static_cast<double>(*kept)) : std::nullopt;
  };
  key.set = [place](Entity& entity, std::optional<double> value) {
    place(entity) = value ? std::optional(static_cast<Kept>(*value)) : std::nullopt;
  };
  key.fallback = [fallback](const Entity&) { return fallback; };
  return key;
}

/// One of several names, or none of one's own: the first word of the list.
template <class Place>
ChoiceKey nameChoice(const QString& label, const QString& none, std::vector<std::string> names,
                     Place place) {
  ChoiceKey key;
  key.label = label;
  key.words = QStringList{none};
  for (const std::string& name : names) {
    key.words.push_back(QString::fromStdString(name));
  }
  key.get = [place, names](const Entity& entity) {
    Entity copy = entity;
    const std::optional<std::string>& own = place(copy);
    const auto found = own ? std::find(names.begin(), names.end(), *own) : names.end();
    return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
  };
  key.set = [place, names](Entity& entity, int index) {
    place(entity) =
        index == 0 ? std::nullopt : std::optional(names[static_cast<std::size_t>(index - 1)]);
  };
  return key;
}

/// Whether an entity takes part in the run, for all kinds that can be switched off.
SwitchKey listedKey();

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
