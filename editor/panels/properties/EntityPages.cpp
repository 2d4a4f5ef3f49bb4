#include "editor/panels/properties/EntityPages.h"

#include <cmath>

#include "editor/run/SimulationRunner.h"
#include "metrics/Samples.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/Runner.h"
#include "sim2d/world/World.h"

namespace editor {

namespace {

using sim2d::Area;
using sim2d::Dock;
using sim2d::Door;
using sim2d::Obstacle;
using sim2d::ObstacleKind;

constexpr int kMaxVisitors = 12;  // Maximum number of names listed.

/// True if all are obstacles of one of the kinds.
bool areOf(const std::vector<Entity>& shown, const std::vector<ObstacleKind>& kinds) {
  return std::all_of(shown.begin(), shown.end(), [&](const Entity& each) {
    return std::count(kinds.begin(), kinds.end(), std::get<Obstacle>(each).kind) > 0;
  });
}

template <class T>
EntityField cornersField() {
  return textField(
      QObject::tr("Corners"), QObject::tr("x y [m], separated by semicolons"),
      [](const Entity& entity) { return pointsText(std::get<T>(entity).points); },
      [](Entity& entity, const QString& text) {
        std::get<T>(entity).points = *pointsFromText(text);
      });
}

QString cornersProblem(const QString& text, std::size_t least) {
  const auto corners = pointsFromText(text);
  return corners && corners->size() >= least
             ? QString()
             : QObject::tr("At least %1 corners x y, separated by semicolons").arg(least);
}

class GoalPage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::GoalPage)
 public:
  explicit GoalPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Goal"));
    addUniqueNumber(
        section, {}, 1, [](const Entity& goal) { return std::get<sim2d::GlobalGoal>(goal).id; },
        [this](int number) { return pushGoalNumber(this->document(), targets().front(), number); });
    addPosition(section);
    auto* users = secondaryLabel({}, this);
    users->setWordWrap(true);
    section->addRow(tr("Visited by"), users);
    addRefresh([this, users](const std::vector<Entity>& shown) {
      users->setText(shown.size() == 1 ? visitorsOf(std::get<sim2d::GlobalGoal>(shown.front()).id)
                                       : tr("several goals selected"));
    });
  }

 private:
  QString visitorsOf(int goal) const {
    QStringList names;
    for (const sim2d::Human& human : document().scenario().humans) {
      if (std::find(human.goals.begin(), human.goals.end(), goal) != human.goals.end()) {
        names.push_back(QString::fromStdString(human.name));
      }
    }
    const int more = static_cast<int>(names.size()) - kMaxVisitors;
    if (names.isEmpty()) {
      return tr("none");
    }
    const QString first = names.mid(0, kMaxVisitors).join(QStringLiteral(", "));
    return more > 0 ? tr("%1 and %2 more").arg(first).arg(more) : first;
  }
};

class ObstaclePage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::ObstaclePage)
 public:
  explicit ObstaclePage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Obstacle"));
    addName(section);
    addListedRow(section);
    addPosition(section);
    FieldOptions ofBox;
    ofBox.visible = [](const std::vector<Entity>& shown) {
      return areOf(shown, {ObstacleKind::Box});
    };
    addRow(section, headingField(), ofBox);
    for (const char* key : {"length", "width", "radius", "thickness"}) {
      addField<Obstacle>(section, key);
    }
    FieldOptions corners = withPlaceholder({}, [this](const QString& text) {
      return cornersProblem(text, areOf(values(), {ObstacleKind::Wall}) ? 2 : 3);
    });
    corners.visible = [](const std::vector<Entity>& shown) {
      return areOf(shown, {ObstacleKind::Polygon, ObstacleKind::Wall});
    };
    addRow(section, cornersField<Obstacle>(), corners);
    addRemainingFields<Obstacle>({"kind", "x", "y", "h"});
    addRefresh([section](const std::vector<Entity>& shown) {
      const ObstacleKind first = std::get<Obstacle>(shown.front()).kind;
      section->setNote(areOf(shown, {first}) ? obstacleKindName(first) : tr("several shapes"));
    });
  }
};

