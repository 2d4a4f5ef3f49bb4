#include <QtTest>

#include "editor/canvas/Tool.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Form.h"
#include "editor/panels/properties/EntityPages.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioFile.h"

using base::ParameterType;
using editor::Entity;
using editor::EntityKind;
using editor::NumberField;
using editor::ScenarioDocument;

namespace {

/// A number of a key, written into an entity of its kind.
struct Case {
  EntityKind kind = EntityKind::None;
  std::string key;
  double value = 0.0;
  std::function<void(Entity&)> write;
};

template <class T>
EntityKind kindOfKeys() {
  using Settings = std::tuple<sim2d::ScenarioSettings, sim2d::DesktopSettings,
                              sim2d::MetricsSettings, sim2d::ScenarioCard>;
  if constexpr (std::is_same_v<T, sim2d::Robot> || std::is_same_v<T, sim2d::LidarSettings> ||
                std::is_same_v<T, sim2d::DetectorSettings> ||
                std::is_same_v<T, sim2d::OdometrySettings> ||
                std::is_same_v<T, sim2d::LocalizationSettings> ||
                std::is_same_v<T, sim2d::BatterySettings>) {
    return EntityKind::Robot;
  } else if constexpr (std::is_same_v<T, sim2d::Obstacle>) {
    return EntityKind::Obstacle;
  } else if constexpr (std::is_same_v<T, sim2d::Door>) {
    return EntityKind::Door;
  } else if constexpr (std::is_same_v<T, sim2d::Area>) {
    return EntityKind::Area;
  } else if constexpr (std::is_same_v<T, sim2d::Dock>) {
    return EntityKind::Dock;
  } else {
    return std::is_same_v<T, std::tuple_element_t<0, Settings>> ||
                   std::is_same_v<T, std::tuple_element_t<1, Settings>> ||
                   std::is_same_v<T, std::tuple_element_t<2, Settings>> ||
                   std::is_same_v<T, std::tuple_element_t<3, Settings>>
               ? EntityKind::Scenario
               : EntityKind::Human;
  }
}

/// Both ends of the range, or what is near and far where it has none, and something inside.
std::vector<double> samples(const base::ParameterSpec& spec, bool is64Bit) {
  const base::Range& range = spec.range;
  if (spec.type == ParameterType::Integer) {
    const double most = is64Bit ? 9007199254740991.0 : 2147483647.0;
    return {std::max(range.low, -2147483647.0), std::min(range.high, most),
            range.contains(17.0) ? 17.0 : 2.0};
  }
  const double low = std::isfinite(range.low) ? range.low : -12345.75;
  const double high = std::isfinite(range.high) ? range.high : 987654.5;
  const double inside = range.contains(4.5) ? 4.5 : 0.5 * (low + high);
  return {range.excludesLow ? low + 0.000125 : low, high, inside,
          range.contains(0.015625) ? 0.015625 : low};
}

/// Those that the pages show in their own way.
const std::set<std::string>& shownOtherwise() {
  static const std::set<std::string> kKeys = {
      "id", "group_id", "skin", "goals", "footprint_x", "footprint_y", "x",
      "y",  "h",        "x1",   "y1",    "x2",          "y2",          "yaml_base_name"};
  return kKeys;
}

template <class T>
bool isShownOtherwise(const std::string& key) {
  return editor::rowName<T>(key) == key && shownOtherwise().count(key) > 0;
}

template <class T>
void addCases(std::vector<Case>& cases) {
  for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>()) {
    const bool isInteger = field.spec.type == ParameterType::Integer;
    if (field.isStructure() || isShownOtherwise<T>(field.spec.key) ||
        (!isInteger && field.spec.type != ParameterType::Number)) {
      continue;
    }
    for (const double value : samples(field.spec, field.is64Bit)) {
      cases.push_back({kindOfKeys<T>(), editor::rowName<T>(field.spec.key), value,
                       [&field, value, isInteger](Entity& e) {
                         field.assign(editor::partOf<T>(e),
                                      isInteger
                                          ? base::ParameterValue(static_cast<long long>(value))
                                          : base::ParameterValue(value));
                       }});
    }
  }
}

