#include <QtTest>

#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Form.h"
#include "editor/panels/properties/EntityPages.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioFile.h"

using editor::EntityKind;
using editor::NumberField;
using editor::ScenarioDocument;

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

sim2d::Scenario oneRobot() {
  sim2d::Scenario scenario;
  sim2d::Robot robot;
  robot.key = {EntityKind::Robot, 1};
  robot.name = "robot";
  scenario.robots = {robot};
  return scenario;
}

base::ParameterSpec specOf(const char* key, const char* unit, double most, double fallback,
                           const char* help) {
  base::ParameterSpec spec;
  spec.key = key;
  spec.unit = unit;
  spec.range = {0.0, most};
  spec.fallback = fallback;
  spec.help = help;
  return spec;
}

/// The program's, with a planner that nobody knows.
sim2d::Registries withDogs() {
  sim2d::Registries registries = sim2d::builtinRegistries();
  registries.planners.add(
      "dog", {specOf("tail_wag", "1/s", 8.0, 2.5, "How often its `tail` goes")},
      [](const sim2d::PlannerSetup&) {
        return base::Result<std::shared_ptr<sim2d::Planner>>(base::Diagnostics{});
      });
  return registries;
}

void type(NumberField& field, const char* digits) {
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, QLatin1String(digits));
  QTest::keyClick(&field, Qt::Key_Return);
}

void clear(editor::TextField& field) {
  field.setFocus();
  field.selectAll();
  QTest::keyClick(&field, Qt::Key_Delete);
  QTest::keyClick(&field, Qt::Key_Return);
}

void openSections(const QWidget& page) {
  for (editor::FormSection* section : page.findChildren<editor::FormSection*>()) {
    section->setOpen(true);
  }
}

/// A robot's page that knows dogs.
struct DogPage {
  DogPage()
      : registries(withDogs()),
        page((document.load(oneRobot()), document), sim2d::fieldTables(), registries) {
    page.setTargets({robot().key});
    openSections(page);
    page.show();
    wag = page.findChild<NumberField*>(QStringLiteral("dog.tail_wag"));
    ahead = page.findChild<NumberField*>(QStringLiteral("pursuit.lookahead"));
    others = page.findChild<editor::TextField*>(QStringLiteral("other_parameters"));
  }
  const sim2d::Robot& robot() const { return document.scenario().robots[0]; }
  void change(const std::function<void(sim2d::Robot&)>& edit) {
    editor::pushChange<sim2d::Robot>(document, robot().key, QStringLiteral("Change"), edit);
    page.refresh();
  }
  int problems() const {
    const sim2d::Scenario& scenario = document.scenario();
    const base::Diagnostics all = sim2d::checkScenario(
        scenario, sim2d::makeSurroundings(scenario, {}), {}, sim2d::knownNames(registries));
    return static_cast<int>(std::count_if(all.begin(), all.end(), [](const auto& each) {
      return each.message.find("planner_parameters") != std::string::npos;
    }));
  }

  sim2d::Registries registries;
  ScenarioDocument document;
  editor::RobotPage page;
  NumberField* wag = nullptr;
  NumberField* ahead = nullptr;
  editor::TextField* others = nullptr;
};

}  // namespace

/// Rows made from the parameters that planners and models declare.
class ParameterRowsTest : public QObject {
  Q_OBJECT

 private:
  ScenarioDocument document_;

  void changeSettings(const std::function<void(sim2d::DesktopSettings&)>& change) {
    auto settings = std::get<editor::ScenarioSettings>(*document_.entity(editor::kSettingsId));
    change(settings.desktop);
    editor::pushEdit(document_, {settings}, QStringLiteral("Change"), editor::Merge::Never);
  }

