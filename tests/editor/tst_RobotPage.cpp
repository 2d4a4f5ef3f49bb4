#include <QtTest>

#include "app/run/Nav2Robots.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Form.h"
#include "editor/panels/properties/EntityPages.h"
#include "editor/panels/properties/PageWidgets.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "tests/support/Widgets.h"

using editor::ChoiceField;
using editor::EntityKind;
using editor::FormSection;
using editor::NumberField;
using editor::RobotPage;
using editor::RobotPicture;
using editor::ScenarioDocument;

namespace {

sim2d::Scenario twoRobots() {
  sim2d::Scenario scenario;
  for (const int number : {1, 2}) {
    sim2d::Robot robot;
    robot.key = {EntityKind::Robot, number};
    robot.name = "robot" + std::to_string(number);
    robot.planner = "social_mppi";
    scenario.robots.push_back(robot);
  }
  return scenario;
}

/// The box of the rows and columns that are mostly of about this colour [px]: a few pixels of words
/// may have it as well.
QRect boxOfColor(const QImage& image, const QColor& color) {
  std::vector<int> rows(static_cast<std::size_t>(image.height()));
  std::vector<int> columns(static_cast<std::size_t>(image.width()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      const int off = std::abs(pixel.red() - color.red()) +
                      std::abs(pixel.green() - color.green()) +
                      std::abs(pixel.blue() - color.blue());
      if (off < 12) {
        ++rows[static_cast<std::size_t>(y)];
        ++columns[static_cast<std::size_t>(x)];
      }
    }
  }
  const auto extent = [](const std::vector<int>& counts) {
    const int most = *std::max_element(counts.begin(), counts.end());
    const auto isOf = [most](int count) { return count > 0 && 4 * count >= most; };
    const auto first = std::find_if(counts.begin(), counts.end(), isOf);
    const auto last = std::find_if(counts.rbegin(), counts.rend(), isOf);
    return std::pair(static_cast<int>(first - counts.begin()),
                     static_cast<int>(counts.rend() - last));  // behind it
  };
  const auto [top, bottom] = extent(rows);
  const auto [left, right] = extent(columns);
  return {left, top, right - left, bottom - top};
}

}  // namespace

/// The page of a robot: the body's picture, choosers, and folds for what is many.
class RobotPageTest : public QObject {
  Q_OBJECT

 private:
  ScenarioDocument document_;
  std::unique_ptr<RobotPage> page_;