class DoorPage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::DoorPage)
 public:
  explicit DoorPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Door"));
    addName(section);
    addListedRow(section);
    const auto end = [](const QString& label, Vec2 Door::*point, int axis) {
      return numberField(
          label, QStringLiteral("m"),
          [=](const Entity& door) { return std::optional((std::get<Door>(door).*point)(axis)); },
          [=](Entity& door, std::optional<double> value) {
            double& at = (std::get<Door>(door).*point)(axis);
            at = value.value_or(at);  // It must have a value.
          });
    };
    addNumberPair(section, tr("From"), end(tr("From X"), &Door::from, 0),
                  end(tr("From Y"), &Door::from, 1));
    addNumberPair(section, tr("To"), end(tr("To X"), &Door::to, 0), end(tr("To Y"), &Door::to, 1));
    addField<Door>(section, "thickness");
    addField<Door>(section, "open", withLabels({tr("Open")}));
    addField<Door>(section, "toggles",
                   withPlaceholder(tr("seconds, such as 5, 12.5"), [](const QString& text) {
                     const auto times = listFromText(text);
                     const bool fine = times && std::is_sorted(times->begin(), times->end()) &&
                                       (times->empty() || times->front() >= 0.0);
                     return fine ? QString()
                                 : tr("Times in seconds, ascending, separated by commas");
                   }));
    addRemainingFields<Door>({"x1", "y1", "x2", "y2"});
  }
};

class AreaPage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::AreaPage)
 public:
  explicit AreaPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Area"));
    addName(section);
    addListedRow(section);
    addField<Area>(section, "kind",
                   withLabels({tr("Source: people appear"), tr("Sink: people leave"),
                               tr("Waiting area"), tr("Exit"), tr("Speed: stairs, travelators")}));
    addPosition(section);
    addRow(section, cornersField<Area>(),
           withPlaceholder({}, [](const QString& text) { return cornersProblem(text, 3); }));
    FormSection* source = addSection(tr("Spawned people"));
    addField<Area>(
        source, "like", withPlaceholder(tr("name of a person"), [this](const QString& text) {
          const sim2d::Scenario& scenario = this->document().scenario();
          const bool known = text.isEmpty() || scenario.human(text.toStdString()) != nullptr;
          return known ? QString() : tr("No person has this name");
        }));
    addField<Area>(source, "rate");
    addField<Area>(source, "from");
    FieldOptions until;
    until.fallback = [](const Entity&) { return 86400.0; };
    addField<Area>(source, "until", until);
    FieldOptions count;
    count.unit = tr("people");
    count.singularUnit = tr("person");
    count.fallback = [](const Entity&) { return 100000.0; };
    addField<Area>(source, "count", count);
    FormSection* speed = addSection(tr("Speed"));
    addField<Area>(speed, "factor");
    addField<Area>(speed, "carry_speed");
    addField<Area>(speed, "carry_h");
    addRemainingFields<Area>();
    addRefresh([source, speed](const std::vector<Entity>& shown) {
      const auto areAll = [&shown](sim2d::AreaKind kind) {
        return std::all_of(shown.begin(), shown.end(), [kind](const Entity& each) {
          return std::get<Area>(each).kind == kind;
        });
      };
      source->setVisible(areAll(sim2d::AreaKind::Source));
      speed->setVisible(areAll(sim2d::AreaKind::Speed));
    });
  }
};

class DockPage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::DockPage)
 public:
  explicit DockPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Dock"));
    addName(section);
    addListedRow(section);
    addField<Dock>(section, "kind", withLabels({tr("Charges robots"), tr("Parking place")}));
    addPosition(section);
    addRow(section, headingField(), {});
    addRemainingFields<Dock>({"x", "y", "h"});
  }
};

}  // namespace

