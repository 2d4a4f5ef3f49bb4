#include "editor/panels/EntityFields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QStringList>

#include "editor/document/EditCommands.h"
#include "sim2d/base/Text.h"

namespace editor {

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

EntityField coordinateField(const QString& label, std::function<double&(Entity&)> place) {
  return numberField(
      label, QStringLiteral("m"),
      [place](const Entity& entity) {
        Entity copy = entity;
        return std::optional(place(copy));
      },
      [place](Entity& entity, std::optional<double> value) {
        double& at = place(entity);
        at = value.value_or(at);
      });
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
      QStringLiteral("Heading"), QStringLiteral("°"),
      [](const Entity& entity) -> std::optional<double> {
        const std::optional<double> heading = headingOf(entity);
        return heading ? std::optional(std::round(*heading / kDegree * 10.0) / 10.0) : std::nullopt;
      },
      [](Entity& entity, std::optional<double> value) {
        entity = turned(std::move(entity), value.value_or(0.0) * kDegree);
      });
  field.spec.range = {-180.0, 180.0};
  field.spec.form = {"Heading", 1, 5.0};
  field.spec.help = "Counter-clockwise from the right";
  return field;
}

EntityField listedField() {
  EntityField field;
  field.spec.type = base::ParameterType::Boolean;
  field.spec.form.label = "Takes part";
  field.spec.help = "Off: kept in the file, but not in the run";
  field.get = isListed;
  field.set = [](Entity& entity, const base::ParameterValue& on) {
    std::visit(
        [&on](auto& value) {
          using Value = std::decay_t<decltype(value)>;
          if constexpr (!std::is_same_v<Value, sim2d::GlobalGoal> &&
                        !std::is_same_v<Value, ScenarioSettings>) {
            value.listed = std::get<bool>(on);
          }
        },
        entity);
  };
  return field;
}

QString listText(const std::vector<double>& values) {
  return joined(values, QStringLiteral(", "), base::formatDouble);
}

std::optional<std::vector<double>> listFromText(const QString& text) {
  std::vector<double> values;
  for (const QString& word : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const std::optional<double> value = base::parseDouble(word.trimmed().toStdString());
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

QString pairsText(const std::vector<std::pair<std::string, std::string>>& pairs) {
  return joined(pairs, QStringLiteral(", "),
                [](const auto& pair) { return pair.first + "=" + pair.second; });
}

std::optional<std::vector<std::pair<std::string, std::string>>> pairsFromText(const QString& text) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const QString& part : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const int sign = part.indexOf(QLatin1Char('='));
    const QString name = part.left(std::max(sign, 0)).trimmed();
    const QString value = part.mid(sign + 1).trimmed();
    if (sign < 0 || name.isEmpty() || value.isEmpty()) {
      return std::nullopt;
    }
    pairs.emplace_back(name.toStdString(), value.toStdString());
  }
  return pairs;
}

QString pointsText(const std::vector<Vec2>& points) {
  return joined(points, QStringLiteral("; "), [](const Vec2& point) {
    return base::formatDouble(point.x()) + " " + base::formatDouble(point.y());
  });
}

std::optional<std::vector<Vec2>> pointsFromText(const QString& text) {
  std::vector<Vec2> points;
  for (const QString& part : text.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
    const QStringList words = part.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (words.size() != 2) {
      return std::nullopt;
    }
    const std::optional<double> x = base::parseDouble(words[0].toStdString());
    const std::optional<double> y = base::parseDouble(words[1].toStdString());
    if (!x || !y) {
      return std::nullopt;
    }
    points.emplace_back(*x, *y);
  }
  return points;
}

}  // namespace editor
