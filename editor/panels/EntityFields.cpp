#include "editor/panels/EntityFields.h"

#include <cmath>
#include <utility>

#include "editor/document/EditCommands.h"

namespace editor {

namespace {

constexpr double kDegree = base::kPi / 180.0;

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

EntityField xField() {
  return positionField(QStringLiteral("X"), 0);
}
EntityField yField() {
  return positionField(QStringLiteral("Y"), 1);
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

}  // namespace editor