std::map<EntityKind, PropertyPage*> entityPages(ScenarioDocument& document, const Theme& theme) {
  auto* const robot = new RobotPage(document);
  robot->setTheme(theme);
  return {{EntityKind::Human, new PersonPage(document, theme)},
          {EntityKind::Robot, robot},
          {EntityKind::Goal, new GoalPage(document)},
          {EntityKind::Obstacle, new ObstaclePage(document)},
          {EntityKind::Door, new DoorPage(document)},
          {EntityKind::Area, new AreaPage(document)},
          {EntityKind::Dock, new DockPage(document)},
          {EntityKind::Scenario, new SettingsPage(document)}};
}

namespace {

using Desktop = sim2d::DesktopSettings;
using Metrics = sim2d::MetricsSettings;
using Variation = sim2d::VariationSettings;
using Card = sim2d::ScenarioCard;

template <class AnyEntity>
auto& desktop(AnyEntity& entity) {
  return std::get<ScenarioSettings>(entity).desktop;
}

/// Parameters of the default model of people.
ParameterOwner modelsOf(const sim2d::Registries& registries) {
  ParameterOwner owner;
  owner.known = sim2d::knownNames(registries).modelParameters;
  owner.name = [](const Entity& entity) {
    return desktop(entity).model.value_or(sim2d::ResolvedHuman().model);
  };
  const auto isModel = [name = owner.name](const Entity& entity) {
    return [model = name(entity)](const auto& each) { return each.first == model; };
  };
  owner.given = [isModel](const Entity& entity) {
    const auto& all = desktop(entity).modelParameters;
    const auto* own = base::findIf(all, isModel(entity));
    return own == nullptr ? sim2d::ParameterTexts() : own->second;
  };
  owner.give = [isModel, name = owner.name](Entity& entity, sim2d::ParameterTexts texts) {
    auto& all = desktop(entity).modelParameters;
    auto* own = base::findIf(all, isModel(entity));
    if (texts.empty()) {
      all.erase(std::remove_if(all.begin(), all.end(), isModel(entity)), all.end());
    } else if (own != nullptr) {
      own->second = std::move(texts);
    } else {
      all.emplace_back(name(entity), std::move(texts));
    }
  };
  return owner;
}

EntityField thresholdsField() {
  return textField(
      QObject::tr("Thresholds"), QObject::tr("Metric thresholds, such as name=value, name=value"),
      [](const Entity& entity) {
        std::vector<std::pair<std::string, std::string>> pairs;
        for (const auto& [name, value] : desktop(entity).metrics.parameters) {
          pairs.emplace_back(name, base::formatDouble(value));
        }
        return pairsText(pairs);
      },
      [](Entity& entity, const QString& text) {
        auto& parameters = desktop(entity).metrics.parameters;
        parameters.clear();
        const auto pairs = pairsFromText(text);
        for (const auto& [name, value] : pairs.value()) {
          parameters.emplace_back(name, base::parseDouble(value).value_or(0.0));
        }
      });
}

QString thresholdsProblem(const QString& text) {
  const auto pairs = pairsFromText(text);
  const bool numbers = pairs && std::all_of(pairs->begin(), pairs->end(), [](const auto& each) {
                         return base::parseDouble(each.second).has_value();
                       });
  return numbers ? QString() : QObject::tr("name=number, separated by commas");
}

/// Worlds that HuNavSim provides for a simulator; other maps need a world of the same name there.
QString worldsOf(const QString& simulator) {
  if (simulator == QLatin1String("Isaac Sim")) {
    return QStringLiteral("warehouse, hospital, office, empty_world");
  }
  if (simulator == QLatin1String("Webots")) {
    return QStringLiteral("factory, hall, office");
  }
  return simulator.isEmpty() ? QString() : QStringLiteral("cafe, house, warehouse");
}

}  // namespace