  const sim2d::Robot& robot(std::size_t index = 0) const {
    return document_.scenario().robots[index];
  }
  void show(sim2d::Scenario scenario, const sim2d::FieldTables& tables = sim2d::fieldTables()) {
    document_.load(std::move(scenario));
    page_ = std::make_unique<RobotPage>(document_, tables);
    page_->setTheme(editor::Theme::light());
    page_->resize(320, 1200);
    page_->setTargets({robot().key});
    page_->show();
    QVERIFY(QTest::qWaitForWindowExposed(page_.get()));
  }
  FormSection* section(const QString& title) const {
    return widgets::titled<FormSection>(*page_, title);
  }
  void clickHeading(FormSection* fold) {
    auto* heading = fold->findChild<QToolButton*>();
    QTest::mouseClick(heading, Qt::LeftButton);
    QCoreApplication::processEvents();
  }
  QToolButton* resetOf(FormSection* fold) const {
    return fold->findChild<QToolButton*>(QStringLiteral("reset"));
  }
  NumberField* number(const char* name) const {
    return page_->findChild<NumberField*>(QLatin1String(name));
  }
  void type(NumberField* field, const char* digits) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QLatin1String(digits));
    QTest::keyClick(field, Qt::Key_Return);
    page_->refresh();
  }
  ChoiceField* choice(const char* name) const {
    return page_->findChild<ChoiceField*>(QLatin1String(name));
  }
  /// By the keyboard, as a user does: the word's first letters in the closed list.
  void choose(ChoiceField* box, const QString& word) {
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < box->count() && box->currentText() != word; ++i) {
      QTest::keyClick(box, Qt::Key_Down);
      page_->refresh();
    }
    page_->refresh();
    QCOMPARE(box->currentText(), word);
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void cleanup() { page_.reset(); }

  void parameters_ofThePlanner_areAFoldBelowStartAndGoal() {
    show(twoRobots());
    FormSection* fold = section(QStringLiteral("Parameters"));
    QVERIFY(fold != nullptr && !fold->isOpen());
    const sim2d::Registries registries = sim2d::builtinRegistries();
    const std::string first = registries.planners.find("social_mppi")->parameters.front().key;
    NumberField* row = number(("social_mppi." + first).c_str());
    QVERIFY(row != nullptr && !row->isVisible());
    const auto top = [this](const QString& title) {
      return section(title)->mapTo(page_.get(), QPoint()).y();
    };
    QVERIFY(top(QStringLiteral("Robot")) < top(QStringLiteral("Start")));
    QVERIFY(top(QStringLiteral("Start")) < top(QStringLiteral("Goal")));
    QVERIFY(top(QStringLiteral("Goal")) < fold->mapTo(page_.get(), QPoint()).y());
    clickHeading(fold);
    QVERIFY(fold->isOpen() && row->isVisible());
    QVERIFY(!number("pursuit.lookahead")->isVisible());
    clickHeading(fold);
    QVERIFY(!row->isVisible());
  }

  void head_ofAFold_countsWhatTheFileChangesAndTakesItBack() {
    sim2d::Scenario scenario = twoRobots();
    for (sim2d::Robot& each : scenario.robots) {
      each.planner.reset();
    }
    show(scenario);
    FormSection* fold = section(QStringLiteral("Parameters"));
    QVERIFY(fold != nullptr);
    QVERIFY(fold->note().isEmpty() && resetOf(fold)->isHidden());
    clickHeading(fold);
    NumberField* ahead = number("pursuit.lookahead");
    const double usual = ahead->value();
    type(ahead, "0.85");
    QCOMPARE(fold->note(), QStringLiteral("1 changed"));
    type(number("pursuit.stop_distance"), "0.75");
    QCOMPARE(fold->note(), QStringLiteral("2 changed"));
    QCOMPARE(robot().plannerParameters.size(), std::size_t{2});
    clickHeading(fold);
    QVERIFY(!ahead->isVisible());
    QCOMPARE(fold->note(), QStringLiteral("2 changed"));
    const int steps = document_.undoStack().count();
    QVERIFY(resetOf(fold)->isVisible());
    QTest::mouseClick(resetOf(fold), Qt::LeftButton);
    page_->refresh();
    QVERIFY(robot().plannerParameters.empty());
    QCOMPARE(document_.undoStack().count(), steps + 1);
    QVERIFY(fold->note().isEmpty() && resetOf(fold)->isHidden());
    QCOMPARE(ahead->value(), usual);
    document_.undoStack().undo();
    page_->refresh();
    QCOMPARE(fold->note(), QStringLiteral("2 changed"));
  }

  /// What the file gives as it is by default changes nothing, and can be taken out all the same.
  void head_ofAFold_valueAsByDefault_isNoChange() {
    sim2d::Scenario scenario = twoRobots();
    scenario.robots[0].mass = 50.0;  // of the general type (sim2d/nav/RobotTypes.cpp)
    scenario.robots[0].maxVel = 0.5;
    show(scenario);
    FormSection* fold = section(QStringLiteral("Body and limits"));
    QVERIFY(fold != nullptr && !fold->isOpen());
    QCOMPARE(fold->note(), QStringLiteral("1 changed"));
    QTest::mouseClick(resetOf(fold), Qt::LeftButton);
    QVERIFY(!robot().mass && !robot().maxVel);
  }

  void planner_inTheChooser_standsOnceAndIsLeftOutWhenUsual() {
    show(twoRobots());
    ChoiceField* box = choice("planner");
    QStringList words;
    for (int i = 0; i < box->count(); ++i) {
      words << box->itemText(i);
    }
    QCOMPARE(words.filter(QStringLiteral("pursuit")),
             QStringList(QStringLiteral("pursuit (default)")));
    QCOMPARE(words.size(), int(app::builtinRegistries().planners.names().size()));
    QCOMPARE(box->currentText(), QStringLiteral("social_mppi"));
    choose(box, QStringLiteral("pursuit (default)"));
    QVERIFY(!robot().planner);
    choose(box, QStringLiteral("dwa"));
    QCOMPARE(robot().planner, std::optional<std::string>("dwa"));
    Q_EMIT box->activated(box->currentIndex());  // chosen once more
    QCOMPARE(robot().planner, std::optional<std::string>("dwa"));
  }

  void planner_ofTheChooser_tellsWhatItDoes() {
    show(twoRobots());
    const auto* help = page_->findChild<QLabel*>(QStringLiteral("planner_help"));
    QVERIFY(help->isVisible());
    const sim2d::Registries registries = sim2d::builtinRegistries();
    for (const auto& planner : registries.planners.entries()) {
      QVERIFY2(!planner.help.empty(), planner.name.c_str());
      choose(
          choice("planner"),
          QString::fromStdString(planner.name == "pursuit" ? "pursuit (default)" : planner.name));
      QCOMPARE(help->text(), QString::fromStdString(planner.help));
      QCoreApplication::processEvents();
      QTRY_VERIFY(help->height() >= help->heightForWidth(help->width()));  // nothing is cut
    }
  }

  void planner_thatNobodyKnows_isNoOtherOne() {
    sim2d::Scenario scenario = twoRobots();
    scenario.robots[0].planner = "hovercraft";
    show(scenario);
    QCOMPARE(choice("planner")->currentIndex(), -1);
    QCOMPARE(robot().planner, std::optional<std::string>("hovercraft"));
  }

  /// A file for a planner of recorded commands is a text, which the rows of numbers lost.
  void parameter_ofText_isEdited() {
    sim2d::Scenario scenario = twoRobots();
    scenario.robots[0].planner = "replay";
    show(scenario);
    clickHeading(section(QStringLiteral("Parameters")));
    auto* file = page_->findChild<editor::TextField*>(QStringLiteral("replay.file"));
    QVERIFY(file != nullptr && file->isVisible());
    file->setFocus();
    QTest::keyClicks(file, QStringLiteral("drive.csv"));
    QTest::keyClick(file, Qt::Key_Return);
    page_->refresh();
    QVERIFY((robot().plannerParameters == sim2d::ParameterTexts{{"file", "drive.csv"}}));
    QCOMPARE(file->text(), QStringLiteral("drive.csv"));
    auto* others = page_->findChild<editor::TextField*>(QStringLiteral("other_parameters"));
    QVERIFY(!others->isVisible());
  }

  void type_ofTheChooser_hasItsTitleFiguresAndSource() {
    show(twoRobots());
    ChoiceField* box = choice("type");
    QCOMPARE(box->count(), int(sim2d::robotTypes().size()));
    QCOMPARE(box->currentText(), QStringLiteral("Generic robot (default)"));
    choose(box, QStringLiteral("TurtleBot 3 Burger"));
    QCOMPARE(robot().type, std::optional<std::string>("turtlebot3_burger"));
    const QString hint = box->itemData(box->currentIndex(), Qt::ToolTipRole).toString();
    // 0.22 m/s, 2.84 rad/s, 1 kg: the maker's e-manual, features of TurtleBot3.
    for (const char* figure : {"0.22 m/s", "2.84 rad/s", "1.0 kg", "ROBOTIS-GIT/turtlebot3"}) {
      QVERIFY2(hint.contains(QLatin1String(figure)), figure);
    }
    auto* source = page_->findChild<QToolButton*>(QStringLiteral("source"));
    QVERIFY(source->isVisible());
    QCOMPARE(source->toolTip(), hint);
  }

  void key_ofAGroup_isInAFoldOfItsTitle() {
    sim2d::FieldTables tables = sim2d::fieldTables();
    auto& keys = std::get<sim2d::Fields<sim2d::Robot>>(tables);
    keys.push_back(sim2d::field("sonar_range", &sim2d::Robot::mass, "How far it hears",
                                {"Range", 1, 0.5}, "m", {0.0, 50.0})
                       .defaultsTo(4.0)
                       .inGroup("Sonar"));
    keys.push_back(sim2d::field("sonar_rate", &sim2d::Robot::maxAlpha, "How often", {"Rate"}, "1/s")
                       .defaultsTo(8.0)
                       .inGroup("Sonar"));
    show(twoRobots(), tables);
    FormSection* fold = section(QStringLiteral("Sonar"));
    QVERIFY(fold != nullptr && !fold->isOpen());
    NumberField* range = number("sonar_range");
    QVERIFY(fold->isAncestorOf(range) && fold->isAncestorOf(number("sonar_rate")));
    QVERIFY(!range->isVisible());
    clickHeading(fold);
    QVERIFY(range->isVisible());
    type(range, "7.5");
    QCOMPARE(robot().mass, std::optional(7.5));
    QCOMPARE(fold->note(), QStringLiteral("1 changed"));
  }

  /// Makers' sizes: Burger 138 x 178 mm, Nova Carter 725 x 500 mm, Create 3 of 328 mm.
  void picture_size_isThatOfTheMaker_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<QSizeF>("size");
    QTest::addRow("burger") << QStringLiteral("turtlebot3_burger") << QSizeF(0.138, 0.178);
    QTest::addRow("carter") << QStringLiteral("nova_carter") << QSizeF(0.725, 0.5);
    QTest::addRow("create") << QStringLiteral("create3") << QSizeF(0.328, 0.328);
  }
  void picture_size_isThatOfTheMaker() {
    QFETCH(QString, type);
    QFETCH(QSizeF, size);
    const QSizeF shown = RobotPicture::sizeOf(sim2d::robotOfType(type.toStdString()));
    QVERIFY(std::abs(shown.width() - size.width()) < 1e-9);
    QVERIFY(std::abs(shown.height() - size.height()) < 1e-9);
  }

  /// On screens with one and with two pixels per point, light and dark.
  void picture_body_isTrueToScale_data() {
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("ratio");
    for (const bool dark : {false, true}) {
      for (const int ratio : {1, 2}) {
        QTest::addRow("%s %d", dark ? "dark" : "light", ratio) << dark << ratio;
      }
    }
  }
  void picture_body_isTrueToScale() {
    QFETCH(bool, dark);
    QFETCH(int, ratio);
    const editor::Theme theme(dark);
    RobotPicture picture;
    picture.setTheme(theme);
    picture.resize(320, 128);
    sim2d::ResolvedRobot robot = sim2d::robotOfType("generic");
    robot.footprint = {{-0.4, -0.2}, {0.4, -0.2}, {0.4, 0.2}, {-0.4, 0.2}};  // 2 : 1
    picture.show(robot);
    QImage image(picture.size() * ratio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    image.fill(theme.color(editor::Role::Panel));
    picture.render(&image);
    QImage left = image.copy(0, 0, image.width() / 2, image.height());
    const QRect body = boxOfColor(left, theme.color(editor::Role::RobotBody));
    QVERIFY(body.width() > 60 * ratio);
    const double proportion = double(body.width()) / body.height();
    QVERIFY2(std::abs(proportion - 2.0) < 0.15, qPrintable(QString::number(proportion)));
  }

  void picture_ofSeveral_isThatOfTheOneBody() {
    show(twoRobots());
    auto* picture = page_->findChild<RobotPicture*>();
    page_->setTargets({robot(0).key, robot(1).key});
    QVERIFY(picture->isVisible());
    editor::pushChange<sim2d::Robot>(document_, robot(1).key, QStringLiteral("Change"),
                                     [](sim2d::Robot& each) { each.type = "jetbot"; });
    page_->refresh();
    QVERIFY(!picture->isVisible());
  }
};

QTEST_MAIN(RobotPageTest)
#include "tst_RobotPage.moc"
