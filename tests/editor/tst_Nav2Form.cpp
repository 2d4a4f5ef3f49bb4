#include <QtTest>

#include "app/run/Nav2Robots.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/nav2/Nav2Form.h"
#include "editor/panels/properties/EntityPages.h"
#include "tests/support/Widgets.h"

using editor::EntityKind;
using editor::FormSection;
using editor::Nav2Form;
using editor::RobotPage;
using editor::ScenarioDocument;

/// The parameters of Nav2: found, changed, checked, taken back; the robot's page leads to them.
class Nav2FormTest : public QObject {
  Q_OBJECT

 private:
  ScenarioDocument document_;
  std::unique_ptr<Nav2Form> form_;

  const sim2d::Robot& robot() const { return document_.scenario().robots.front(); }
  Nav2Form& form() const { return *form_; }
  void refresh() const {
    const bool isNav2 = robot().planner == std::string("nav2");
    form_->show(isNav2 ? std::optional(robot()) : std::nullopt, {});
  }
  int tabOf(const char* server) const {
    for (int tab = 0; tab < form().servers().count(); ++tab) {
      if (form().servers().tabText(tab) == QString::fromUtf8(server)) {
        return tab;
      }
    }
    return -1;
  }
  void clickTab(int tab) const {
    QTest::mouseClick(&form().servers(), Qt::LeftButton, {},
                      form().servers().tabRect(tab).center());
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
    const QModelIndex index = tree.indexAt(QPoint(120, tree.visualItemRect(&row).center().y()));
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
    sim2d::Robot driven;
    driven.key = {EntityKind::Robot, 1};
    driven.name = "robot1";
    driven.planner = "nav2";
    driven.nav2Params = {SOURCE_DIR "/resources/nav2_params/generic.yaml"};
    scenario.robots.push_back(driven);
    document_.load(std::move(scenario));
    form_ = std::make_unique<Nav2Form>();
    form_->setTheme(editor::Theme::light());
    connect(
        form_.get(), &Nav2Form::edited, this,
        [this](const app::Nav2Parameter& parameter, const std::optional<std::string>& yaml) {
          editor::pushChange<sim2d::Robot>(
              document_, {EntityKind::Robot, 1}, QStringLiteral("Change"),
              [&](sim2d::Robot& edited) { edited = app::withNav2Value(edited, parameter, yaml); });
        });
    refresh();
    form_->resize(1100, 420);
    form_->QWidget::show();
    QVERIFY(QTest::qWaitForWindowExposed(form_.get()));
    QCoreApplication::processEvents();
  }
  void cleanup() { form_.reset(); }

  void rows_haveTheValuesOfTheFile() {
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.3"));
    QCOMPARE(row("FollowPath.PathAlignCritic.cost_weight").text(1), QStringLiteral("14.0"));
    QCOMPARE(row("local_costmap.inflation_layer.inflation_radius").text(1), QStringLiteral("0.80"));
    form().tree().setCurrentItem(&row("FollowPath.temperature"));
    QVERIFY2(help().contains(QStringLiteral("Nav2 default 0.3")), qPrintable(help()));
    QVERIFY(help().size() > 40);  // with a sentence
  }

  /// Default, value in the file and help stand beside the value.
  void rows_showDefaultAndHelp() {
    const QTreeWidgetItem& found = row("FollowPath.temperature");
    QCOMPARE(found.text(editor::Nav2FileColumn), QStringLiteral("0.3"));
    QVERIFY(found.text(editor::Nav2DefaultColumn).startsWith(QStringLiteral("0.3")));
    QVERIFY(found.text(editor::Nav2HelpColumn).size() > 20);
    QCOMPARE(row("FollowPath.vx_max").text(editor::Nav2DefaultColumn), QStringLiteral("0.5 m/s"));
    QCOMPARE(row("FollowPath.vx_max").text(editor::Nav2FileColumn), QStringLiteral("0.8"));
  }

  void tab_showsOneServer() {
    QVERIFY(tabOf("controller_server") > 0 && tabOf("local_costmap") > 0);
    clickTab(tabOf("local_costmap"));
    QVERIFY(row("FollowPath.temperature").isHidden());
    QVERIFY(!row("local_costmap.inflation_layer.inflation_radius").isHidden());
    clickTab(tabOf("controller_server"));
    QVERIFY(!row("FollowPath.temperature").isHidden());
    QVERIFY(row("FollowPath.temperature").parent()->isExpanded());
    clickTab(0);
    QVERIFY(!row("local_costmap.inflation_layer.inflation_radius").isHidden());
  }