 private Q_SLOTS:
  /// A planner that nobody knows declares a parameter: the row, the command line and the check are
  /// made from its description.
  void parameter_ofAMadeUpPlanner_isARowOfTheForm() {
    DogPage dog;
    QVERIFY(QTest::qWaitForWindowExposed(&dog.page));
    QVERIFY(dog.wag != nullptr && dog.ahead != nullptr);
    QVERIFY(dog.ahead->isVisible() && !dog.wag->isVisible());  // the usual planner is pursuit
    QCOMPARE(dog.ahead->text(), QStringLiteral("0.60 m"));
    dog.change([](sim2d::Robot& each) { each.planner = "dog"; });
    QVERIFY(dog.wag->isVisible() && !dog.ahead->isVisible());
    QCOMPARE(dog.wag->accessibleName(), QStringLiteral("Tail wag"));
    QCOMPARE(dog.wag->text(), QStringLiteral("2.50 /s"));
    QCOMPARE(dog.wag->toolTip(), QStringLiteral("How often its tail goes\n0.00 to 8.00 /s"));
    type(*dog.wag, "9");  // out of its range
    QVERIFY(dog.robot().plannerParameters.empty());
    type(*dog.wag, "4.25");
    QVERIFY(dog.robot().plannerParameters == Pairs({{"tail_wag", "4.25"}}));
    QCOMPARE(dog.problems(), 0);
    sim2d::Scenario set = dog.document.scenario();
    QVERIFY(sim2d::setValue(set, "robot.planner_parameters.tail_wag", "1.5").empty());
    dog.document.load(set);
    dog.page.refresh();
    QCOMPARE(dog.wag->value(), 1.5);
  }

  /// A text, with the quotes that files need; the program of a planner has a row when it counts.
  void parameter_text_isARowAsWell() {
    DogPage dog;
    QVERIFY(QTest::qWaitForWindowExposed(&dog.page));
    auto* const file = dog.page.findChild<editor::TextField*>(QStringLiteral("replay.file"));
    auto* const command = dog.page.findChild<editor::TextField*>(QStringLiteral("command"));
    QVERIFY(file != nullptr && command != nullptr);
    QVERIFY(!file->isVisible() && !command->isVisible());
    dog.change([](sim2d::Robot& each) {
      each.planner = "replay";
      each.plannerParameters = {{"file", "\"007\""}};
    });
    QVERIFY(file->isVisible() && !dog.others->isVisible());
    QCOMPARE(file->text(), QStringLiteral("007"));
    const auto write = [](editor::TextField& to, const char* words) {
      clear(to);
      QTest::keyClicks(&to, QLatin1String(words));
      QTest::keyClick(&to, Qt::Key_Return);
    };
    write(*file, "12");
    QVERIFY(dog.robot().plannerParameters == Pairs({{"file", "\"12\""}}));
    write(*file, "out/trajectory.csv");
    QVERIFY(dog.robot().plannerParameters == Pairs({{"file", "out/trajectory.csv"}}));
    clear(*file);
    QVERIFY(dog.robot().plannerParameters.empty());
    dog.change([](sim2d::Robot& each) { each.planner = "external"; });
    QVERIFY(command->isVisible() && !file->isVisible());
    write(*command, "python3 follow.py");
    QVERIFY(dog.robot().command == std::string("python3 follow.py"));
  }

  /// Names that the planner does not declare stay, are told by the check and can be cleared.
  void parameters_thatNoPlannerDeclares_haveARowOfText() {
    DogPage dog;
    QVERIFY(QTest::qWaitForWindowExposed(&dog.page));
    QVERIFY(dog.others != nullptr && !dog.others->isVisible());
    dog.change([](sim2d::Robot& each) {
      each.planner = "dog";
      each.plannerParameters = {{"tail_wag", "12"}, {"tial_wag", "3"}, {"bark", "yes"}};
    });
    QCOMPARE(dog.problems(), 3);
    QVERIFY(dog.others->isVisible());
    QCOMPARE(dog.others->text(), QStringLiteral("tial_wag=3, bark=yes"));
    clear(*dog.others);
    QVERIFY(dog.robot().plannerParameters == Pairs({{"tail_wag", "12"}}));
    dog.page.refresh();
    QVERIFY(!dog.others->isVisible());
    Q_EMIT dog.wag->resetRequested();
    QVERIFY(dog.robot().plannerParameters.empty());
    dog.page.refresh();
    QCOMPARE(dog.wag->value(), 2.5);
  }

