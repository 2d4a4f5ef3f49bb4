#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/panels/EntityPages.h"
#include "editor/run/SimulationRunner.h"
#include "metrics/Samples.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/Runner.h"
#include "sim2d/world/World.h"

namespace editor {

namespace {

using Desktop = sim2d::DesktopSettings;
using Metrics = sim2d::MetricsSettings;
using Variation = sim2d::VariationSettings;

template <class AnyEntity>
auto& desktop(AnyEntity& entity) {
  return std::get<ScenarioSettings>(entity).desktop;
}

/// Those of the model that people have who choose none of their own.
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
    const auto own = std::find_if(all.begin(), all.end(), isModel(entity));
    return own == all.end() ? sim2d::ParameterTexts() : own->second;
  };
  owner.give = [isModel, name = owner.name](Entity& entity, sim2d::ParameterTexts texts) {
    auto& all = desktop(entity).modelParameters;
    const auto own = std::find_if(all.begin(), all.end(), isModel(entity));
    if (texts.empty()) {
      all.erase(std::remove_if(all.begin(), all.end(), isModel(entity)), all.end());
    } else if (own != all.end()) {
      own->second = std::move(texts);
    } else {
      all.emplace_back(name(entity), std::move(texts));
    }
  };
  return owner;
}

EntityField thresholdsField() {
  return textField(
      QObject::tr("Thresholds"), QObject::tr("Of metrics, such as name=value, name=value"),
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
  return numbers ? QString() : QObject::tr("name=number, with commas between them");
}

/// Worlds that HuNavSim has for a simulator; a map of another name needs one of its own there.
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
  addFileSection();
  addNewFields<Desktop>();
  addNewFields<Variation>();
  addNewFields<Metrics>();
  addNewFields<ScenarioSettings>({"yaml_base_name"});
}

void SettingsPage::addRunSection() {
  FormSection* section = addSection(tr("Run"));
  addField<Desktop>(section, "seed");
  FieldLook duration;
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
                    inWords({tr("No (default)"), tr("With people"), tr("With anything")}));
  addField<Desktop>(section, "stuck_after");
  addField<Desktop>(section, "dt");
  FieldLook record;
  record.unit = tr("steps");
  record.unitOfOne = tr("step");
  addField<Desktop>(section, "record_every", record);
}

void SettingsPage::addPeopleSection(const sim2d::Registries& registries) {
  FormSection* section = addSection(tr("People"));
  addField<Desktop>(section, "model", oneOf(registries.models.names(), tr("sfm (default)")));
  addField<Desktop>(section, "route",
                    inWords({tr("Around walls"), tr("Straight, as the original")}));
  addField<Desktop>(section, "obstacle_points",
                    inWords({tr("Nearest points of walls"), tr("Rays, as a laser")}));
  addField<Desktop>(section, "loop_trees", inWords({tr("Start over when done")}));
  addField<Desktop>(section, "wrap_x", emptyAs(tr("no ring"), [](const QString& text) {
                      const auto ends = listFromText(text);
                      const bool fine =
                          ends && (ends->empty() || (ends->size() == 2 && (*ends)[0] < (*ends)[1]));
                      return fine ? QString()
                                  : tr("Two values of x in metres, ascending, with a comma "
                                       "between them");
                    }));
}