  /// The page of the robot leads to the panel, and says how many values are changed.
  void page_leadsToThePanel() {
    RobotPage page(document_);
    page.setTheme(editor::Theme::light());
    page.setTargets({{EntityKind::Robot, 1}});
    page.resize(320, 1200);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    auto& section = *widgets::titled<FormSection>(page, QStringLiteral("Nav2 parameters"));
    QVERIFY(section.isVisible() && section.height() < 80);
    QSignalSpy requested(&page, &RobotPage::panelRequested);
    QTest::mouseClick(page.findChild<QToolButton*>(QStringLiteral("nav2_open")), Qt::LeftButton);
    QCOMPARE(requested.count(), 1);
    QCOMPARE(requested.front().front().toString(), QStringLiteral("nav2"));
    typeInto("FollowPath.temperature", QStringLiteral("0.2"));
    page.refresh();
    QCOMPARE(section.note(), QStringLiteral("1 changed"));
    sim2d::Robot other = robot();
    other.planner = "dwa";
    editor::pushEdit(document_, {other}, QStringLiteral("Change"));
    page.refresh();
    QVERIFY(!section.isVisible());
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
    refresh();
    QVERIFY(form().rowOf("FollowPath.temperature") == nullptr);
    QVERIFY(robot().nav2Values.empty());
    editor::pushEdit(document_, {before}, QStringLiteral("Change back"));
    refresh();
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
    refresh();
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.2"));
    QVERIFY(row("FollowPath.temperature").font(1).weight() >
            row("FollowPath.vx_max").font(1).weight());
    QCOMPARE(form().changedCount(), 1);
    QVERIFY(help().contains(QStringLiteral("in the file 0.3")));
    // what a run is made of
    QVERIFY(app::wrongNav2Values(document_.scenario(), {}).empty());
    if (const QByteArray folder = qgetenv("HUNAV_PICTURES"); !folder.isEmpty()) {
      form_->grab().save(QString::fromLocal8Bit(folder) + QStringLiteral("/nav2_form.png"));
    }
    document_.undoStack().undo();
    QVERIFY(robot().nav2Values.empty());
    refresh();
    QCOMPARE(row("FollowPath.temperature").text(1), QStringLiteral("0.3"));
    QCOMPARE(form().changedCount(), 0);
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
    QTRY_VERIFY2(QToolTip::text().startsWith(QStringLiteral("Not used: ")),
                 qPrintable(QToolTip::text()));  // below the row, after its field is closed
    QToolTip::hideText();
  }

  void change_takenBack_byDeleteAndByTheLinks() {
    typeInto("FollowPath.temperature", QStringLiteral("0.2"));
    typeInto("FollowPath.vx_max", QStringLiteral("0.5"));
    refresh();
    QCOMPARE(form().changedCount(), 2);
    QTest::mouseClick(&link(QStringLiteral("Changed only"), form()), Qt::LeftButton);
    QVERIFY(row("FollowPath.wz_max").isHidden() && !row("FollowPath.vx_max").isHidden());
    form().tree().setCurrentItem(&row("FollowPath.vx_max"));
    form().tree().setFocus();
    QTest::keyClick(&form().tree(), Qt::Key_Delete);
    refresh();
    QCOMPARE(robot().nav2Values, (sim2d::ParameterTexts{{"FollowPath.temperature", "0.2"}}));
    QTest::mouseClick(&link(QStringLiteral("Changed only"), form()), Qt::LeftButton);
    form().tree().setCurrentItem(&row("FollowPath.temperature"));
    QTest::mouseClick(&link(QStringLiteral("Reset value"), form()), Qt::LeftButton);
    QVERIFY(robot().nav2Values.empty());
  }

  /// Only changed values are wanted and there are none, as after writing them to a file.
  void changedOnly_withoutChanges_saysSoAndShowsAllAgain() {
    QToolButton& only = link(QStringLiteral("Changed only"), form());
    const auto* const hint = form().findChild<QWidget*>(QStringLiteral("nav2_unchanged"));
    QVERIFY(hint != nullptr && !hint->isVisibleTo(&form()));
    typeInto("FollowPath.temperature", QStringLiteral("0.2"));
    refresh();
    QTest::mouseClick(&only, Qt::LeftButton);
    QVERIFY(only.isChecked() && !hint->isVisibleTo(&form()));
    search().setText(QStringLiteral("temperature"));
    form().tree().setCurrentItem(&row("FollowPath.temperature"));
    QTest::mouseClick(&link(QStringLiteral("Reset value"), form()), Qt::LeftButton);
    refresh();
    QVERIFY(hint->isVisibleTo(&form()) && !form().tree().isVisibleTo(&form()));
    QVERIFY(widgets::withText<QLabel>(*hint, QStringLiteral("No changed values")) != nullptr);
    QTest::mouseClick(&link(QStringLiteral("Show all"), *hint), Qt::LeftButton);
    QVERIFY(!only.isChecked() && !hint->isVisibleTo(&form()));
    QVERIFY(form().tree().isVisibleTo(&form()) && !row("FollowPath.temperature").isHidden());
  }

  void value_ofTheFileTyped_isNoChange() {
    typeInto("FollowPath.temperature", QStringLiteral("0.2"));
    refresh();
    typeInto("FollowPath.temperature", QStringLiteral("0.3"));
    QVERIFY(robot().nav2Values.empty());
  }
};

QTEST_MAIN(Nav2FormTest)
#include "tst_Nav2Form.moc"
