#include <cmath>

#include <QImageReader>
#include <QJsonArray>
#include <QStandardPaths>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

constexpr double kDuration = 2.0;         // [s]
constexpr double kColumn = 85.0;          // [mm]
constexpr double kPxPerMm = 96.0 / 25.4;  // as CSS has them
constexpr double kPtPerMm = 72.0 / 25.4;

}  // namespace

/// `hunavsim render` from outside, its files read by Qt, ffprobe or as text.
class RenderProgramTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  Finished render(const QString& name, const QStringList& more = {},
                  const char* run = "run") const {
    return runProgram(list("render % -o %", {path(run), path(name)}) + more);
  }
  /// A figure of the run of 4 s.
  QByteArray rendered(const QString& name, const QStringList& more) const {
    const Finished made = render(name, more, "longer");
    return made.exitCode == 0 ? bytesOf(path(name)) : made.err.toUtf8();
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
    const QString cafe = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    QCOMPARE(
        failureOf("run % --duration % -q -o %", {cafe, QString::number(kDuration), path("run")}),
        QString());
    QCOMPARE(failureOf("run % --duration 4 -q -o %", {cafe, path("longer")}), QString());
  }

  /// Whatever is drawn twice has the same bytes.
  void picture_again_isTheSame_data() {
    QTest::addColumn<QString>("ending");
    for (const char* ending : {"png", "svg", "pdf", "gif", "html"}) {
      QTest::newRow(ending) << text(ending);
    }
  }
  void picture_again_isTheSame() {
    QFETCH(QString, ending);
    QVERIFY(render(text("a/b/1.") + ending).exitCode == 0);  // folders on the way are made
    const QByteArray bytes = bytesOf(path(text("a/b/1.") + ending));
    QVERIFY(bytes.size() > 1000);
    const int times = ending == text("gif") ? 1 : 4;  // orders by chance are the same now and then
    for (int time = 0; time < times; ++time) {
      QVERIFY(render(text("2.") + ending).exitCode == 0);
      QVERIFY(bytes == bytesOf(path(text("2.") + ending)));
    }
  }

  void theme_dark_hasADarkGround() {
    QVERIFY(render(text("dark.png"), {text("--theme"), text("dark")}).exitCode == 0);
    const QImage dark(path("dark.png"));
    QCOMPARE(dark.pixelColor(2, 2), QColor(0x2A, 0x2E, 0x33));
    QVERIFY(render(text("light.png"), {text("--theme"), text("light")}).exitCode == 0);
    QVERIFY(render(text("usual.png")).exitCode == 0);
    QVERIFY(bytesOf(path("light.png")) == bytesOf(path("usual.png")));
    QCOMPARE(render(text("x.html"), {text("--theme"), text("dark")}).exitCode, 64);
  }

  /// A third-party file is kept, unless --force is given; a file of hunavsim is replaced.
  void file_ofOthers_isLeftAlone_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"others/x.svg", "others/x.gif", "others/x.html", "others/x.mcap"}) {
      QTest::newRow(name) << text(name);
    }
  }
  void file_ofOthers_isLeftAlone() {
    QFETCH(QString, name);
    writeText(path(name), "mine");
    const Finished told = render(name);
    QCOMPARE(unexpected(told, 2, path(name)), QString());
    QVERIFY2(told.err.contains(text("--force")), qPrintable(told.err));
    QCOMPARE(bytesOf(path(name)), QByteArray("mine"));
    QCOMPARE(render(name, {text("--force")}).exitCode, 0);
    const QByteArray drawn = bytesOf(path(name));
    QVERIFY(drawn != "mine");
    QCOMPARE(render(name).exitCode, 0);
    writeText(path(name), drawn + "edited");
    QCOMPARE(render(name).exitCode, 2);
    QCOMPARE(bytesOf(path(name)), drawn + "edited");
  }

  void json_saysWhatWasWritten() {
    const Finished drawn = render(text("json/x.svg"), {text("--json")});
    QCOMPARE(drawn.exitCode, 0);
    const QJsonObject told = QJsonDocument::fromJson(drawn.out.toUtf8()).object();
    QCOMPARE(told.value(text("written")).toArray().at(0).toString(), path(text("json/x.svg")));
    const Finished wrong = render(text("json/x.tiff"), {text("--json")});
    QCOMPARE(wrong.exitCode, 64);
    const QJsonArray problems = QJsonDocument::fromJson(wrong.out.toUtf8()).array();
    QCOMPARE(problems.at(0).toObject().value(text("severity")).toString(), text("error"));
  }

  void svg_ofAColumn_needsNoFontAndHasItsWidth() {
    QVERIFY(render(text("column.svg"), {text("--width"), QString::number(kColumn)}).exitCode == 0);
    const QByteArray bytes = bytesOf(path(text("column.svg")));
    QVERIFY(!bytes.contains("<text"));
    QXmlStreamReader svg(bytes);
    QVERIFY(svg.readNextStartElement());
    const QStringList box = svg.attributes().value(text("viewBox")).toString().split(text(" "));
    QCOMPARE(box.size(), 4);
    QVERIFY(std::abs(box[2].toDouble() - kColumn * kPxPerMm) < 0.1);
    const QString width = svg.attributes().value(text("width")).toString();
    QVERIFY(width.endsWith(text("mm")));
    QVERIFY(std::abs(width.left(width.size() - 2).toDouble() - kColumn) < 0.2);
    while (!svg.atEnd()) {
      svg.readNext();
    }
    QVERIFY(!svg.hasError());
  }

  void pdf_ofAColumn_isOnePageOfItsWidth() {
    QVERIFY(render(text("column.pdf"), {text("--width"), QString::number(kColumn)}).exitCode == 0);
    const QByteArray bytes = bytesOf(path(text("column.pdf")));
    const QRegularExpression box(text("/MediaBox \\[0(?:\\.0*)? 0(?:\\.0*)? ([0-9.]+) "));
    const QRegularExpressionMatch found =
        box.match(QString(QLatin1String(bytes.constData(), bytes.size())));
    QVERIFY(found.hasMatch());
    QVERIFY(std::abs(found.captured(1).toDouble() - kColumn * kPtPerMm) < 1.0);
    QVERIFY(bytes.contains("/Count 1"));
    QVERIFY(bytes.contains("/FontFile"));  // embedded
  }

  /// Nobody has gone anywhere yet.
  void at_theBeginning_hasNoWays() {
    QVERIFY(render(text("whole.svg")).exitCode == 0);
    QVERIFY(render(text("begin.svg"), {text("--at"), text("0")}).exitCode == 0);
    const auto linesOf = [this](const QString& name) {
      return bytesOf(path(name)).count("<polyline");
    };
    QVERIFY(linesOf(text("begin.svg")) > 0);  // of scale and legend
    QVERIFY(linesOf(text("whole.svg")) > linesOf(text("begin.svg")) + 50);
  }

  void gif_framesAndTheirTime() {
    QVERIFY(render(text("film.gif"), {text("--fps"), text("10"), text("--width"), text("400")})
                .exitCode == 0);
    QImageReader film(path(text("film.gif")));
    QCOMPARE(film.imageCount(), 21);  // 0, 0.1 … 2 s
    QCOMPARE(film.loopCount(), -1);   // for ever
    QImage first = film.read();
    QCOMPARE(first.width(), 400);
    QCOMPARE(film.nextImageDelay(), 100);  // [ms]
    QImage last = first;
    while (film.canRead()) {
      last = film.read();
    }
    QVERIFY(first != last);
  }

  void film_byFfmpeg_framesAndSize_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("mp4") << text("film.mp4");
    QTest::newRow("webm") << text("film.webm");
  }
  void film_byFfmpeg_framesAndSize() {
    QFETCH(QString, name);
    if (QStandardPaths::findExecutable(text("ffprobe")).isEmpty()) {
      QCOMPARE(unexpected(render(name), 2, "ffmpeg"), QString());
      QSKIP("ffmpeg is not installed");
    }
    const Finished made = render(name, {text("--fps"), text("10"), text("--speed"), text("2"),
                                        text("--width"), text("321")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QProcess probe;
    probe.start(text("ffprobe"),
                {text("-v"), text("error"), text("-count_frames"), text("-show_entries"),
                 text("stream=nb_read_frames,width"), text("-of"), text("csv=p=0"), path(name)});
    const Finished probed = finishedOf(probe);
    QCOMPARE(probed.out.trimmed(), text("322,11"));  // even; 0, 0.2 … 2 s
    QCOMPARE(QDir(folder_.path()).entryList({text("*.new-*")}).size(), 0);
  }

  /// ffprobe of Debian 12 reads no moving WebP: its chunks are counted here.
  void film_webp_framesAndSize() {
    if (QStandardPaths::findExecutable(text("ffmpeg")).isEmpty()) {
      QSKIP("ffmpeg is not installed");
    }
    const Finished made = render(text("film.webp"), {text("--fps"), text("10"), text("--speed"),
                                                     text("2"), text("--width"), text("321")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QFile file(path(text("film.webp")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.startsWith("RIFF") && bytes.mid(8, 8) == "WEBPVP8X");
    const auto byteAt = [&](int place) { return static_cast<unsigned char>(bytes[place]); };
    QCOMPARE(byteAt(24) + 256 * byteAt(25) + 1, 322);  // width of the canvas, less one
    QCOMPARE(bytes.count("ANMF"), 11);
  }

  void wrongWords_areTold_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("more");
    QTest::newRow("ending") << text("x.tiff") << QStringList();
    QTest::newRow("instant of a film") << text("x.gif") << list("--at 1");
    QTest::newRow("rate of a picture") << text("x.png") << list("--fps 10");
    QTest::newRow("width of a page") << text("x.html") << list("--width 100");
    QTest::newRow("no number") << text("x.png") << list("--at nan");
    QTest::newRow("no rate") << text("x.mp4") << list("--fps nan");
    QTest::newRow("before the beginning") << text("x.svg") << list("--at -1");
    QTest::newRow("faster than viewers") << text("x.gif") << list("--fps 60");
    QTest::newRow("no width") << text("x.png") << list("--width -3");
  }
  void wrongWords_areTold() {
    QFETCH(QString, name);
    QFETCH(QStringList, more);
    const Finished told = render(name, more);
    QCOMPARE(told.exitCode, 64);
    QVERIFY(!told.err.isEmpty());
    QVERIFY(!QFile::exists(path(name)));
  }

  void folderThatCannotBe_isTold_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("png") << text("file/x.png");
    QTest::newRow("gif") << text("file/x.gif");
    QTest::newRow("mp4") << text("file/x.mp4");
  }
  void folderThatCannotBe_isTold() {
    QFETCH(QString, name);
    writeText(path(text("file")), "no folder");
    const Finished told = render(name);
    QCOMPARE(told.exitCode, 2);
    QVERIFY(!told.err.isEmpty());
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

  void figures_wrongWords_areTold_data() {
    QTest::addColumn<QStringList>("more");
    QTest::addColumn<QString>("says");
    QTest::newRow("no number") << list("--strip x") << text("--strip takes");
    QTest::newRow("none") << list("--strip 0") << text("--strip takes");
    QTest::newRow("too many") << list("--strip 25") << text("--strip takes");
    QTest::newRow("half a number") << list("--strip 2.5") << text("--strip takes");
    QTest::newRow("overlay") << list("--overlay fog") << text("density");
    QTest::newRow("metric") << list("--plot avg_distance_to_closest_persn")
                            << text("avg_distance_to_closest_person");
    QTest::newRow("metric without series")
        << list("--plot time_to_reach_goal") << text("has no value over time");
  }
  void figures_wrongWords_areTold() {
    QFETCH(QStringList, more);
    QFETCH(QString, says);
    const Finished told = render(text("w.svg"), more, "longer");
    QVERIFY2(told.exitCode == 64 || told.exitCode == 2, qPrintable(told.err));
    QVERIFY2(told.err.contains(says), qPrintable(told.err));
    QVERIFY(!QFile::exists(path(text("w.svg"))));
  }
};

QTEST_GUILESS_MAIN(RenderProgramTest)
#include "tst_RenderProgram.moc"
