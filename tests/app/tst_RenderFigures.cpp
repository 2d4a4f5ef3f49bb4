#include <cmath>

#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::Finished;
using outside::text;

/// Strips, plots and overlays of `hunavsim render`.
class RenderFiguresTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString path(const QString& name) const { return folder_.filePath(name); }
  Finished render(const QString& name, const QStringList& more = {}) const {
    return outside::runProgram(
        QStringList{text("render"), path(text("run")), text("-o"), path(name)} + more);
  }
  QByteArray rendered(const QString& name, const QStringList& more) const {
    const Finished made = render(name, more);
    return made.exitCode == 0 ? outside::bytesOf(path(name)) : made.err.toUtf8();
  }
  /// Width and height of its view box; (0, 0) when it cannot be read.
  static QSizeF sizeOf(const QByteArray& svg) {
    QXmlStreamReader reader(svg);
    const QStringList box =
        reader.readNextStartElement()
            ? reader.attributes().value(text("viewBox")).toString().split(text(" "))
            : QStringList();
    while (!reader.atEnd()) {
      reader.readNext();
    }
    return box.size() == 4 && !reader.hasError() ? QSizeF(box[2].toDouble(), box[3].toDouble())
                                                 : QSizeF(0.0, 0.0);
  }

 private Q_SLOTS:
  void initTestCase() {
    const Finished made = outside::runProgram(
        {text("run"), text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"),
         text("--duration"), text("4"), text("-q"), text("-o"), path(text("run"))});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
  }

  /// Three at equal distances over 4 s are those at 0, 2 and 4 s.
  void strip_ofANumber_isThatOfItsTimes() {
    const QByteArray byNumber = rendered(text("n.svg"), {text("--strip"), text("3")});
    const QByteArray byTimes = rendered(text("t.svg"), {text("--strip"), text("0,2,4")});
    QVERIFY2(sizeOf(byNumber).width() > 0.0, byNumber.left(300).constData());
    QVERIFY(byNumber == byTimes);
    QVERIFY(byNumber != rendered(text("o.svg"), {text("--strip"), text("0,2,3")}));
    QVERIFY(!byNumber.contains("<text"));
  }

  /// The run ends at 4 s: a map that shows its end must not say 99 s.
  void strip_beyondTheEnd_tellsTheTimeThatItShows() {
    const QByteArray atEnd = rendered(text("e.svg"), {text("--strip"), text("0,2,4")});
    QVERIFY2(sizeOf(atEnd).width() > 0.0, atEnd.left(300).constData());
    QVERIFY(atEnd == rendered(text("b.svg"), {text("--strip"), text("0,2,99")}));
  }

  void strip_ofAColumn_isAsWideAsIt() {
    const QByteArray svg =
        rendered(text("c.svg"), {text("--strip"), text("4"), text("--width"), text("85")});
    QVERIFY(std::abs(sizeOf(svg).width() - 85.0 * 96.0 / 25.4) < 0.1);
    QVERIFY(sizeOf(svg).height() < 2.0 * sizeOf(svg).width());
  }

  void overlays_areDrawn_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"density", "zones", "gaussian", "velocities"}) {
      QTest::newRow(name) << text(name);
    }
  }
  void overlays_areDrawn() {
    QFETCH(QString, name);
    const QByteArray plain = rendered(text("plain.svg"), {text("--at"), text("2")});
    const QByteArray more =
        rendered(text("more.svg"), {text("--at"), text("2"), text("--overlay"), name});
    QVERIFY2(sizeOf(more).width() > 0.0, more.left(300).constData());
    QVERIFY(more.size() > plain.size());
    QVERIFY(sizeOf(more).height() > sizeOf(plain).height());  // the key has its line
  }

  void timeMarks_areDotsOnTheWays() {
    const auto dots = [this](const QStringList& more) {
      return rendered(text("dots.svg"), more).count("<circle") +
             rendered(text("dots.svg"), more).count("<ellipse");
    };
    const int without = dots({});
    const int with = dots({text("--time-marks"), text("1")});
    // Eight people and a robot, four marks each at most.
    QVERIFY2(with > without + 18 && with <= without + 2 * 36, qPrintable(QString::number(with)));
  }

  void plot_ofMetrics_isAFigure() {
    const QByteArray one =
        rendered(text("p.svg"), {text("--plot"), text("avg_robot_linear_speed")});
    const QByteArray two =
        rendered(text("q.svg"),
                 {text("--plot"), text("avg_distance_to_closest_person,avg_robot_linear_speed")});
    QVERIFY2(sizeOf(one).width() > 0.0, one.left(300).constData());
    QVERIFY2(sizeOf(two).width() > 0.0, two.left(300).constData());
    QVERIFY(sizeOf(two).height() > sizeOf(one).height() + 80.0);
    QVERIFY(two.count("stroke=\"#0072B2\"") >= 2);  // the curves
  }

  void wrongWords_areTold_data() {
    QTest::addColumn<QStringList>("more");
    QTest::addColumn<QString>("says");
    QTest::newRow("no number") << QStringList{text("--strip"), text("x")} << text("--strip takes");
    QTest::newRow("none") << QStringList{text("--strip"), text("0")} << text("--strip takes");
    QTest::newRow("too many") << QStringList{text("--strip"), text("25")} << text("--strip takes");
    QTest::newRow("half a number")
        << QStringList{text("--strip"), text("2.5")} << text("--strip takes");
    QTest::newRow("overlay") << QStringList{text("--overlay"), text("fog")} << text("density");
    QTest::newRow("metric") << QStringList{text("--plot"), text("avg_distance_to_closest_persn")}
                            << text("avg_distance_to_closest_person");
    QTest::newRow("metric without series")
        << QStringList{text("--plot"), text("time_to_reach_goal")}
        << text("has no value over time");
  }
  void wrongWords_areTold() {
    QFETCH(QStringList, more);
    QFETCH(QString, says);
    const Finished told = render(text("w.svg"), more);
    QVERIFY2(told.exitCode == 64 || told.exitCode == 2, qPrintable(told.err));
    QVERIFY2(told.err.contains(says), qPrintable(told.err));
    QVERIFY(!QFile::exists(path(text("w.svg"))));
  }
};

QTEST_MAIN(RenderFiguresTest)
#include "tst_RenderFigures.moc"
