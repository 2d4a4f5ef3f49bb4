#include <QtTest>

#include "editor/look/Theme.h"

using namespace editor;

class ThemeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void contrastRatio_blackOnWhite_is21() {
    QVERIFY(std::abs(contrastRatio(Qt::black, Qt::white) - 21.0) < 1e-6);
    QVERIFY(std::abs(contrastRatio(QColor(0x77, 0x77, 0x77), Qt::white) - 4.48) < 0.01);
  }

  void text_onEveryGround_isReadable_data() {
    QTest::addColumn<int>("text");
    QTest::addColumn<int>("ground");
    const Role texts[] = {Role::Text, Role::TextSecondary};
    const Role grounds[] = {Role::Window, Role::Panel, Role::Field, Role::RowSelected,
                            Role::RowHover};
    for (const Role text : texts) {
      for (const Role ground : grounds) {
        QTest::addRow("%d on %d", int(text), int(ground)) << int(text) << int(ground);
      }
    }
    for (const Role text : {Role::AccentText, Role::Ok, Role::Warning, Role::Error}) {
      QTest::addRow("%d on panel", int(text)) << int(text) << int(Role::Panel);
    }
  }
  void text_onEveryGround_isReadable() {
    QFETCH(int, text);
    QFETCH(int, ground);
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      const double ratio = contrastRatio(theme.color(Role(text)), theme.color(Role(ground)));
      QVERIFY2(ratio >= 4.5, qPrintable(QString::number(ratio)));
    }
  }

  void linesAndOutlines_onTheMap_standOut() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      const QColor map = theme.color(Role::MapFree);
      for (int i = 0; i < kLookCount; ++i) {
        QVERIFY(contrastRatio(theme.line(Look(i)), map) >= 3.0);
        QVERIFY(contrastRatio(theme.outline(Look(i)), map) >= 3.0);
        QVERIFY(contrastRatio(theme.outline(Look(i)), theme.fill(Look(i))) >= 1.5);
      }
      for (const Role role :
           {Role::Accent, Role::MapOccupied, Role::RobotBody, Role::RobotLine, Role::ForceGoal,
            Role::ForceSocial, Role::ForceObstacle, Role::ForceGroup, Role::ForceTotal,
            Role::WarningMark, Role::Error, Role::ObstacleEdge, Role::Lidar}) {
        QVERIFY2(contrastRatio(theme.color(role), map) >= 3.0,
                 qPrintable(QString::number(int(role))));
      }
    }
  }

  void looks_haveDistinctMarks() {
    QSet<int> marks;
    for (int i = 0; i < kLookCount; ++i) {
      marks.insert(int(markOf(Look(i))));
    }
    QCOMPARE(marks.size(), kLookCount);
  }

  void fromSystem_darkPalette_isDark() {
    QVERIFY(Theme::fromSystem(Theme::dark().palette()).isDark());
    QVERIFY(!Theme::fromSystem(Theme::light().palette()).isDark());
  }
};

QTEST_MAIN(ThemeTest)
#include "tst_Theme.moc"
