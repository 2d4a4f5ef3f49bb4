#include <cmath>

#include <QJsonArray>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/app/ContactScene.h"
#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

QString words(const char* text) {
  return QString::fromUtf8(text);
}

constexpr const char* kExperiment = R"(hunavsim_experiment: 1
scenarios: [fast.yaml]
seeds: 1
values:
  robot1.max_vel: [0.5, 3.0]
)";

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeTo(const QTemporaryDir& folder, const char* name, const char* content) {
  QFile file(folder.filePath(words(name)));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(content);
}

Finished inFolder(const QTemporaryDir& folder, const char* line) {
  return runProgram(words(line).split(QLatin1Char(' ')), folder.path());
}

}  // namespace

/// `contacts` from outside.
class ContactsProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    writeTo(folder_, "fast.yaml", kFastRobot);
    writeTo(folder_, "study.yaml", kExperiment);
    const Finished run = inFolder(folder_, "run fast.yaml -o out -q");
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
  }

  /// The robot's speed grows with 1 m/s² and the person walks away: braking takes longer than the
  /// time that is left at the contact.
  void run_json_hasActionsBeforeTheContact() {
    const Finished json = inFolder(folder_, "contacts out -o tables --json");
    QVERIFY2(json.exitCode == 0, qPrintable(json.err));
    const QJsonArray reports = QJsonDocument::fromJson(json.out.toUtf8()).array();
    QCOMPARE(reports.size(), 1);
    const QJsonArray contacts = reports[0].toObject()[words("contacts")].toArray();
    const int touches = contentOf(folder_.filePath(words("out/events.csv"))).count("contact,-1,");
    QVERIFY(!contacts.isEmpty() && contacts.size() <= touches);
    for (const auto& value : contacts) {
      const QJsonObject contact = value.toObject();
      const QJsonObject robot = contact[words("by_robot")].toObject();
      const double time = contact[words("time")].toDouble();
      const double action = robot[words("last_action")].toDouble();
      QVERIFY(action > 0.0 && action < time);
      QVERIFY(!robot[words("manoeuvre")].toString().isEmpty());
      QVERIFY(robot[words("robot_path")].toArray().size() > 2);
      QCOMPARE(robot[words("could_avoid")].toBool(), true);
      QCOMPARE(robot[words("braking_at_first_sight_avoids")].toBool(), true);
      QCOMPARE(contact[words("without")].toArray().size(), 1);
    }
    QCOMPARE(reports[0].toObject()[words("people")].toArray().size(), 2);
  }

  /// People in the run without the robot, in the tables of the analysis before, against
  /// `run --counterfactual`.
  void people_areThoseOfTheCounterfactual() {
    const Finished run = inFolder(folder_, "run fast.yaml -o compared -q --counterfactual");
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const QList<QByteArray> expected =
        contentOf(folder_.filePath(words("compared/counterfactual.csv"))).trimmed().split('\n');
    const QList<QByteArray> found =
        contentOf(folder_.filePath(words("tables/contact_people.csv"))).trimmed().split('\n');
    QCOMPARE(found.size(), expected.size());
    for (int k = 0; k < found.size(); ++k) {
      QVERIFY2(found[k].endsWith(expected[k]), found[k].constData());
    }
  }

  void output_hasTablesAndPictures() {
    const Finished told = inFolder(folder_, "contacts out -o out --quick");
    QVERIFY2(told.exitCode == 0, qPrintable(told.err));
    QVERIFY2(told.out.contains(words("could avoid")), qPrintable(told.out));
    const QByteArray table = contentOf(folder_.filePath(words("out/contacts.csv")));
    QVERIFY(table.startsWith("run,scenario,seed,planners,time,robot,person,"));
    QVERIFY(table.contains("out,fast_robot,1,pursuit,"));
    const QByteArray picture = contentOf(folder_.filePath(words("out/figures/contact_1.svg")));
    QVERIFY(picture.contains("with the manoeuvre"));
    QXmlStreamReader xml(picture);
    while (!xml.atEnd()) {
      xml.readNext();
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    // The folder is still a run, and a second analysis replaces the first one.
    QCOMPARE(inFolder(folder_, "evaluate out -o measured -q").exitCode, 0);
    QCOMPARE(inFolder(folder_, "contacts out -o out --quick -q").exitCode, 0);
  }

  void batch_hasRowsOfItsRuns_forAnyNumberOfJobs() {
    QCOMPARE(inFolder(folder_, "batch study.yaml -o batch -q --jobs 1").exitCode, 0);
    const Finished one = inFolder(folder_, "contacts batch -o one --jobs 1 --range 0");
    QVERIFY2(one.exitCode == 0, qPrintable(one.err));
    QVERIFY2(one.out.contains(words("delay per person")), qPrintable(one.out));
    QCOMPARE(inFolder(folder_, "contacts batch -o two --jobs 2 -q --range 0").exitCode, 0);
    for (const char* name : {"contacts.csv", "contact_people.csv", "contact_planners.csv"}) {
      const QByteArray table = contentOf(folder_.filePath(words("one/") + words(name)));
      QVERIFY(!table.isEmpty());
      QCOMPARE(contentOf(folder_.filePath(words("two/") + words(name))), table);
    }
    const QByteArray people = contentOf(folder_.filePath(words("one/contact_people.csv")));
    QCOMPARE(people.count('\n'), 1 + 2 * 2);  // 2 runs with 2 people
    const QByteArray planners = contentOf(folder_.filePath(words("one/contact_planners.csv")));
    QVERIFY2(planners.contains("\npursuit,2,4,"), planners.constData());
  }

  /// The tables of the report against those of the analysis before.
  void report_hasTheContactsOfTheBatch() {
    QCOMPARE(inFolder(folder_, "report batch --no-pdf -q").exitCode, 0);
    QVERIFY(!contentOf(folder_.filePath(words("batch/report.html"))).contains("id=\"contacts\""));
    QVERIFY(!QFile::exists(folder_.filePath(words("batch/tables/contacts.csv"))));
    const Finished told = inFolder(folder_, "report batch --no-pdf --contacts --jobs 2 -q");
    QVERIFY2(told.exitCode == 0, qPrintable(told.err));
    const QByteArray page = contentOf(folder_.filePath(words("batch/report.html")));
    QVERIFY(page.contains("id=\"contacts\"") && page.contains("report batch --no-pdf --contacts"));
    QVERIFY(!page.contains("--jobs"));
    const auto expected = readCsv(folder_.filePath(words("one/contacts.csv")));
    const auto found = readCsv(folder_.filePath(words("batch/tables/contacts.csv")));
    QCOMPARE(found.size(), expected.size());
    QVERIFY(!found.empty());
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto differs = [&](const char* shown, const char* column) {
        return found[k].at(words(shown)) != expected[k].at(words(column));
      };
      QVERIFY(!differs("Run", "run") && !differs("Person", "person"));
      QVERIFY(!differs("Could avoid", "could_avoid"));
      const double until = expected[k].at(words("robot_last_action")).toDouble();
      QVERIFY(std::fabs(found[k].at(words("Robot until [s]")).toDouble() - until) < 0.0051);
      QVERIFY(found[k].at(words("Play")).startsWith(words("hunavsim ")));
    }
    QCOMPARE(contentOf(folder_.filePath(words("batch/tables/contact_people_runs.csv"))),
             contentOf(folder_.filePath(words("one/contact_people.csv"))));
    checkPeople();
    const auto planners = readCsv(folder_.filePath(words("batch/tables/contact_planners.csv")));
    QCOMPARE(planners.size(), std::size_t{1});
    QCOMPARE(planners[0].at(words("Contacts")).toInt(), static_cast<int>(found.size()));
    QCOMPARE(inFolder(folder_, "report batch --jobs 2").exitCode, 64);  // only with --contacts
  }

  void wrongInput_isRefused() {
    QCOMPARE(inFolder(folder_, "contacts nowhere").exitCode, 2);
    QCOMPARE(inFolder(folder_, "contacts out --lookback 0").exitCode, 64);
    QCOMPARE(inFolder(folder_, "contacts out --settle -1").exitCode, 64);
    QCOMPARE(inFolder(folder_, "contacts out --range 1e9").exitCode, 64);
    QCOMPARE(inFolder(folder_, "contacts").exitCode, 64);
    // Another scenario than the one of the run.
    const QTemporaryDir changed;
    writeTo(changed, "fast.yaml", kFastRobot);
    QCOMPARE(inFolder(changed, "run fast.yaml -o out -q").exitCode, 0);
    writeTo(changed, "fast.yaml", QByteArray(kFastRobot).replace("3.0", "2.5").constData());
    const Finished refused = inFolder(changed, "contacts out");
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.err.contains(words("no longer the input of the run")),
             qPrintable(refused.err));
  }

 private:
  /// Means per person over the two runs, from the rows of the analysis.
  void checkPeople() const {
    const auto rows = readCsv(folder_.filePath(words("one/contact_people.csv")));
    const auto people = readCsv(folder_.filePath(words("batch/tables/contact_people.csv")));
    QCOMPARE(people.size(), std::size_t{2});
    for (const auto& person : people) {
      double detour = 0.0;
      int runs = 0;
      for (const auto& row : rows) {
        if (row.at(words("person")) == person.at(words("Person"))) {
          detour += row.at(words("detour")).toDouble();
          ++runs;
        }
      }
      QCOMPARE(person.at(words("Runs")).toInt(), runs);
      QVERIFY(std::fabs(person.at(words("Detour [m]")).toDouble() - detour / runs) < 0.0051);
    }
  }

  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(ContactsProgramTest)
#include "tst_ContactsProgram.moc"
