#include <QtTest>

#include "editor/look/AppStyle.h"
#include "editor/look/TableExport.h"
#include "tests/support/Widgets.h"

using editor::TableFormat;

namespace {

/// A table with a hidden column and a hidden row, a number with more digits than it shows, and
/// characters that the formats must escape.
std::unique_ptr<QTableWidget> pets() {
  auto table = std::make_unique<QTableWidget>(3, 4);
  table->setHorizontalHeaderLabels(
      QStringLiteral("Name;Hidden;Weight [kg];Says").split(QLatin1Char(';')));
  const QStringList cells =
      QStringLiteral("Tom & Co;x;4.20;me|ow, \"purr\";Rex_2;x;31.5;–;gone;x;1;-")
          .split(QLatin1Char(';'));
  for (int k = 0; k < cells.size(); ++k) {
    table->setItem(k / 4, k % 4, new QTableWidgetItem(cells[k]));
  }
  table->item(0, 2)->setData(editor::kExactValueRole, 4.2000125);
  table->setColumnHidden(1, true);
  table->setRowHidden(2, true);
  return table;
}

/// The entry of the menu that a right click opens, clicked.
void chooseEntry(QAbstractItemView& view, const QString& entry) {
  const QPoint at = view.visualRect(view.model()->index(0, 0)).center();
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, view.viewport()->mapToGlobal(at));
  QCoreApplication::sendEvent(view.viewport(), &event);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  QVERIFY(menu != nullptr);
  for (QAction* action : menu->actions()) {
    if (action->text() == entry) {
      QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
      return;
    }
  }
  QFAIL("no such entry");
}

}  // namespace

