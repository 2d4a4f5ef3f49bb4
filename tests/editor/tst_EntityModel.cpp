#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/EditCommands.h"
#include "editor/document/EntityModel.h"

using namespace editor;

class EntityModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { document_.load(small::scenario()); }

  void rows_ofTheScenario_areInGroups() {
    const EntityModel model(document_, Theme::light());
    QCOMPARE(model.rowCount(), 5);
    QCOMPARE(model.rowCount(model.index(0, 0)), 6);
    QCOMPARE(model.rowCount(model.index(3, 0)), 3);
    const QModelIndex chloe = model.indexOf({EntityKind::Human, 3});
    QCOMPARE(chloe.data().toString(), QStringLiteral("Chloe"));
    QCOMPARE(chloe.sibling(chloe.row(), EntityModel::BehaviorColumn).data().toString(),
             QStringLiteral("Curious"));
    QVERIFY(model.idOf(chloe) == EntityId({EntityKind::Human, 3}));
  }

  void edits_ofEveryKind_keepTheModelConsistent() {
    EntityModel model(document_, Theme::light());
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    const QPersistentModelIndex greta = model.indexOf({EntityKind::Human, 6});
    pushAdd(document_, sim2d::Human());
    pushRemove(document_, {{EntityKind::Human, 2}, {EntityKind::Goal, 12}});
    pushReorder(document_, {{EntityKind::Human, 6}}, 0);
    QCOMPARE(greta.row(), 0);
    while (document_.undoStack().canUndo()) {
      document_.undoStack().undo();
    }
    QCOMPARE(greta.row(), 5);
    QCOMPARE(greta.data().toString(), QStringLiteral("Greta"));
  }

  void setData_name_renamesWithOneCommand() {
    EntityModel model(document_, Theme::light());
    const QModelIndex ana = model.indexOf({EntityKind::Human, 1});
    QVERIFY(model.setData(ana, QStringLiteral(" Anna "), Qt::EditRole));
    QVERIFY(document_.human({EntityKind::Human, 1})->name == "Anna");
    QVERIFY(!model.setData(ana, QStringLiteral("Ben"), Qt::EditRole));
    QVERIFY(model.setData(model.indexOf({EntityKind::Goal, 11}), 8, Qt::EditRole));
    QCOMPARE(document_.undoStack().count(), 2);
  }

  void filter_behaviour_keepsGroups() {
    EntityModel model(document_, Theme::light());
    EntityFilter filter(model);
    filter.setText(QStringLiteral("curi"));
    QCOMPARE(filter.rowCount(), 1);
    QCOMPARE(filter.rowCount(filter.index(0, 0)), 1);
    QVERIFY(filter.idOf(filter.index(0, 0, filter.index(0, 0))) ==
            EntityId({EntityKind::Human, 3}));
    filter.setText(QString());
    QCOMPARE(filter.rowCount(), 5);
  }

 private:
  ScenarioDocument document_;
};

QTEST_MAIN(EntityModelTest)
#include "tst_EntityModel.moc"