std::vector<Case> allCases() {
  std::vector<Case> cases;
  addCases<sim2d::Human>(cases);
  addCases<sim2d::Behavior>(cases);
  addCases<sim2d::PersonExtension>(cases);
  addCases<sim2d::Robot>(cases);
  addCases<sim2d::LidarSettings>(cases);
  addCases<sim2d::DetectorSettings>(cases);
  addCases<sim2d::OdometrySettings>(cases);
  addCases<sim2d::LocalizationSettings>(cases);
  addCases<sim2d::BatterySettings>(cases);
  addCases<sim2d::Obstacle>(cases);
  addCases<sim2d::Door>(cases);
  addCases<sim2d::Area>(cases);
  addCases<sim2d::Dock>(cases);
  addCases<sim2d::DesktopSettings>(cases);
  addCases<sim2d::MetricsSettings>(cases);
  addCases<sim2d::ScenarioCard>(cases);
  return cases;
}

/// One of each kind.
sim2d::Scenario oneOfEach() {
  sim2d::Scenario scenario;
  sim2d::Human ana;
  ana.key = {EntityKind::Human, 1};
  ana.name = "Ana";
  ana.id = 1;
  ana.behavior.configuration = sim2d::Configuration::Custom;
  scenario.humans = {ana};
  sim2d::Robot robot;
  robot.key = {EntityKind::Robot, 2};
  robot.name = "robot";
  scenario.robots = {robot};
  sim2d::Obstacle box;
  box.key = {EntityKind::Obstacle, 3};
  box.name = "box";
  scenario.obstacles = {box};
  sim2d::Door door;
  door.key = {EntityKind::Door, 4};
  door.name = "door";
  door.to = base::Vec2(1.0, 0.0);
  scenario.doors = {door};
  sim2d::Area area;
  area.key = {EntityKind::Area, 5};
  area.name = "area";
  area.kind = sim2d::AreaKind::Source;
  area.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}};
  scenario.areas = {area};
  sim2d::Dock dock;
  dock.key = {EntityKind::Dock, 6};
  dock.name = "dock";
  scenario.docks = {dock};
  return scenario;
}

editor::EntityId idOfKind(EntityKind kind) {
  switch (kind) {
    case EntityKind::Human:
      return {kind, 1};
    case EntityKind::Robot:
      return {kind, 2};
    case EntityKind::Obstacle:
      return {kind, 3};
    case EntityKind::Door:
      return {kind, 4};
    case EntityKind::Area:
      return {kind, 5};
    case EntityKind::Dock:
      return {kind, 6};
    default:
      return editor::kSettingsId;
  }
}

void openFolds(const QWidget& form) {
  for (editor::FormSection* section : form.findChildren<editor::FormSection*>()) {
    section->setOpen(true);
  }
}

}  // namespace

/// Forms made from the tables of keys.
class FieldFormsTest : public QObject {
  Q_OBJECT

 private:
  ScenarioDocument document_;
  std::unique_ptr<editor::PropertyPanel> panel_;

