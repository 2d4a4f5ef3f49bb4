#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::text;

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

QString browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    QString path = QStandardPaths::findExecutable(text(name));
    if (!path.isEmpty()) {
      return path;
    }
  }
  return {};
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
    const outside::Finished made =
        outside::runProgram({text("run"), text("corner_cafe_agents"), text("--duration"), text("6"),
                             text("-q"), text("-o"), run});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    const QString page = folder.filePath(text("run.html"));
    const outside::Finished rendered = outside::runProgram({text("render"), run, text("-o"), page});
    QVERIFY2(rendered.exitCode == 0, qPrintable(rendered.err));
    QByteArray html = outside::bytesOf(page);
    QCOMPARE(html.count("</body>"), 1);
    outside::writeText(page, html.replace("</body>", kReader));

    QProcess process;
    process.start(browser(), {text("--headless"), text("--no-sandbox"), text("--disable-gpu"),
                              text("--user-data-dir=") + folder.filePath(text("browser")),
                              text("--virtual-time-budget=90000"), text("--dump-dom"),
                              text("file://") + page});
    QVERIFY(process.waitForFinished(50000));
    const QString seen = QString::fromUtf8(process.readAllStandardOutput());
    const QString title = seen.section(text("<title>"), 1).section(text("</title>"), 0, 0);
    const QJsonObject found = QJsonDocument::fromJson(title.toUtf8()).object();
    QVERIFY2(!found.isEmpty(), qPrintable(title));
    QCOMPARE(found.value(text("begin")).toDouble(), 0.0);
    QCOMPARE(found.value(text("label")).toString(), text("Pause"));
    const double played = found.value(text("played")).toDouble();
    QVERIFY2(played > 0.0 && played <= 6.0, qPrintable(title));
    QCOMPARE(found.value(text("isPaused")).toString(), text("Play"));
    QVERIFY2(found.value(text("isPainted")).toBool(), qPrintable(title));
    QVERIFY(std::abs(found.value(text("length")).toDouble() - 6.0) < 0.06);
    QVERIFY(std::abs(found.value(text("end")).toDouble() - 6.0) < 0.06);
  }
};

QTEST_GUILESS_MAIN(ReportPlayerTest)
#include "tst_ReportPlayer.moc"
