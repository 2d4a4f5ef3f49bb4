#include "editor/panels/properties/EntityFields.h"

#include <algorithm>
#include <cmath>

#include <QStringList>

#include "editor/document/EditCommands.h"
#include "sim2d/base/Text.h"

namespace editor {

using sim2d::ParameterTexts;

namespace {

constexpr double kDegree = base::kPi / 180.0;

template <class Item, class ToText>
QString joined(const std::vector<Item>& items, const QString& between, const ToText& toText) {
  QStringList words;
  for (const Item& item : items) {
    words << QString::fromStdString(toText(item));
  }
  return words.join(between);
}

/// None if any part is invalid.
template <class Item, class Parse>
std::optional<std::vector<Item>> parsed(const QString& text, char between, const Parse& parse) {
  std::vector<Item> items;
  for (const QString& part : text.split(QLatin1Char(between), Qt::SkipEmptyParts)) {
    std::optional<Item> item = parse(part);
    if (!item) {
      return std::nullopt;
    }
    items.push_back(*std::move(item));
  }
  return items;
}

std::optional<double> numberOf(const QString& word) {
  return base::parseDouble(word.trimmed().toStdString());
}

/// Enough decimals for the default, and steps no larger than its first digit: 0.005 must not become
/// 0.01.
base::FormHints hintsOf(const base::ParameterSpec& spec) {
  constexpr int kMaxDecimals = 6;
  base::FormHints form = spec.form;
  const double usual = std::abs(numberIn(spec.fallback).value_or(0.0));
  if (usual > 0.0 && usual < form.step) {
    form.step = std::pow(10.0, std::floor(std::log10(usual)));
  }
  const auto fits = [usual](int decimals) {
    const double scaled = usual * std::pow(10.0, decimals);
    return std::abs(scaled - std::round(scaled)) < 1e-6;
  };
  while (form.decimals < kMaxDecimals && !fits(form.decimals)) {
    ++form.decimals;
  }
  return form;
}

/// In file notation; none: neither a number nor a non-empty text.
std::optional<std::string> yamlOfParameter(const base::ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    return text->empty() ? std::nullopt
                         : std::make_optional(base::emitYaml(base::stringNode(*text)));
  }
  const std::optional<double> number = numberIn(value);
  return number ? std::make_optional(base::formatDouble(*number)) : std::nullopt;
}

}  // namespace