/// What is drawn of a quantity, and the numbers of the drawing that counts.
void SettingsPage::addVariationSection() {
  addField<Variation>(addSection(tr("Differences from seed to seed")), "preset",
                      inWords({tr("Not at all (default)"), tr("A little"), tr("Much")}));
  FormSection* section = addFold(tr("What differs"));
  const QStringList kinds = {tr("not drawn"), tr("normal"), tr("uniform")};
  for (std::size_t i = 0; i < sim2d::kVariedCount; ++i) {
    const auto quantity = static_cast<sim2d::Varied>(i);
    const std::string key = sim2d::variedQuantity(quantity).key;
    addField<Variation>(section, key + ".kind", inWords(kinds, tr("as above")));
    const auto row = [&](const char* name, double sim2d::Spread::*member,
                         std::vector<sim2d::SpreadKind> of) {
      const auto spread = [quantity](const Entity& entity) {
        return sim2d::spreadOf(desktop(entity).variation, quantity);
      };
      FieldLook look;
      look.fallback = [spread, member](const Entity& entity) {
        return base::ParameterValue(spread(entity).*member);
      };
      look.visible = [spread, member, of = std::move(of)](const std::vector<Entity>& shown) {
        const sim2d::Spread counts = spread(shown.front());  // without a limit there is no number
        return std::isfinite(counts.*member) &&
               std::find(of.begin(), of.end(), counts.kind) != of.end();
      };
      addField<Variation>(section, key + "." + name, look);
    };
    using Kind = sim2d::SpreadKind;
    row("sd", &sim2d::Spread::sd, {Kind::Normal});
    row("half_width", &sim2d::Spread::halfWidth, {Kind::Uniform});
    row("min", &sim2d::Spread::least, {Kind::Normal, Kind::Uniform});
    row("max", &sim2d::Spread::most, {Kind::Normal, Kind::Uniform});
  }
}

void SettingsPage::addModelSection(const sim2d::Registries& registries) {
  FormSection* section = addSection(tr("Parameters of the model"));
  section->setOpen(false);  // up to 24 rows that few change
  const ParameterOwner owner = modelsOf(registries);
  addParameterRows(section, owner,
                   tr("Parameters that the model does not have or that are no numbers"));
  addRefresh([section, owner](const std::vector<Entity>& shown) {
    const std::string model = owner.name(shown.front());
    const auto specs = owner.known.find(model);
    section->setVisible((specs != owner.known.end() && !specs->second.empty()) ||
                        !owner.given(shown.front()).empty());
    section->setNote(QString::fromStdString(model));
  });
}

void SettingsPage::addMeasureSection() {
  FormSection* section = addSection(tr("Measuring"));
  const auto moment = [&](const char* key, const QString& usual,
                          std::string metrics::Window::*member) {
    addField<Metrics>(section, key, emptyAs(usual, [member](const QString& text) {
                        metrics::Window wanted;
                        if (!text.isEmpty()) {
                          wanted.*member = text.toStdString();
                        }
                        const auto wrong = metrics::windowProblem(wanted);
                        return wrong ? QString::fromStdString(wrong->message) : QString();
                      }));
  };
  moment("from", tr("begin"), &metrics::Window::from);
  moment("until", tr("end"), &metrics::Window::until);
  addField<Metrics>(section, "frequency");
  addField<Metrics>(section, "tag", emptyAs(QStringLiteral("exp_1")));
  addField<Metrics>(section, "run_id");
  addField<Metrics>(section, "file", emptyAs(tr("all metrics")));
  addRow(section, thresholdsField(), emptyAs(tr("the usual ones"), thresholdsProblem));
}

void SettingsPage::addFileSection() {
  FormSection* section = addSection(tr("Simulator and map"));
  addField<ScenarioSettings>(
      section, "simulator",
      oneOf({"Gazebo Classic", "Gazebo Fortress", "Isaac Sim", "Webots"}, tr("not said")));
  addField<ScenarioSettings>(section, "map", emptyAs(tr("none")));
  auto* worlds = secondaryLabel({}, this);
  worlds->setWordWrap(true);
  section->addRow(tr("Its worlds"), worlds);
  addRefresh([section, worlds](const std::vector<Entity>& shown) {
    const auto& simulator = std::get<ScenarioSettings>(shown.front()).simulator;
    const QString known = worldsOf(QString::fromStdString(simulator.value_or(std::string())));
    worlds->setText(known);
    section->setRowVisible(worlds, !known.isEmpty());
  });
  addField<Desktop>(section, "map_file", emptyAs(tr("looked for")));
  addField<Desktop>(section, "map_rule", inWords({tr("humble (default)"), QStringLiteral("main")}));
  addField<ScenarioSettings>(section, "publish_people", inWords({tr("Publish people")}));
}

}  // namespace editor