/// What is shown in tables, as files.
class TableExportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }

  void text_ofATable_isWhatIsShown() {
    const auto table = pets();
    QCOMPARE(editor::tableText(*table, QStringLiteral("Pets"), TableFormat::Csv),
             QStringLiteral("Name,Weight [kg],Says\nTom & Co,4.2000125,\"me|ow, \"\"purr\"\"\"\n"
                            "Rex_2,31.5,\n"));
    QCOMPARE(editor::tableText(*table, QStringLiteral("Pets"), TableFormat::Markdown),
             QStringLiteral("**Pets**\n\n| Name | Weight \\[kg] | Says |\n| --- | ---: | --- |\n"
                            "| Tom & Co | 4.20 | me\\|ow, \"purr\" |\n| Rex\\_2 | 31.5 | – |\n"));
    const QString latex = editor::tableText(*table, QStringLiteral("Pets"), TableFormat::Latex);
    QVERIFY2(latex.contains(QStringLiteral("\\begin{tabular}{lrl}")), qPrintable(latex));
    QVERIFY(latex.contains(QStringLiteral("Tom \\& Co & 4.20 & ")));
    QVERIFY(latex.contains(QStringLiteral("Rex\\_2 & 31.5 & ")));
    QVERIFY(!latex.contains(QStringLiteral("gone")));
  }

  void text_ofATree_hasItsGroupsAsAColumn() {
    QTreeWidget tree;
    tree.setHeaderLabels({QStringLiteral("Metric"), QStringLiteral("Now")});
    for (const char* name : {"Safety", "Empty", "Social"}) {
      auto* group = new QTreeWidgetItem(&tree, {QString::fromUtf8(name), QStringLiteral("1 / 2")});
      if (group->text(0) != QLatin1String("Empty")) {
        auto* row = new QTreeWidgetItem(
            group, {group->text(0) + QStringLiteral(" a"), QStringLiteral("1.5")});
        new QTreeWidgetItem(row, {group->text(0) + QStringLiteral(" part"), QStringLiteral("2")});
      }
    }
    tree.topLevelItem(1)->setHidden(true);
    tree.topLevelItem(2)->child(0)->child(0)->setHidden(true);
    QCOMPARE(editor::tableText(tree, QStringLiteral("Metrics"), TableFormat::Csv),
             QStringLiteral("Group,Metric,Now\nSafety,Safety a,1.5\nSafety,Safety part,2\n"
                            "Social,Social a,1.5\n"));
  }

  void text_ofKeyedRows_hasTheKeysBesideTheLabels_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<QString>("expected");
    QTest::newRow("CSV") << static_cast<int>(TableFormat::Csv)
                         << "Group,Metric,Key,Now\nSafety,Contacts,contacts,2\nSafety,Own,,1\n";
    QTest::newRow("Markdown") << static_cast<int>(TableFormat::Markdown)
                              << "| Safety | Contacts | contacts | 2 |\n";
    QTest::newRow("LaTeX") << static_cast<int>(TableFormat::Latex)
                           << "Safety & Contacts & contacts & 2";
  }
  void text_ofKeyedRows_hasTheKeysBesideTheLabels() {
    QFETCH(int, format);
    QFETCH(QString, expected);
    QTreeWidget tree;
    tree.setHeaderLabels({QStringLiteral("Metric"), QStringLiteral("Now")});
    auto* group = new QTreeWidgetItem(&tree, {QStringLiteral("Safety")});
    auto* row = new QTreeWidgetItem(group, {QStringLiteral("Contacts"), QStringLiteral("2")});
    row->setData(0, editor::kSavedKeyRole, QStringLiteral("contacts"));
    new QTreeWidgetItem(group, {QStringLiteral("Own"), QStringLiteral("1")});
    const QString text =
        editor::tableText(tree, QStringLiteral("Metrics"), static_cast<TableFormat>(format));
    QVERIFY2(text.contains(expected), qPrintable(text));
  }

  void menu_ofATable_copiesItForSpreadsheets() {
    const auto table = pets();
    editor::makeTableSavable(*table, QStringLiteral("Pets"));
    table->show();
    QVERIFY(QTest::qWaitForWindowActive(table.get()));
    QGuiApplication::clipboard()->clear();
    chooseEntry(*table, QStringLiteral("Copy table"));
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("Name\tWeight [kg]\tSays\nTom & Co\t4.20\tme|ow, \"purr\"\n"
                            "Rex_2\t31.5\t–\n"));
  }

  void menu_ofATable_savesInTheFormatOfTheEnding_data() {
    QTest::addColumn<QString>("filter");
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QByteArray>("start");
    QTest::newRow("CSV") << QString() << "csv" << QByteArray("Name,Weight [kg],Says\n");
    QTest::newRow("LaTeX") << "LaTeX (*.tex)"
                           << "tex" << QByteArray("% \\usepackage{booktabs}\n");
    QTest::newRow("Markdown") << "Markdown (*.md)"
                              << "md" << QByteArray("**Pets of mine**\n\n");
  }
  void menu_ofATable_savesInTheFormatOfTheEnding() {
    QFETCH(QString, filter);
    QFETCH(QString, ending);
    QFETCH(QByteArray, start);
    QTemporaryDir folder;
    const auto table = pets();
    editor::makeTableSavable(*table, QStringLiteral("Pets of mine"));
    table->setProperty(editor::kFolderProperty, folder.path());
    table->show();
    QVERIFY(QTest::qWaitForWindowActive(table.get()));
    QString proposed;
    QTimer answer;
    connect(&answer, &QTimer::timeout, &answer, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) {
        return;
      }
      answer.stop();
      if (!filter.isEmpty()) {
        auto* formats = dialog->findChild<QComboBox*>(QStringLiteral("fileTypeCombo"));
        formats->setCurrentText(filter);
        Q_EMIT formats->activated(formats->currentIndex());
        Q_EMIT formats->textActivated(filter);
        Q_EMIT dialog->filterSelected(filter);
      }
      proposed = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->text();
      QTest::keyClick(dialog, Qt::Key_Return);
    });
    answer.start(50);
    chooseEntry(*table, QStringLiteral("Save table…"));
    QTRY_COMPARE(proposed, QStringLiteral("pets-of-mine.") + ending);
    QFile file(folder.filePath(proposed));
    QTRY_VERIFY(file.exists());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY2(bytes.startsWith(start), bytes.constData());
  }

  void menu_ofAnEmptyTable_offersNothing() {
    QTableWidget table(0, 2);
    QMenu menu;
    editor::addTableActions(menu, table, QStringLiteral("Nothing"));
    QCOMPARE(menu.actions().size(), 2);
    QVERIFY(!menu.actions()[0]->isEnabled() && !menu.actions()[1]->isEnabled());
  }
};

QTEST_MAIN(TableExportTest)
#include "tst_TableExport.moc"