  template <class T>
  void findRows(QStringList& missing, QStringList& withoutHelp) {
    const editor::PropertyPage* page = panel_->page(kindOfKeys<T>());
    for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>()) {
      const QString key = QString::fromStdString(editor::rowName<T>(field.spec.key));
      if (field.spec.help.empty()) {
        withoutHelp << key;
      }
      const bool isOther = field.isStructure() || isShownOtherwise<T>(field.spec.key) ||
                           (std::is_same_v<T, sim2d::Obstacle> && key == QLatin1String("kind"));
      const auto* row = page->findChild<QWidget*>(key);
      if (!isOther && (row == nullptr || !row->toolTip().contains(editor::helpOf(field.spec)))) {
        missing << key;
      }
    }
  }

 private Q_SLOTS:
  void initTestCase() {
    document_.load(oneOfEach());
    panel_ = std::make_unique<editor::PropertyPanel>(document_, editor::Theme::light());
    panel_->resize(320, 700);  // as in the window
    openFolds(*panel_);
    panel_->show();
  }
  void cleanupTestCase() { panel_.reset(); }

  void key_ofATable_hasARowWithItsHelp() {
    QStringList missing;
    QStringList withoutHelp;
    findRows<sim2d::ScenarioSettings>(missing, withoutHelp);
    findRows<sim2d::Human>(missing, withoutHelp);
    findRows<sim2d::Behavior>(missing, withoutHelp);
    findRows<sim2d::PersonExtension>(missing, withoutHelp);
    findRows<sim2d::Robot>(missing, withoutHelp);
    findRows<sim2d::LidarSettings>(missing, withoutHelp);
    findRows<sim2d::DetectorSettings>(missing, withoutHelp);
    findRows<sim2d::OdometrySettings>(missing, withoutHelp);
    findRows<sim2d::LocalizationSettings>(missing, withoutHelp);
    findRows<sim2d::BatterySettings>(missing, withoutHelp);
    findRows<sim2d::Obstacle>(missing, withoutHelp);
    findRows<sim2d::Door>(missing, withoutHelp);
    findRows<sim2d::Area>(missing, withoutHelp);
    findRows<sim2d::Dock>(missing, withoutHelp);
    findRows<sim2d::DesktopSettings>(missing, withoutHelp);
    findRows<sim2d::MetricsSettings>(missing, withoutHelp);
    findRows<sim2d::ScenarioCard>(missing, withoutHelp);
    QCOMPARE(missing.join(QStringLiteral(" ")), QString());
    QCOMPARE(withoutHelp.join(QStringLiteral(" ")), QString());
  }

  void number_ofTheFile_isShownAsItIs_data() {
    QTest::addColumn<int>("index");
    const std::vector<Case> cases = allCases();
    for (std::size_t i = 0; i < cases.size(); ++i) {
      QTest::addRow("%d %s %s", static_cast<int>(cases[i].kind), cases[i].key.c_str(),
                    base::formatDouble(cases[i].value).c_str())
          << static_cast<int>(i);
    }
  }
  void number_ofTheFile_isShownAsItIs() {
    static const std::vector<Case> kCases = allCases();
    QFETCH(int, index);
    const Case& test = kCases[static_cast<std::size_t>(index)];
    const editor::EntityId id = idOfKind(test.kind);
    document_.load(oneOfEach());
    Entity entity = *document_.entity(id);
    test.write(entity);
    editor::pushEdit(document_, {entity}, QStringLiteral("Write"), editor::Merge::Never);
    document_.setSelection({});
    if (id != editor::kSettingsId) {
      document_.setSelection({id});
    }
    auto* field = panel_->currentPage()->findChild<NumberField*>(QString::fromStdString(test.key));
    QVERIFY(field != nullptr);
    QCOMPARE(field->value(), test.value);
    const QString digits = field->text().section(QLatin1Char(' '), 0, 0);
    QCOMPARE(base::parseDouble(digits.toStdString()).value_or(-1.0), test.value);
    const int steps = document_.undoStack().count();
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(document_.undoStack().count(), steps);
    QVERIFY(*document_.entity(id) == entity);
  }

  void key_newInTheTable_isInTheForm() {
    sim2d::FieldTables tables = sim2d::fieldTables();
    auto& keys = std::get<sim2d::Fields<sim2d::Robot>>(tables);
    const auto after = std::find_if(keys.begin(), keys.end(),
                                    [](const auto& each) { return each.spec.key == "max_vel"; });
    keys.insert(after + 1,
                sim2d::field("wheel_base", &sim2d::Robot::mass, "Distance between its `wheels`",
                             {"Wheels", 3, 0.05, 1.0}, "m", {0.1, 2.0})
                    .defaultsTo(0.75));
    keys.push_back(sim2d::field("tow_hook", &sim2d::Robot::planner, "What it pulls"));
    sim2d::Scenario scenario = oneOfEach();
    document_.load(scenario);
    editor::RobotPage page(document_, tables);
    page.setTargets({scenario.robots[0].key});
    openFolds(page);
    page.resize(480, 900);  // with room for units
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    auto* wheels = page.findChild<NumberField*>(QStringLiteral("wheel_base"));
    QVERIFY(wheels != nullptr);
    QCOMPARE(wheels->accessibleName(), QStringLiteral("Wheels"));
    QTRY_COMPARE(wheels->text(), QStringLiteral("0.750 m"));
    QCOMPARE(wheels->toolTip(), QStringLiteral("Distance between its wheels\n0.100 to 2.000 m"));
    const auto heightOf = [&page](const char* key) {
      const auto* row = page.findChild<QWidget*>(QLatin1String(key));
      return row->mapTo(&page, QPoint()).y();
    };
    QVERIFY(heightOf("max_vel") < heightOf("wheel_base"));
    QVERIFY(heightOf("wheel_base") < heightOf("max_acc"));
    auto* hook = page.findChild<editor::TextField*>(QStringLiteral("tow_hook"));
    QVERIFY(hook != nullptr);
    QCOMPARE(hook->accessibleName(), QStringLiteral("Tow hook"));
    wheels->setFocus();
    wheels->selectAll();
    QTest::keyClicks(wheels, QStringLiteral("1.25"));
    QTest::keyClick(wheels, Qt::Key_Return);
    QCOMPARE(document_.scenario().robots[0].mass, std::optional(1.25));
    wheels->selectAll();
    QTest::keyClicks(wheels, QStringLiteral("2.25"));
    QTest::keyClick(wheels, Qt::Key_Tab);
    QCOMPARE(document_.scenario().robots[0].mass, std::optional(1.25));
  }

  /// Paths that differ only in their beginning look the same, unless they are edited.
  void path_tooLong_showsItsEnd() {
    editor::applyTheme(editor::Theme::light());  // it is also that of tooltips
    QWidget form;
    editor::TextField field(&form);
    QLineEdit other(&form);
    field.setGeometry(0, 0, 120, 24);
    field.setHint(QStringLiteral("The parameter file"));
    other.setGeometry(0, 30, 120, 24);
    form.show();
    QVERIFY(QTest::qWaitForWindowActive(&form));
    other.setFocus();
    const auto imageOf = [&field](const char* path) {
      field.show(QString::fromUtf8(path));
      return field.grab().toImage();
    };
    const QImage one = imageOf("/home/one/a/folder/that/is/far/away/params/nav2.yaml");
    QVERIFY(imageOf("/home/two/a/folder/that/is/far/away/params/nav2.yaml") == one);
    QVERIFY(imageOf("/home/one/a/folder/that/is/far/away/params/nav3.yaml") != one);
    QVERIFY(imageOf("no path, one that is longer than its field") !=
            imageOf("no path, two that is longer than its field"));
    const QString path = QStringLiteral("/home/one/a/folder/that/is/far/away/params/nav2.yaml");
    field.show(path);
    QHelpEvent help(QEvent::ToolTip, QPoint(5, 5), field.mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(&field, &help);
    QVERIFY2(QToolTip::text().contains(path), qPrintable(QToolTip::text()));
    QVERIFY(QToolTip::text().contains(QStringLiteral("The parameter file")));
    field.setFocus();
    QVERIFY(field.grab().toImage() != one);
  }

  /// Whatever the width and the font; the number itself keeps all digits.
  /// A text that cannot be used is not discarded in silence.
  void text_refused_isExplained() {
    editor::TextField field;
    field.setCheck([](const QString& text) {
      return text == QStringLiteral("good") ? QString() : QStringLiteral("Only good is good");
    });
    field.show(QStringLiteral("old"));
    QWidget* const window = &field;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(&field));
    QToolTip::hideText();
    QSignalSpy edited(&field, &editor::TextField::edited);
    field.selectAll();
    QTest::keyClicks(&field, QStringLiteral("bad"));
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(field.text(), QStringLiteral("old"));
    QTRY_COMPARE(QToolTip::text(), QStringLiteral("Not used: Only good is good"));
    QCOMPARE(edited.count(), 0);
    QToolTip::hideText();
    field.selectAll();
    QTest::keyClicks(&field, QStringLiteral("good"));
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(edited.count(), 1);
  }

  /// Not a number, or none of the range: the tip says which is allowed, with the unit.
  void number_refused_isExplained_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("tip");
    QTest::newRow("outside") << QStringLiteral("-1")
                             << QStringLiteral("Not used: must be 0.10 to 1.00 m");
    QTest::newRow("no number") << QStringLiteral("abc")
                               << QStringLiteral("Not used: not a number; must be 0.10 to 1.00 m");
  }
  void number_refused_isExplained() {
    QFETCH(QString, typed);
    QFETCH(QString, tip);
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* field = new NumberField({0.1, 1.0, 2, 0.05}, QStringLiteral("m"), &window);
    auto* next = new QLineEdit(&window);
    layout->addWidget(field);
    layout->addWidget(next);
    field->show(0.35, false);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QSignalSpy edited(field, &NumberField::edited);
    const auto said = [] { return QToolTip::text().replace(QLatin1Char('\n'), QLatin1Char(' ')); };
    for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Tab}) {
      QToolTip::hideText();
      QTRY_VERIFY(!QToolTip::isVisible());
      field->setFocus();
      field->selectAll();
      QTest::keyClicks(field, typed);
      QTest::keyClick(field, end);
      QTRY_COMPARE(said(), tip);
      QCOMPARE(field->value(), 0.35);
    }
    QToolTip::hideText();
    QTRY_VERIFY(!QToolTip::isVisible());
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.5"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(edited.count(), 1);
    QTest::keyClick(field, Qt::Key_Tab);
    QCoreApplication::processEvents();
    QVERIFY(!QToolTip::isVisible());
  }

  /// The unit is worth more than zeros at the end.
  void unit_ofALongNumber_staysBeforeZeros() {
    NumberField field({0.0, 1000.0, 2, 0.1}, QStringLiteral("m/s"));
    field.QWidget::show();
    QVERIFY(QTest::qWaitForWindowExposed(&field));
    const QLineEdit& line = *field.findChild<QLineEdit*>();
    field.show(99.0, false);
    field.resize(300, 24);
    QTRY_COMPARE(line.text(), QStringLiteral("99.00 m/s"));
    const int spare = line.width() - line.fontMetrics().horizontalAdvance(line.text());
    field.resize(300 - spare, 24);  // without the margins of the text
    QTRY_VERIFY2(
        line.text() == QStringLiteral("99 m/s") || line.text() == QStringLiteral("99.0 m/s"),
        qPrintable(line.text()));
    QCOMPARE(field.value(), 99.0);
  }

  void zero_hasNoSign() {
    NumberField field({-180.0, 180.0, 1, 5.0}, QStringLiteral("°"));
    field.show(-0.0, false);
    QCOMPARE(field.text(), QStringLiteral("0.0°"));
    QCOMPARE(editor::headingText(-1e-5), QStringLiteral("0.0°"));
    QCOMPARE(editor::headingText(-0.5 * base::kPi), QStringLiteral("-90.0°"));
    QCOMPARE(editor::placeText({-0.001, -1.5}), QStringLiteral("0.00, -1.50 m"));
  }

  /// Of several values none is marked.
  void slider_ofSeveralValues_hasNoHandle() {
    NumberField field({0.0, 2.0, 2, 0.1}, QStringLiteral("m/s"));
    editor::LinkedSlider slider(field, 2.0);
    slider.resize(120, 24);
    const auto picture = [&slider] { return slider.grab().toImage(); };
    field.show(2.0, false);
    const QImage high = picture();
    field.show(1.0, false);
    QVERIFY(picture() != high);
    field.showMixed();
    const QImage mixed = picture();
    field.show(0.5, false);
    const QImage single = picture();
    QVERIFY(mixed != single);
    field.showMixed();
    QCOMPARE(picture(), mixed);  // whatever the field had before
  }

  void digits_inANarrowField_areNotCut() {
    NumberField field({-1e6, 1e6, 2, 0.1}, QStringLiteral("m/s²"));
    field.QWidget::show();
    QVERIFY(QTest::qWaitForWindowExposed(&field));
    QSignalSpy edited(&field, &NumberField::edited);
    for (const double points : {9.0, 12.0, 16.0}) {
      QFont font = field.font();
      font.setPointSizeF(points);
      field.setFont(font);
      for (const int width : {300, 130, 90, 72, 60}) {
        field.resize(width, 24);
        for (const double value : {1.3, 0.123456, -123.456789, -98765.4321}) {
          field.show(value, false);
          QCoreApplication::processEvents();
          const QLineEdit& line = *field.findChild<QLineEdit*>();
          const int needed = line.fontMetrics().horizontalAdvance(line.text());
          const QString sizes = QStringLiteral("'%1' needs %2 of %3 px")
                                    .arg(line.text())
                                    .arg(needed)
                                    .arg(line.width() - 4);
          const bool isShortest =
              !line.text().contains(QLatin1Char('.')) && !line.text().contains(QLatin1Char('m'));
          QVERIFY2(needed <= line.width() - 4 || isShortest, qPrintable(sizes));
          QCOMPARE(field.value(), value);
          if (width == 300 && points < 10.0) {
            QCOMPARE(line.text(),
                     QString::number(value, 'g', 9) +
                         (value == 1.3 ? QStringLiteral("0 m/s²") : QStringLiteral(" m/s²")));
          }
          field.setFocus();
          QTest::keyClick(&field, Qt::Key_Return);
          QCOMPARE(field.value(), value);
        }
      }
    }
    QCOMPARE(edited.count(), 0);
  }

  void arrows_atAnOpenEnd_stayInside() {
    NumberField field({0.0, 100.0, 2, 0.1, true}, QStringLiteral("m"));
    field.show(0.25, false);
    field.stepBy(-1);
    QCOMPARE(field.value(), 0.15);
    field.stepBy(-3);
    QCOMPARE(field.value(), 0.01);
    QString zero = QStringLiteral("0");
    int position = 0;
    QVERIFY(field.validate(zero, position) != QValidator::Acceptable);
    QVERIFY(field.toolTip().startsWith(QStringLiteral("above 0.00")));
  }
};

QTEST_MAIN(FieldFormsTest)
#include "tst_FieldForms.moc"