std::optional<double> numberIn(const base::ParameterValue& value) {
  if (const auto* integer = std::get_if<long long>(&value)) {
    return static_cast<double>(*integer);
  }
  const auto* number = std::get_if<double>(&value);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

EntityField numberField(const QString& label, const QString& unit,
                        std::function<std::optional<double>(const Entity&)> get,
                        std::function<void(Entity&, std::optional<double>)> set) {
  EntityField field;
  field.spec.form.label = label.toStdString();
  field.spec.unit = unit.toStdString();
  field.get = [get = std::move(get)](const Entity& entity) {
    const std::optional<double> value = get(entity);
    return value ? base::ParameterValue(*value) : base::ParameterValue();
  };
  field.set = [set = std::move(set)](Entity& entity, const base::ParameterValue& value) {
    set(entity, numberIn(value));
  };
  return field;
}

EntityField textField(const QString& label, const QString& help,
                      std::function<QString(const Entity&)> get,
                      std::function<void(Entity&, const QString&)> set) {
  EntityField field;
  field.spec.type = base::ParameterType::Text;
  field.spec.form.label = label.toStdString();
  field.spec.help = help.toStdString();
  field.get = [get = std::move(get)](const Entity& entity) { return get(entity).toStdString(); };
  field.set = [set = std::move(set)](Entity& entity, const base::ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    set(entity, text == nullptr ? QString() : QString::fromStdString(*text));
  };
  return field;
}

EntityField positionField(const QString& label, int axis) {
  return numberField(
      label, QStringLiteral("m"),
      [axis](const Entity& entity) -> std::optional<double> {
        const std::optional<Vec2> at = positionOf(entity);
        return at ? std::optional((*at)(axis)) : std::nullopt;
      },
      [axis](Entity& entity, std::optional<double> value) {
        if (const std::optional<Vec2> at = positionOf(entity); at && value) {
          Vec2 delta = Vec2::Zero();
          delta(axis) = *value - (*at)(axis);
          entity = moved(std::move(entity), delta);
        }
      });
}

EntityField headingField() {
  EntityField field = numberField(
      QCoreApplication::translate("Entity", "Heading"), QStringLiteral("°"),
      [](const Entity& entity) -> std::optional<double> {
        const std::optional<double> heading = headingOf(entity);
        return heading ? std::optional(std::round(*heading / kDegree * 10.0) / 10.0) : std::nullopt;
      },
      [](Entity& entity, std::optional<double> value) {
        entity = withHeading(std::move(entity), value.value_or(0.0) * kDegree);
      });
  field.spec.range = {-180.0, 180.0};
  field.spec.form.decimals = 1;
  field.spec.form.step = 5.0;
  field.spec.help =
      QCoreApplication::translate("Entity", "Counter-clockwise from the x axis").toStdString();
  return field;
}

EntityField parameterField(const ParameterOwner& owner, const std::string& name,
                           const base::ParameterSpec& spec) {
  EntityField field;
  field.spec = spec;
  field.spec.form = hintsOf(spec);
  field.belongs = [name, inForce = owner.name](const Entity& e) { return inForce(e) == name; };
  field.fallback = [usual = spec.fallback](const Entity&) { return usual; };
  const auto isKey = [key = spec.key](const auto& each) { return each.first == key; };
  field.get = [isKey, isText = spec.type == base::ParameterType::Text,
               given = owner.given](const Entity& entity) -> base::ParameterValue {
    const ParameterTexts all = given(entity);
    const auto own = std::find_if(all.begin(), all.end(), isKey);
    if (isText) {
      return own == all.end() ? base::ParameterValue()
                              : base::ParameterValue(base::scalarText(own->second));
    }
    const auto value = own == all.end() ? std::nullopt : base::parseDouble(own->second);
    return value ? base::ParameterValue(*value) : base::ParameterValue();
  };
  field.set = [isKey, key = spec.key, given = owner.given, give = owner.give](
                  Entity& entity, const base::ParameterValue& value) {
    ParameterTexts all = given(entity);
    const auto own = std::find_if(all.begin(), all.end(), isKey);
    const std::optional<std::string> yaml = yamlOfParameter(value);
    if (!yaml) {
      all.erase(std::remove_if(all.begin(), all.end(), isKey), all.end());
    } else if (own != all.end()) {
      own->second = *yaml;
    } else {
      all.emplace_back(key, *yaml);
    }
    give(entity, std::move(all));
  };
  return field;
}

ParameterTexts otherParameters(const ParameterOwner& owner, const Entity& entity) {
  const auto specs = owner.known.find(owner.name(entity));
  ParameterTexts others = owner.given(entity);
  const auto hasRow = [&](const auto& parameter) {
    return specs != owner.known.end() &&
           std::any_of(specs->second.begin(), specs->second.end(), [&](const auto& spec) {
             return spec.key == parameter.first &&
                    (spec.type == base::ParameterType::Text || base::parseDouble(parameter.second));
           });
  };
  others.erase(std::remove_if(others.begin(), others.end(), hasRow), others.end());
  return others;
}

EntityField otherParametersField(const ParameterOwner& owner, const QString& help) {
  return textField(
      QObject::tr("Unknown"), help,
      [owner](const Entity& entity) { return pairsText(otherParameters(owner, entity)); },
      [owner](Entity& entity, const QString& text) {
        ParameterTexts all = owner.given(entity);
        const ParameterTexts others = otherParameters(owner, entity);
        const ParameterTexts wanted = pairsFromText(text).value_or(ParameterTexts());
        const auto isReplaced = [&](const auto& each) {
          return std::find(others.begin(), others.end(), each) != others.end() ||
                 std::any_of(wanted.begin(), wanted.end(),
                             [&](const auto& other) { return other.first == each.first; });
        };
        all.erase(std::remove_if(all.begin(), all.end(), isReplaced), all.end());
        all.insert(all.end(), wanted.begin(), wanted.end());
        owner.give(entity, std::move(all));
      });
}

QString listText(const std::vector<double>& values) {
  return joined(values, QStringLiteral(", "), base::formatDouble);
}

std::optional<std::vector<double>> listFromText(const QString& text) {
  return parsed<double>(text, ',', numberOf);
}

QString pairsText(const std::vector<std::pair<std::string, std::string>>& pairs) {
  return joined(pairs, QStringLiteral(", "),
                [](const auto& pair) { return pair.first + "=" + pair.second; });
}

std::optional<std::vector<std::pair<std::string, std::string>>> pairsFromText(const QString& text) {
  using Pair = std::pair<std::string, std::string>;
  return parsed<Pair>(text, ',', [](const QString& part) {
    const QString name = part.section(QLatin1Char('='), 0, 0).trimmed();
    const QString value = part.section(QLatin1Char('='), 1).trimmed();
    return name.isEmpty() || value.isEmpty()
               ? std::nullopt
               : std::optional(Pair(name.toStdString(), value.toStdString()));
  });
}

QString pointsText(const std::vector<Vec2>& points) {
  return joined(points, QStringLiteral("; "), [](const Vec2& point) {
    return base::formatDouble(point.x()) + " " + base::formatDouble(point.y());
  });
}

std::optional<std::vector<Vec2>> pointsFromText(const QString& text) {
  return parsed<Vec2>(text, ';', [](const QString& part) {
    const auto place = parsed<double>(part.simplified(), ' ', numberOf);
    return place && place->size() == 2 ? std::optional(Vec2((*place)[0], (*place)[1]))
                                       : std::nullopt;
  });
}

}  // namespace editor
