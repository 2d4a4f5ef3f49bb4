#include <QtTest>

#include "app/cli/RunProgress.h"

class RunProgressTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void runProgressText_byNumbers_data() {
    QTest::addColumn<int>("finished");
    QTest::addColumn<double>("rate");
    QTest::addColumn<bool>("mayEndEarlier");
    QTest::addColumn<QString>("text");
    QTest::newRow("start") << 0 << 0.0 << false << "0 / 100 runs";
    QTest::newRow("batch") << 40 << 2.0 << false << "40 / 100 runs, 2.0 runs/s, 30 s left";
    QTest::newRow("limit") << 40 << 0.5 << true
                           << "40 / at most 100 runs, 0.5 runs/s, at most 2 min 00 s left";
    QTest::newRow("beyond the limit") << 120 << 4.04 << true << "120 runs, 4.0 runs/s";
  }
  void runProgressText_byNumbers() {
    QFETCH(int, finished);
    QFETCH(double, rate);
    QFETCH(bool, mayEndEarlier);
    QFETCH(QString, text);
    QCOMPARE(QString::fromStdString(app::runProgressText(static_cast<std::size_t>(finished), 100,
                                                         rate, mayEndEarlier)),
             text);
  }
};

QTEST_APPLESS_MAIN(RunProgressTest)
#include "tst_RunProgress.moc"
