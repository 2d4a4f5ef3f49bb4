#include <QtTest>

#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/properties/PageWidgets.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "tests/editor/SmallScenario.h"
#include "tests/support/Widgets.h"

using editor::EntityId;
using editor::NumberField;
using editor::PropertyPanel;
using editor::ScenarioDocument;

namespace {

sim2d::Human person(const char* name, int id, double speed) {
  sim2d::Human human =
      small::person(id, name, base::Vec2(id, 1.0), 0.0, sim2d::BehaviorType::Regular, {});
  human.maxVel = speed;
  return human;
}

sim2d::Scenario twoPeople() {
  sim2d::Scenario scenario;
  scenario.humans = {person("Ana", 1, 1.0), person("Ben", 2, 1.5)};
  for (int id = 1; id <= 3; ++id) {
    scenario.goals.push_back(small::goal(10 + id, id, base::Vec2(id, 5.0)));
  }
  return scenario;
}

}  // namespace

class PropertyPanelTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<PropertyPanel> panel_;

  template <class Field>
  Field* field(const QString& name) const {
    return widgets::named<Field>(*panel_->currentPage(), name);
  }
  const sim2d::Human& human(int index) const {
    return document_->scenario().humans[static_cast<std::size_t>(index)];
  }
  EntityId key(int index) const { return human(index).key; }
  void type(QWidget* widget, const QString& text) {
    widget->setFocus();
    if (auto* spin = qobject_cast<QAbstractSpinBox*>(widget)) {
      spin->selectAll();
    } else {
      static_cast<QLineEdit*>(widget)->selectAll();
    }
    QTest::keyClicks(widget, text);
  }
  void enter(QWidget* widget, const QString& text) {
    type(widget, text);
    QTest::keyClick(widget, Qt::Key_Return);
  }
  /// Selects these people, nothing for the settings.
  template <class Field>
  Field* fieldOf(std::initializer_list<int> people, const char* name) {
    std::vector<EntityId> ids;
    std::transform(people.begin(), people.end(), std::back_inserter(ids),
                   [this](int index) { return key(index); });
    document_->setSelection(ids);
    return field<Field>(QString::fromUtf8(name));
  }

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<ScenarioDocument>();
    document_->load(twoPeople());
    panel_ = std::make_unique<PropertyPanel>(*document_, editor::Theme::light());
    panel_->resize(320, 700);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
  }
  void cleanup() {
    panel_.reset();
    document_.reset();
  }

  void number_typed_changesAndUndoes() {
    auto* speed = fieldOf<NumberField>({0}, "Top speed");
    QVERIFY(speed != nullptr);
    QCOMPARE(speed->value(), 1.0);
    QCOMPARE(speed->text(), QStringLiteral("1.00 m/s"));
    enter(speed, QStringLiteral("0.85"));
    QCOMPARE(*human(0).maxVel, 0.85);
    document_->undoStack().undo();
    QCOMPARE(*human(0).maxVel, 1.0);
    QCOMPARE(speed->value(), 1.0);
  }

  void heading_longName_losesItsMiddleAndKeepsTheWholeInTheToolTip() {
    document_->setSelection({key(0)});
    editor::ElidedLabel* heading = nullptr;
    for (QLabel* label : panel_->findChildren<QLabel*>()) {
      heading = heading == nullptr ? dynamic_cast<editor::ElidedLabel*>(label) : heading;
    }
    if (heading == nullptr) {
      QFAIL("no heading");
    }
    QCOMPARE(heading->visibleText(), QStringLiteral("Ana"));
    const QString name =
        QStringLiteral("Ana ") + QString(200, QLatin1Char('n')) + QStringLiteral(" Z");
    editor::pushChange<sim2d::Human>(
        *document_, key(0), QStringLiteral("Name"),
        [&name](sim2d::Human& person) { person.name = name.toStdString(); });
    QCoreApplication::processEvents();
    QCOMPARE(panel_->width(), 320);
    QCOMPARE(heading->toolTip(), name);
    const QString shown = heading->visibleText();
    QVERIFY2(shown.contains(QChar(0x2026)) && shown.startsWith(QStringLiteral("Ana")) &&
                 shown.endsWith(QLatin1Char('Z')),
             qPrintable(shown));
    QVERIFY(heading->fontMetrics().horizontalAdvance(shown) <= heading->width());
    panel_->resize(2400, 700);
    QCoreApplication::processEvents();
    QVERIFY(heading->visibleText().size() > shown.size());
  }

  /// The panel does not scroll sideways: what is wider than it would be cut at the right.
  void pages_atTheUsualWidth_areNotCut() {
    editor::applyTheme(editor::Theme::light());
    for (const base::EntityKind kind : {base::EntityKind::Scenario, base::EntityKind::Human}) {
      document_->setSelection(kind == base::EntityKind::Human ? std::vector<EntityId>{key(0)}
                                                              : std::vector<EntityId>());
      QCoreApplication::processEvents();
      const editor::PropertyPage& page = *panel_->currentPage();
      QVERIFY2(page.minimumSizeHint().width() <= 300, page.metaObject()->className());
      QTRY_COMPARE(page.width(), page.parentWidget()->width());  // beside the bar that scrolls
      for (const QCheckBox* box : page.findChildren<QCheckBox*>()) {
        QVERIFY2(!box->isVisible() || box->width() >= box->sizeHint().width(),
                 qPrintable(box->text()));
      }
      for (const QWidget* field : page.findChildren<QWidget*>()) {
        QVERIFY(!field->isVisible() ||
                field->mapTo(&page, field->rect().topRight()).x() < page.parentWidget()->width());
      }
    }
  }

  /// A goal of the robot makes the run longer: that is told beside the duration.
  void duration_ofARobotWithAGoal_saysWhatEndsTheRun() {
    const auto says = [this](const QString& words) {
      return widgets::findIf<QLabel>(*panel_, [&words](const QLabel* label) {
               return label->isVisible() && label->text() == words;
             }) != nullptr;
    };
    const QString words = QStringLiteral("Until the robot arrives, at most 120 s");
    document_->setSelection({});
    QVERIFY(!says(words));
    sim2d::Robot robot;
    robot.name = "robot1";
    robot.goal.point = base::Vec2(4.0, 4.0);
    const EntityId id = editor::pushAdd(*document_, robot);
    document_->setSelection({id});
    QVERIFY(says(QStringLiteral("ends the run")));
    document_->setSelection({});
    QVERIFY(says(words));
    editor::pushChange<editor::ScenarioSettings>(
        *document_, editor::kSettingsId, QString(),
        [](editor::ScenarioSettings& settings) { settings.desktop.duration = 30.0; });
    QVERIFY(!says(words));
  }

  /// One scroll bar, that of the page: the rest has its room.
  void page_ofARun_isNotScrolledTwice() {
    const auto frame = std::make_shared<const sim2d::Frame>();
    panel_->resize(320, 400);
    panel_->showFrame(frame);
    QTest::qWait(50);
    int bars = 0;
    for (const QScrollBar* bar : panel_->findChildren<QScrollBar*>()) {
      bars += bar->isVisible() && bar->orientation() == Qt::Vertical ? 1 : 0;
    }
    QVERIFY2(bars <= 1, qPrintable(QString::number(bars)));
    panel_->showFrame(nullptr);
  }

  /// 1.37 m from centre to centre, of which the radii take 0.40 and 0.35 m.
  void distanceToTheRobot_isThatOfTheMetrics() {
    document_->setSelection({key(1)});
    sim2d::TraceHeader header;
    header.humans.resize(1);
    header.humans[0].id = human(1).id;
    header.humans[0].radius = 0.40;
    header.robots.resize(1);
    header.robots[0].id = -1;
    header.robots[0].radius = 0.35;
    sim2d::Frame frame;
    frame.humans.add(human(1).id, {{2.0, 1.0}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
    frame.humans.group = {-1};
    frame.humans.state = {0};
    frame.robots.add(-1, {{3.37, 1.0}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
    const auto shown = std::make_shared<const sim2d::Frame>(frame);
    const auto says = [this](const char* words) {
      return widgets::findIf<QLabel>(*panel_, [words](const QLabel* label) {
               return label->isVisible() && label->text() == QString::fromUtf8(words);
             }) != nullptr;
    };
    panel_->showFrame(shown, false, std::make_shared<const sim2d::TraceHeader>(header));
    QVERIFY(says("0.62 m, surface to surface"));
    header.wrapX = {0.0, 2.37};  // A corridor with joined ends: the robot is 1 m behind.
    panel_->showFrame(shown, false, std::make_shared<const sim2d::TraceHeader>(header));
    QVERIFY(says("0.25 m, surface to surface"));
    panel_->showFrame(nullptr);
  }

  void page_ofARecordedRun_isReadOnly() {
    auto* speed = fieldOf<NumberField>({0}, "Top speed");
    const auto later = [this] {
      return widgets::findIf<QLabel>(*panel_, [](const QLabel* label) {
               return label->isVisible() &&
                      label->text().startsWith(QStringLiteral("Changes take effect"));
             }) != nullptr;
    };
    const auto frame = std::make_shared<const sim2d::Frame>();
    panel_->showFrame(frame);
    QVERIFY(speed->isEnabled() && later());
    panel_->showFrame(frame, true);
    QVERIFY(!speed->isEnabled() && !later());
    document_->setSelection({key(1)});
    QVERIFY(!speed->isEnabled());
    panel_->showFrame(nullptr);
    QVERIFY(speed->isEnabled() && !later());
  }

  void number_stepped_mergesIntoOneCommand() {
    auto* heading = fieldOf<NumberField>({0}, "Heading");
    heading->stepUp();
    heading->stepUp();
    QCOMPARE(document_->undoStack().count(), 1);
    QVERIFY(std::abs(human(0).initPose.heading - 10.0 * base::kPi / 180.0) < 1e-12);
    document_->undoStack().undo();
    QCOMPARE(human(0).initPose.heading, 0.0);
  }

  void number_outOfRange_isMarkedAndNotTaken() {
    auto* speed = fieldOf<NumberField>({0}, "Top speed");
    type(speed, QStringLiteral("777"));
    QVERIFY(speed->property(editor::kInvalidProperty).toBool());
    panel_->setFocus();
    QTest::keyClick(speed, Qt::Key_Tab);
    QCOMPARE(*human(0).maxVel, 1.0);
    type(speed, QStringLiteral("abc"));
    QVERIFY(speed->property(editor::kInvalidProperty).toBool());
    QTest::keyClick(speed, Qt::Key_Tab);
    QVERIFY(*human(0).maxVel > 0.0);
  }

  void several_different_showDashAndChangeTogether() {
    auto* speed = fieldOf<NumberField>({0, 1}, "Top speed");
    QVERIFY(speed->isMixed());
    QVERIFY(speed->text().startsWith(QStringLiteral("–")));
    enter(speed, QStringLiteral("1.2"));
    QCOMPARE(*human(0).maxVel, 1.2);
    QCOMPARE(*human(1).maxVel, 1.2);
    QCOMPARE(speed->text(), QStringLiteral("1.20 m/s"));
    QCOMPARE(document_->undoStack().count(), 1);
    document_->undoStack().undo();
    QCOMPARE(*human(0).maxVel, 1.0);
    QCOMPARE(*human(1).maxVel, 1.5);
    QVERIFY(speed->isMixed());
  }

  void several_oneOfTheValuesTyped_goesToAll() {
    for (const QString& typed : {QStringLiteral("1.0"), QStringLiteral("1.5")}) {
      document_->setSelection({key(0), key(1)});
      auto* speed = field<NumberField>(QStringLiteral("Top speed"));
      enter(speed, typed);
      QCOMPARE(*human(0).maxVel, typed.toDouble());
      QCOMPARE(*human(1).maxVel, typed.toDouble());
      document_->undoStack().undo();
    }
  }

  void several_nonsenseTyped_leavesThemAsTheyAre() {
    auto* speed = fieldOf<NumberField>({0, 1}, "Top speed");
    type(speed, QStringLiteral("999"));
    QTest::keyClick(speed, Qt::Key_Tab);
    QCOMPARE(document_->undoStack().count(), 0);
    QVERIFY(speed->isMixed());
    QVERIFY(speed->text().startsWith(QStringLiteral("–")));
  }

  void default_leftOut_isShownPaleAndStaysOut() {
    auto* radius = fieldOf<NumberField>({0}, "Radius");
    QCOMPARE(radius->value(), 0.35);
    QVERIFY(!human(0).radius.has_value());
    radius->setFocus();
    panel_->setFocus();
    QVERIFY(!human(0).radius.has_value());
    QCOMPARE(document_->undoStack().count(), 0);
  }

  /// Another kind of thing is selected while a number is being typed: it is the person's.
  void number_beingTyped_isTakenWhenThePageGoes() {
    document_->setSelection({key(0)});
    panel_->show();
    auto* radius = field<NumberField>(QStringLiteral("Radius"));
    type(radius, QStringLiteral("0.5"));
    document_->setSelection({document_->goalKey(document_->scenario().goals.front().id)});
    QCOMPARE(human(0).radius, std::optional(0.5));
    panel_->hide();
  }

  void slider_moved_setsTheNumber() {
    auto* radius = fieldOf<NumberField>({0}, "Radius");
    auto* slider = field<editor::LinkedSlider>(QStringLiteral("Radius"));
    QVERIFY(slider != nullptr);
    slider->setValue(slider->maximum());
    QCOMPARE(radius->value(), 0.8);
    QCOMPARE(*human(0).radius, 0.8);
  }

  void behavior_chosen_showsItsReaction() {
    auto* behavior = fieldOf<editor::ChoiceField>({0}, "Behaviour");
    auto* stops = field<NumberField>(QStringLiteral("Stops at"));
    QVERIFY(!stops->isVisible());
    const int curious = behavior->findText(QStringLiteral("Curious"));
    behavior->setCurrentIndex(curious);
    Q_EMIT behavior->activated(curious);
    QCOMPARE(*human(0).behavior.type, sim2d::BehaviorType::Curious);
    QVERIFY(stops->isVisible());
    QVERIFY(!field<NumberField>(QStringLiteral("Keeps away"))->isVisible());
    document_->undoStack().undo();
    QVERIFY(!stops->isVisible());
  }

  void forces_configuration_decidesWhoMayType() {
    auto* goal = fieldOf<NumberField>({0}, "Goal");
    QVERIFY(!goal->isEnabled());
    QCOMPARE(goal->value(), 2.0);  // HuNavSim's default
    auto* mode = field<editor::ChoiceField>(QStringLiteral("Strength"));
    Q_EMIT mode->activated(1);
    QCOMPARE(*human(0).behavior.configuration, sim2d::Configuration::Custom);
    QVERIFY(goal->isEnabled());
  }

  void route_edited_isOneCommand() {
    document_->setSelection({key(0), key(1)});
    auto* route = panel_->currentPage()->findChild<editor::RouteEditor*>();
    Q_EMIT route->edited({3, 1, 3});
    QCOMPARE(human(0).goals, (std::vector<int>{3, 1, 3}));
    QCOMPARE(human(1).goals, (std::vector<int>{3, 1, 3}));
    QCOMPARE(route->goals(), (std::vector<int>{3, 1, 3}));
    document_->undoStack().undo();
    QVERIFY(human(0).goals.empty());
  }

  void name_taken_isRefused() {
    auto* name = fieldOf<editor::TextField>({0}, "Name");
    type(name, QStringLiteral("Ben"));
    QVERIFY(name->property(editor::kInvalidProperty).toBool());
    QVERIFY(!name->toolTip().isEmpty());
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(human(0).name, std::string("Ana"));
    enter(name, QStringLiteral("Anna"));
    QCOMPARE(human(0).name, std::string("Anna"));
  }

  void settings_seed_isEditedWithoutSelection() {
    auto* seed = fieldOf<NumberField>({}, "Seed");
    QVERIFY(seed != nullptr);
    enter(seed, QStringLiteral("42"));
    QCOMPARE(document_->scenario().desktop.seed.value_or(0), 42LL);
    document_->undoStack().undo();
    QVERIFY(!document_->scenario().desktop.seed.has_value());
  }

  void settings_duration_leftOut_knowsTheRobot() {
    auto* duration = fieldOf<NumberField>({}, "Duration");
    QVERIFY(duration != nullptr);
    QCOMPARE(duration->value(), 60.0);
    sim2d::Robot robot;
    robot.name = "rob";
    robot.goal.point = editor::Vec2(3.0, 0.0);
    editor::pushAdd(*document_, std::vector<editor::Entity>{robot}, QStringLiteral("Add"));
    document_->setSelection({});
    QCOMPARE(duration->value(), 120.0);
  }

  void hint_ofText_staysWhenShownAgain() {
    auto* thresholds = fieldOf<editor::TextField>({}, "Thresholds");
    QVERIFY(thresholds != nullptr);
    const QString hint = thresholds->toolTip();
    QVERIFY(!hint.isEmpty());
    type(thresholds, QStringLiteral("nonsense"));
    QVERIFY(thresholds->toolTip() != hint && !thresholds->toolTip().isEmpty());
    QTest::keyClick(thresholds, Qt::Key_Return);
    QCOMPARE(thresholds->toolTip(), hint);
  }

  void heading_severalKinds_tellsWhomChangesReach() {
    document_->setSelection({document_->goalKey(1), key(0), key(1)});
    for (const char* words : {"2 people", "Changes apply to these, not to 1 other"}) {
      QVERIFY2(widgets::withText<QLabel>(*panel_, QLatin1String(words)) != nullptr, words);
    }
  }

  void kinds_everythingSelected_clickShowsAndChangesThatKind() {
    sim2d::Robot robot;
    robot.name = "rob";
    const EntityId rob = editor::pushAdd(*document_, robot);
    document_->setSelection(
        {key(0), key(1), document_->goalKey(1), document_->goalKey(2), document_->goalKey(3), rob});
    const auto button = [this](const char* text) {
      auto* found = widgets::withText<QPushButton>(*panel_, QLatin1String(text));
      return found != nullptr && found->isVisible() ? found : nullptr;
    };
    for (const char* words : {"2 people", "3 goals", "robot"}) {
      QVERIFY2(button(words) != nullptr, words);
    }
    QVERIFY(button("2 people")->isChecked());  // people come first
    QTest::mouseClick(button("3 goals"), Qt::LeftButton);
    QVERIFY(button("3 goals")->isChecked() && !button("2 people")->isChecked());
    QCOMPARE(panel_->currentPage(), panel_->page(base::EntityKind::Goal));
    QTest::mouseClick(button("2 people"), Qt::LeftButton);
    enter(field<NumberField>(QStringLiteral("Top speed")), QStringLiteral("0.7"));
    QCOMPARE(*human(0).maxVel, 0.7);
    QCOMPARE(*human(1).maxVel, 0.7);
    QVERIFY(button("2 people")->isChecked());  // also after the change
    QTest::mouseClick(button("robot"), Qt::LeftButton);
    QCOMPARE(panel_->currentPage(), panel_->page(base::EntityKind::Robot));
    document_->setSelection({key(0), document_->goalKey(1)});
    QVERIFY(button("person") != nullptr && button("goal") != nullptr);
    QVERIFY(button("robot") == nullptr);
    document_->setSelection({key(0), key(1)});
    QVERIFY(button("2 people") == nullptr);  // one kind needs no switch
  }
};

QTEST_MAIN(PropertyPanelTest)
#include "tst_PropertyPanel.moc"
