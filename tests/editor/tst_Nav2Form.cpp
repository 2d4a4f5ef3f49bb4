#include <QtTest>

#include "app/run/Nav2Robots.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/properties/EntityPages.h"
#include "editor/panels/properties/PageWidgets.h"
#include "tests/support/Widgets.h"

using editor::EntityKind;
using editor::FormSection;
using editor::Nav2Form;
using editor::RobotPage;
using editor::ScenarioDocument;

/// The parameters of Nav2 on a robot's page: found, changed, checked, taken back.
class Nav2FormTest : public QObject {
  Q_OBJECT

 private:
  ScenarioDocument document_;
  std::unique_ptr<RobotPage> page_;

  const sim2d::Robot& robot() const { return document_.scenario().robots.front(); }
  Nav2Form& form() const { return *page_->findChild<Nav2Form*>(); }
  FormSection& section() const {
    return *widgets::titled<FormSection>(*page_, QStringLiteral("Nav2 parameters"));
  }
  QLineEdit& search() const { return *form().findChild<QLineEdit*>(); }
  QToolButton& link(const QString& words, const QWidget& parent) const {
    return *widgets::withText<QToolButton>(parent, words);
  }
  QTreeWidgetItem& row(const char* path) const {
    QTreeWidgetItem* const found = form().rowOf(path);
    return found != nullptr ? *found : (qFatal("no row"), *found);
  }
  QRect placeOf(QTreeWidgetItem& row, int column) const {
    QTreeWidget& tree = form().tree();
    for (QTreeWidgetItem* up = row.parent(); up != nullptr; up = up->parent()) {
      up->setExpanded(true);
    }
    tree.scrollToItem(&row);
    const QModelIndex index =
        tree.indexAt(QPoint(2 * tree.width() / 3 + 20, tree.visualItemRect(&row).center().y()));
    return tree.visualRect(index.sibling(index.row(), column));
  }
  /// The field in which the value of a row is edited, by a double click there.
  QLineEdit* editorOf(const char* path) const {
    QTreeWidget& tree = form().tree();
    const QPoint at = placeOf(row(path), 1).center();
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(tree.viewport(), Qt::LeftButton, {}, at);
    return tree.viewport()->findChild<QLineEdit*>();
  }
  void typeInto(const char* path, const QString& text) const {
    QLineEdit* const field = editorOf(path);
    QVERIFY(field != nullptr);
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of the field
  }
  QString help() const { return form().findChild<QLabel*>(QStringLiteral("nav2_help"))->text(); }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    sim2d::Scenario scenario;
    sim2d::Robot robot;
    robot.key = {EntityKind::Robot, 1};
    robot.name = "robot1";
    robot.planner = "nav2";
    robot.nav2Params = {SOURCE_DIR "/resources/nav2_params/generic.yaml"};
    scenario.robots.push_back(robot);
    document_.load(std::move(scenario));
    page_ = std::make_unique<RobotPage>(document_);
    page_->setTheme(editor::Theme::light());
    page_->setTargets({{EntityKind::Robot, 1}});
    page_->resize(320, 1400);
    page_->show();
    QVERIFY(QTest::qWaitForWindowExposed(page_.get()));
    section().setOpen(true);
    QCoreApplication::processEvents();
  }
  void cleanup() { page_.reset(); }

  void rows_haveTheValuesOfTheFile() {
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.3"));
    QCOMPARE(row("FollowPath.PathAlignCritic.cost_weight").text(1), QStringLiteral("14.0"));
    QCOMPARE(row("local_costmap.inflation_layer.inflation_radius").text(1), QStringLiteral("0.80"));
    form().tree().setCurrentItem(&row("FollowPath.temperature"));
    QVERIFY2(help().contains(QStringLiteral("Nav2 default 0.3")), qPrintable(help()));
    QVERIFY(help().size() > 40);  // with a sentence
  }

  void otherPlanner_hidesThem() {
    QVERIFY(section().isVisible());
    sim2d::Robot other = robot();
    other.planner = "dwa";
    editor::pushEdit(document_, {other}, QStringLiteral("Change"));
    page_->refresh();
    QVERIFY(!section().isVisible());
  }

  /// Qt commits what is being typed when the list is emptied, while other rows are being read.
  void value_beingTypedWhenTheFileGoes_isDropped() {
    QLineEdit* const field = editorOf("FollowPath.temperature");
    QVERIFY(field != nullptr);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.2"));
    const sim2d::Robot before = robot();
    sim2d::Robot other = before;
    other.nav2Params = {"nowhere.yaml"};
    editor::pushEdit(document_, {other}, QStringLiteral("Change"));
    page_->refresh();
    QVERIFY(form().rowOf("FollowPath.temperature") == nullptr);
    QVERIFY(robot().nav2Values.empty());
    editor::pushEdit(document_, {before}, QStringLiteral("Change back"));
    page_->refresh();
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.3"));
  }

  void search_showsWhatIsCalledSo() {
    QTest::keyClicks(&search(), QStringLiteral("temperature"));
    QVERIFY(!row("FollowPath.temperature").isHidden());
    QVERIFY(row("FollowPath.temperature").parent()->isExpanded());
    QVERIFY(row("FollowPath.vx_max").isHidden());
    search().clear();
    QVERIFY(!row("FollowPath.vx_max").isHidden());
  }

  void value_typed_isGivenInsteadOfTheFile() {
    typeInto("FollowPath.temperature", QStringLiteral("0.2"));
    QCOMPARE(robot().nav2Values, (sim2d::ParameterTexts{{"FollowPath.temperature", "0.2"}}));
    page_->refresh();
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.2"));
    QVERIFY(row("FollowPath.temperature").font(1).weight() >
            row("FollowPath.vx_max").font(1).weight());
    QCOMPARE(section().note(), QStringLiteral("1 changed"));
    QVERIFY(help().contains(QStringLiteral("in the file 0.3")));
    // what a run is made of
    QVERIFY(app::wrongNav2Values(document_.scenario(), {}).empty());
    if (const QByteArray folder = qgetenv("HUNAV_PICTURES"); !folder.isEmpty()) {
      page_->grab().save(QString::fromLocal8Bit(folder) + QStringLiteral("/nav2_form.png"));
    }
    document_.undoStack().undo();
    QVERIFY(robot().nav2Values.empty());
    page_->refresh();
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.3"));
    QVERIFY(section().note().isEmpty());
  }

  void value_wrong_isToldWhileTypedAndNotTaken() {
    QLineEdit* const field = editorOf("FollowPath.temperature");
    QVERIFY(field != nullptr);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("warm"));
    QVERIFY2(field->toolTip().contains(QStringLiteral("double")), qPrintable(field->toolTip()));
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(robot().nav2Values.empty());
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.3"));
  }

  void change_takenBack_byDeleteAndByTheLinks() {
    typeInto("FollowPath.temperature", QStringLiteral("0.2"));
    typeInto("FollowPath.vx_max", QStringLiteral("0.5"));
    page_->refresh();
    QCOMPARE(form().changedCount(), 2);
    QTest::mouseClick(&link(QStringLiteral("Changed"), form()), Qt::LeftButton);
    QVERIFY(row("FollowPath.wz_max").isHidden() && !row("FollowPath.vx_max").isHidden());
    form().tree().setCurrentItem(&row("FollowPath.vx_max"));
    form().tree().setFocus();
    QTest::keyClick(&form().tree(), Qt::Key_Delete);
    page_->refresh();
    QCOMPARE(robot().nav2Values, (sim2d::ParameterTexts{{"FollowPath.temperature", "0.2"}}));
    QTest::mouseClick(&link(QStringLiteral("Changed"), form()), Qt::LeftButton);
    form().tree().setCurrentItem(&row("FollowPath.temperature"));
    QTest::mouseClick(&link(QStringLiteral("Reset"), form()), Qt::LeftButton);
    QVERIFY(robot().nav2Values.empty());
  }

  void value_ofTheFileTyped_isNoChange() {
    typeInto("FollowPath.temperature", QStringLiteral("0.2"));
    page_->refresh();
    typeInto("FollowPath.temperature", QStringLiteral("0.3"));
    QVERIFY(robot().nav2Values.empty());
  }
};

QTEST_MAIN(Nav2FormTest)
#include "tst_Nav2Form.moc"