SettingsPage::SettingsPage(ScenarioDocument& document, const sim2d::Registries& registries)
    : PropertyPage(document) {
  addRunSection();
  addPeopleSection(registries);
  addVariationSection();
  addModelSection(registries);
  addMeasureSection();
  addCardSection();
  addFileSection();
  addRemainingFields<Desktop>();
  addRemainingFields<Variation>();
  addRemainingFields<Metrics>();
  addRemainingFields<Card>();
  addRemainingFields<ScenarioSettings>({"yaml_base_name"});
}

void SettingsPage::addRunSection() {
  FormSection* section = addSection(tr("Run"));
  addField<Desktop>(section, "seed");
  FieldOptions duration;
  duration.fallback = [this](const Entity&) {
    sim2d::Scenario plain;
    plain.robots = this->document().scenario().robots;
    plain.desktop.dt = 1.0;
    return static_cast<double>(sim2d::stopRuleOf(plain).maximumSteps);
  };
  addField<Desktop>(section, "duration", duration);
  auto* end = secondaryLabel({}, this);
  end->setWordWrap(true);
  section->addRow(QString(), end);
  addRefresh([this, section, end](const std::vector<Entity>&) {
    const QString words = runEndText(this->document().scenario());
    end->setText(capitalized(words));
    section->setRowVisible(end, !words.isEmpty());
  });
  addField<Desktop>(section, "stop_on_collision",
                    withLabels({tr("No (default)"), tr("With people"), tr("With anything")}));
  addField<Desktop>(section, "stuck_after");
  addField<Desktop>(section, "dt");
  FieldOptions record;
  record.unit = tr("steps");
  record.singularUnit = tr("step");
  addField<Desktop>(section, "record_every", record);
}

void SettingsPage::addPeopleSection(const sim2d::Registries& registries) {
  FormSection* section = addSection(tr("People"));
  addField<Desktop>(section, "model", withNames(registries.models.names(), tr("sfm (default)")));
  addField<Desktop>(section, "route",
                    withLabels({tr("Around walls"), tr("Straight, as in HuNavSim")}));
  addField<Desktop>(section, "obstacle_points",
                    withLabels({tr("Nearest wall points"), tr("Rays, like a lidar")}));
  addField<Desktop>(section, "loop_trees", withLabels({tr("Start over when done")}));
  addField<Desktop>(
      section, "wrap_x", withPlaceholder(tr("no wrapping"), [](const QString& text) {
        const auto ends = listFromText(text);
        const bool fine = ends && (ends->empty() || (ends->size() == 2 && (*ends)[0] < (*ends)[1]));
        return fine ? QString() : tr("Two x values in metres, ascending, separated by a comma");
      }));
}

/// The distribution of a quantity, and the parameters of its kind.
void SettingsPage::addVariationSection() {
  addField<Variation>(addSection(tr("Variation between seeds")), "preset",
                      withLabels({tr("None (default)"), tr("Light"), tr("Strong")}));
  FormSection* section = addFold(tr("Varied quantities"));
  const QStringList kinds = {tr("not varied"), tr("normal"), tr("uniform")};
  for (std::size_t i = 0; i < sim2d::kVariedCount; ++i) {
    const auto quantity = static_cast<sim2d::VariationQuantity>(i);
    const std::string key = sim2d::variationInfo(quantity).key;
    addField<Variation>(section, key + ".kind", withLabels(kinds, tr("as above")));
    const auto row = [&](const char* name, double sim2d::Spread::*member,
                         std::vector<sim2d::SpreadKind> of) {
      const auto spread = [quantity](const Entity& entity) {
        return sim2d::spreadOf(desktop(entity).variation, quantity);
      };
      FieldOptions look;
      look.fallback = [spread, member](const Entity& entity) {
        return base::ParameterValue(spread(entity).*member);
      };
      look.visible = [spread, member, of = std::move(of)](const std::vector<Entity>& shown) {
        const sim2d::Spread counts = spread(shown.front());  // An infinite limit is not shown.
        return std::isfinite(counts.*member) &&
               std::find(of.begin(), of.end(), counts.kind) != of.end();
      };
      addField<Variation>(section, key + "." + name, look);
    };
    using sim2d::SpreadKind;
    row("sd", &sim2d::Spread::sd, {SpreadKind::Normal});
    row("half_width", &sim2d::Spread::halfWidth, {SpreadKind::Uniform});
    row("min", &sim2d::Spread::least, {SpreadKind::Normal, SpreadKind::Uniform});
    row("max", &sim2d::Spread::most, {SpreadKind::Normal, SpreadKind::Uniform});
  }
}

