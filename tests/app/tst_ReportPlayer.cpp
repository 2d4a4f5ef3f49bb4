#include <QJsonArray>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/StudyFiles.h"

using namespace outside;

namespace {

/// Presses what a reader presses, with a script of the test's own in the page; what came of it is
/// the title of the page.
constexpr char kReader[] = R"(<script>//<![CDATA[
window.addEventListener("load", function () {
  var box = document.querySelector(".player"), toggle = box.querySelector(".toggle");
  var clock = box.querySelector("output"), slider = box.querySelector("input[type=range]");
  var canvas = box.querySelector("canvas");
  function picture() {
    var bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    var sum = 0;
    for (var k = 0; k < bytes.length; k += 1) { sum = (sum * 31 + bytes[k]) % 1000000007; }
    return sum;
  }
  function seconds() { return parseFloat(clock.textContent); }
  var begin = seconds(), first = picture();
  toggle.click();
  var label = toggle.textContent, waits = 0;
  function look() {  // a busy machine paints its first frame late
    var second = picture();
    waits += 1;
    if ((seconds() < 1 || second === first) && waits < 600) { setTimeout(look, 100); return; }
    toggle.click();
    var played = seconds();
    slider.value = slider.max;
    slider.dispatchEvent(new Event("input"));
    document.title = JSON.stringify({begin: begin, label: label, played: played, end: seconds(),
      length: parseFloat(slider.max), isPainted: first !== 0 && first !== second,
      isPaused: toggle.textContent});
  }
  setTimeout(look, 100);
});
//]]></script></body>)";

/// The same for a page of several runs: chooses the second, then presses Play in the table.
constexpr char kChooser[] = R"(<script>//<![CDATA[
window.addEventListener("load", function () {
  var box = document.querySelector(".player"), choice = box.querySelector("header select");
  var names = Array.prototype.map.call(choice.options, function (o) { return o.textContent; });
  var groups = Array.prototype.map.call(choice.querySelectorAll("optgroup"),
    function (o) { return o.label; });
  var first = box.querySelector("header b").textContent;
  choice.value = "1";
  choice.dispatchEvent(new Event("change"));
  var second = box.querySelector("header b").textContent;
  var label = box.querySelector(".toggle").textContent;
  var plays = document.querySelectorAll("button.play");
  plays[2].click();
  document.title = JSON.stringify({names: names, groups: groups, first: first, second: second,
    label: label, third: box.querySelector("header b").textContent, chosen: choice.value,
    plays: plays.length, playing: box.querySelector(".toggle").textContent});
});
//]]></script></body>)";

QString browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    QString path = QStandardPaths::findExecutable(text(name));
    if (!path.isEmpty()) {
      return path;
    }
  }
  return {};
}

/// What a reader's script says of a page.
QJsonObject readBy(const char* reader, const QString& page, const QString& profile) {
  QByteArray html = bytesOf(page);
  writeText(page, html.replace("</body>", reader));
  QProcess process;
  process.start(browser(), {text("--headless"), text("--no-sandbox"), text("--disable-gpu"),
                            text("--user-data-dir=") + profile, text("--virtual-time-budget=90000"),
                            text("--dump-dom"), text("file://") + page});
  if (!process.waitForFinished(50000)) {
    return {};
  }
  const QString seen = QString::fromUtf8(process.readAllStandardOutput());
  const QString title = seen.section(text("<title>"), 1).section(text("</title>"), 0, 0);
  return QJsonDocument::fromJson(title.toUtf8()).object();
}

}  // namespace

/// The player of a page in a real browser.
class ReportPlayerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void player_clicked_playsAndPauses() {
    if (browser().isEmpty()) {
      QSKIP("there is no Chromium here");
    }
    QTemporaryDir folder;
    const QString run = folder.filePath(text("run"));
    QCOMPARE(failureOf("run corner_cafe_agents --duration 6 -q -o %", {run}), QString());
    const QString page = folder.filePath(text("run.html"));
    QCOMPARE(failureOf("render % -o %", {run, page}), QString());
    QCOMPARE(bytesOf(page).count("</body>"), 1);
    const QJsonObject found = readBy(kReader, page, folder.filePath(text("browser")));
    const QByteArray title = QJsonDocument(found).toJson();
    QVERIFY(!found.isEmpty());
    QCOMPARE(found.value(text("begin")).toDouble(), 0.0);
    QCOMPARE(found.value(text("label")).toString(), text("Pause"));
    const double played = found.value(text("played")).toDouble();
    QVERIFY2(played > 0.0 && played <= 6.0, title.constData());
    QCOMPARE(found.value(text("isPaused")).toString(), text("Play"));
    QVERIFY2(found.value(text("isPainted")).toBool(), title.constData());
    QVERIFY(std::abs(found.value(text("length")).toDouble() - 6.0) < 0.06);
    QVERIFY(std::abs(found.value(text("end")).toDouble() - 6.0) < 0.06);
  }

  void player_severalRuns_canBeChosen() {
    if (browser().isEmpty()) {
      QSKIP("there is no Chromium here");
    }
    const StudyFolder yard;
    const QString out = yard.path(text("out"));
    const QString study = yard.writeStudy("short.yaml",
                                          "duration: 2.0\nseeds: 2\nrecord: all\nvalues:\n"
                                          "  robot1.planner: [pursuit, dwa]\n");
    QCOMPARE(failureOf("batch % -o %", {study, out}), QString());
    QCOMPARE(failureOf("report % --no-pdf", {out}), QString());
    const QJsonObject found =
        readBy(kChooser, out + text("/report.html"), yard.path(text("browser")));
    const QByteArray all = QJsonDocument(found).toJson();
    const QJsonArray names = found.value(text("names")).toArray();
    QVERIFY2(names.size() == 4, all.constData());
    QVERIFY2(names.at(2).toString().startsWith(text("Run 2, dwa, yard.yaml, seed 1: ")),
             all.constData());
    QCOMPARE(found.value(text("groups")).toArray(), QJsonArray({text("Without success")}));
    QCOMPARE(found.value(text("plays")).toInt(), 4);
    QCOMPARE(found.value(text("first")).toString(), text("Run 0"));
    QCOMPARE(found.value(text("second")).toString(), text("Run 1"));
    QCOMPARE(found.value(text("label")).toString(), text("Play"));
    QCOMPARE(found.value(text("third")).toString(), text("Run 2"));
    QCOMPARE(found.value(text("chosen")).toString(), text("2"));
    QCOMPARE(found.value(text("playing")).toString(), text("Pause"));
  }
};

QTEST_GUILESS_MAIN(ReportPlayerTest)
#include "tst_ReportPlayer.moc"