  /// The same for the pedestrian model of the scenario; another model has other rows.
  void parameter_ofTheModel_isARowOfTheSettings() {
    sim2d::Registries registries = sim2d::builtinRegistries();
    registries.models.add("geese", {specOf("wing_span", "m", 3.0, 1.5, "From tip to `tip`")}, {});
    document_.load(oneRobot());
    editor::SettingsPage page(document_, registries);
    page.setTargets({editor::kSettingsId});
    page.show();
    openSections(page);
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    const auto rowOf = [&page](const std::string& model, const std::string& key) {
      return page.findChild<NumberField*>(QString::fromStdString(model + "." + key));
    };
    for (const std::string& chosen : std::vector<std::string>{"sfm", "geese", "das", "orca"}) {
      if (chosen != "sfm") {  // the usual one
        changeSettings([&](sim2d::DesktopSettings& to) { to.model = chosen; });
        page.refresh();
      }
      for (const auto& model : registries.models.entries()) {
        for (const base::ParameterSpec& each : model.parameters) {
          const NumberField* row = rowOf(model.name, each.key);
          QVERIFY2(row != nullptr, each.key.c_str());
          QCOMPARE(row->isVisible(), model.name == chosen);
          QCOMPARE(row->value(), std::get<double>(each.fallback));
          const std::string digits = row->text().section(QLatin1Char(' '), 0, 0).toStdString();
          QCOMPARE(base::parseDouble(digits), std::optional(row->value()));
          QVERIFY(row->toolTip().startsWith(editor::helpOf(each)));
        }
      }
    }
    const NumberField* span = rowOf("geese", "wing_span");
    QCOMPARE(span->accessibleName(), QStringLiteral("Wing span"));
    QCOMPARE(span->text(), QStringLiteral("1.50 m"));
    QCOMPARE(span->toolTip(), QStringLiteral("From tip to tip\n0.00 to 3.00 m"));
  }

  void parameter_ofTheModel_isEdited() {
    document_.load(oneRobot());
    const std::vector<std::pair<std::string, sim2d::ParameterTexts>> before = {
        {"sfm", {{"gamma", "0.4"}}}};  // of those who have a model of their own
    auto after = before;
    after.push_back({"orca", {{"horizon", "3.25"}}});
    changeSettings([&](sim2d::DesktopSettings& to) {
      to.model = "orca";
      to.modelParameters = before;
    });
    editor::SettingsPage page(document_);
    page.setTargets({editor::kSettingsId});
    page.show();
    openSections(page);
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    auto* horizon = page.findChild<NumberField*>(QStringLiteral("orca.horizon"));
    auto* others = page.findChild<editor::TextField*>(QStringLiteral("other_parameters"));
    const auto given = [this] { return document_.scenario().desktop.modelParameters; };
    const int steps = document_.undoStack().count();
    type(*horizon, "-1");  // out of its range
    QVERIFY(given() == before);
    type(*horizon, "3.25");
    page.refresh();
    QVERIFY(given() == after);
    QCOMPARE(document_.undoStack().count(), steps + 1);
    document_.undoStack().undo();
    page.refresh();
    QVERIFY(given() == before);
    QCOMPARE(horizon->value(), 2.0);
    document_.undoStack().redo();
    page.refresh();
    QCOMPARE(horizon->value(), 3.25);
    Q_EMIT horizon->resetRequested();
    page.refresh();
    QVERIFY(given() == before);
    QCOMPARE(horizon->value(), 2.0);
    QVERIFY(!others->isVisible());
    changeSettings([](sim2d::DesktopSettings& to) {
      to.modelParameters = {{"orca", {{"horizn", "1"}}}};
    });
    page.refresh();
    QVERIFY(others->isVisible());
    QCOMPARE(others->text(), QStringLiteral("horizn=1"));
    clear(*others);
    QVERIFY(given().empty());
  }

  void defaultNumber_afterAnotherTheme_hasItsColour() {
    editor::applyTheme(editor::Theme::light());
    NumberField field({}, QString());
    field.show(0.5, true);
    const auto* words = field.findChild<QLineEdit*>();
    for (const bool isDark : {true, false}) {
      const editor::Theme theme(isDark);
      editor::applyTheme(theme);
      QCOMPARE(words->palette().color(QPalette::Active, QPalette::Text),
               theme.palette().color(QPalette::PlaceholderText));
    }
  }
};

QTEST_MAIN(ParameterRowsTest)
#include "tst_ParameterRows.moc"