void SettingsPage::addCardSection() {
  FormSection* section = addSection(tr("Scenario card"));
  section->setOpen(false);
  for (const auto& field : sim2d::fieldsOf<Card>()) {
    FieldOptions options;
    if (field.spec.key == "difficulty") {
      options = withLabels({tr("Easy"), tr("Normal"), tr("Hard")}, tr("not stated"));
    }
    addField<Card>(section, field.spec.key, options);
  }
}

void SettingsPage::addModelSection(const sim2d::Registries& registries) {
  FormSection* section = addSection(tr("Model parameters"));
  section->setOpen(false);  // Up to 24 rows that are rarely changed.
  const ParameterOwner owner = modelsOf(registries);
  addParameterRows(section, owner, tr("Parameters that are unknown to the model or not numbers"));
  addRefresh([section, owner](const std::vector<Entity>& shown) {
    const std::string model = owner.name(shown.front());
    const auto specs = owner.known.find(model);
    section->setVisible((specs != owner.known.end() && !specs->second.empty()) ||
                        !owner.given(shown.front()).empty());
    section->setNote(QString::fromStdString(model));
  });
}

void SettingsPage::addMeasureSection() {
  FormSection* section = addSection(tr("Measurement"));
  const auto moment = [&](const char* key, const QString& usual,
                          std::string metrics::Window::*member) {
    addField<Metrics>(section, key, withPlaceholder(usual, [member](const QString& text) {
                        metrics::Window wanted;
                        if (!text.isEmpty()) {
                          wanted.*member = text.toStdString();
                        }
                        const auto wrong = metrics::windowError(wanted);
                        return wrong ? QString::fromStdString(wrong->message) : QString();
                      }));
  };
  moment("from", tr("start"), &metrics::Window::from);
  moment("until", tr("end"), &metrics::Window::until);
  addField<Metrics>(section, "frequency");
  addField<Metrics>(section, "tag", withPlaceholder(QStringLiteral("exp_1")));
  addField<Metrics>(section, "run_id");
  addField<Metrics>(section, "file", withPlaceholder(tr("all metrics")));
  addRow(section, thresholdsField(), withPlaceholder(tr("defaults"), thresholdsProblem));
}

void SettingsPage::addFileSection() {
  FormSection* section = addSection(tr("Simulator and map"));
  addField<ScenarioSettings>(
      section, "simulator",
      withNames({"Gazebo Classic", "Gazebo Fortress", "Isaac Sim", "Webots"}, tr("not specified")));
  addField<ScenarioSettings>(section, "map", withPlaceholder(tr("none")));
  auto* worlds = secondaryLabel({}, this);
  worlds->setWordWrap(true);
  section->addRow(tr("Worlds"), worlds);
  addRefresh([section, worlds](const std::vector<Entity>& shown) {
    const auto& simulator = std::get<ScenarioSettings>(shown.front()).simulator;
    const QString known = worldsOf(QString::fromStdString(simulator.value_or(std::string())));
    worlds->setText(known);
    section->setRowVisible(worlds, !known.isEmpty());
  });
  addField<Desktop>(section, "map_file", withPlaceholder(tr("automatic")));
  addField<Desktop>(section, "map_rule",
                    withLabels({tr("humble (default)"), QStringLiteral("main")}));
  addField<ScenarioSettings>(section, "publish_people", withLabels({tr("Publish people")}));
}

}  // namespace editor
