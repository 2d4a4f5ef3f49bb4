#include <QtTest>

#include "editor/look/AppStyle.h"
#include "editor/look/Fields.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/ScenarioPanel.h"
#include "tests/editor/SmallScenario.h"

namespace {

/// The editor that is open in a list; null: none.
QWidget* editorOf(const QAbstractItemView& view) {
  for (QWidget* each :
       view.viewport()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (each->isVisible() && each->focusPolicy() != Qt::NoFocus) {
      return each;
    }
  }
  return nullptr;
}

/// What the list shows in place of the editor equals the editor on a ground of its own: nothing of
/// the row shines through.
bool isOpaque(const QAbstractItemView& view, QWidget& editor, const QColor& ground) {
  const QImage seen = view.viewport()->grab(editor.geometry()).toImage();
  QImage alone(seen.size(), QImage::Format_RGB32);
  alone.setDevicePixelRatio(seen.devicePixelRatio());
  alone.fill(ground);
  editor.render(&alone, {}, {}, QWidget::DrawChildren | QWidget::DrawWindowBackground);
  return seen.convertToFormat(QImage::Format_RGB32) == alone;
}

}  // namespace

/// Editors that are opened in a row of a list, tree or table.
class InPlaceEditorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QApplication::setCursorFlashTime(0); }
  void cleanupTestCase() { editor::applyTheme(editor::Theme::light()); }

  void editor_ofAnyViewAndValue_hidesTheRow_data() {
    QTest::addColumn<bool>("isDark");
    QTest::addColumn<QVariant>("value");
    for (const bool isDark : {false, true}) {
      const QByteArray theme = isDark ? "dark " : "light ";
      QTest::newRow(theme + "text") << isDark << QVariant(QStringLiteral("MMMMMMMMMMMMMMMM"));
      QTest::newRow(theme + "integer") << isDark << QVariant(88888888);
      QTest::newRow(theme + "number") << isDark << QVariant(888888.25);
      QTest::newRow(theme + "choice") << isDark << QVariant(true);
      QTest::newRow(theme + "date") << isDark << QVariant(QDate(2024, 8, 8));
    }
  }
  void editor_ofAnyViewAndValue_hidesTheRow() {
    QFETCH(bool, isDark);
    QFETCH(QVariant, value);
    const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
    editor::applyTheme(theme);
    QStandardItemModel model(3, 2);
    for (int row = 0; row < 3; ++row) {
      model.setData(model.index(row, 0), value, Qt::EditRole);
      model.setData(model.index(row, 1), QStringLiteral("beside"));
    }
    QTreeView tree;
    QTableView table;
    QListView list;
    tree.setItemDelegate(new editor::RowDelegate(&tree));
    for (QAbstractItemView* view :
         std::initializer_list<QAbstractItemView*>{&tree, &table, &list}) {
      view->setModel(&model);
      view->resize(300, 120);
      view->show();
      QVERIFY(QTest::qWaitForWindowActive(view));
      view->setCurrentIndex(model.index(1, 0));
      view->edit(model.index(1, 0));
      QWidget* const field = editorOf(*view);
      QVERIFY(field != nullptr);
      if (auto* const line = qobject_cast<QLineEdit*>(field)) {
        line->clear();
        QTest::keyClicks(line, QStringLiteral("new"));
      }
      QVERIFY(isOpaque(*view, *field, theme.color(editor::Role::Field)));
      QTest::keyClick(field, Qt::Key_Escape);
    }
  }

  /// F2 in the list of the scenario, then typing over the old name.
  void name_inTheScenarioList_isNotWrittenOverTheOld() {
    editor::applyTheme(editor::Theme::light());
    editor::ScenarioDocument document;
    sim2d::Scenario scenario;
    scenario.humans = {
        small::person(1, "WWWWWWWWWWWW", {0.0, 0.0}, 0.0, sim2d::BehaviorType::Regular, {})};
    document.load(scenario);
    editor::ScenarioPanel panel(document, editor::Theme::light());
    panel.resize(260, 300);
    panel.show();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    auto& tree = *panel.findChild<QTreeView*>();
    document.setSelection({document.entities(base::EntityKind::Human).front()});
    tree.setFocus();
    QTest::keyClick(&tree, Qt::Key_F2);
    QWidget* const field = editorOf(tree);
    QVERIFY(field != nullptr);
    QTest::keyClicks(field, QStringLiteral("i"));  // replaces the selected name
    QCOMPARE(qobject_cast<QLineEdit*>(field)->text(), QStringLiteral("i"));
    QVERIFY(isOpaque(tree, *field, editor::Theme::light().color(editor::Role::Field)));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(document.scenario().humans.front().name, std::string("i"));
  }
};

QTEST_MAIN(InPlaceEditorsTest)
#include "tst_InPlaceEditors.moc"
