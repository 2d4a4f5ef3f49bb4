#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include <QtTest>

#include "tests/capsule/SmallStudy.h"

using outside::text;
using small::AlteredCapsule;

namespace {

enum Hidden { Openly, InCapsule, Everywhere };  // where checksums are renewed after the change
enum Runs { NoRuns, AllRuns };                  // which are repeated

/// A change of a packed study, and the difference that must be among those found.
struct Tampering {
  const char* name;
  Hidden hidden;
  Runs runs;
  std::function<bool(const AlteredCapsule&)> change;  // false: there is nothing to change
  const char* place;                                  // member of the difference
  const char* message;                                // part of it
};

std::function<bool(const AlteredCapsule&)> replacing(const char* member, const char* was,
                                                     const char* by) {
  return [=](const AlteredCapsule& in) { return in.replace(member, was, by); };
}

std::function<bool(const AlteredCapsule&)> removing(const char* member) {
  return [=](const AlteredCapsule& in) { return QFile::remove(in.path(member)); };
}

std::function<bool(const AlteredCapsule&)> adding(const char* member) {
  return [=](const AlteredCapsule& in) {
    outside::writeText(in.path(member), "added");
    return true;
  };
}

/// Changes a byte in the middle of a member.
std::function<bool(const AlteredCapsule&)> flipping(const char* member) {
  return [=](const AlteredCapsule& in) {
    QByteArray bytes = outside::bytesOf(in.path(member));
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    outside::writeText(in.path(member), bytes);
    return true;
  };
}

/// Changes lines of a member.
std::function<bool(const AlteredCapsule&)> editing(const char* member,
                                                   void (*edit)(QList<QByteArray>& lines)) {
  return [=](const AlteredCapsule& in) {
    QList<QByteArray> lines = outside::bytesOf(in.path(member)).split('\n');
    edit(lines);
    outside::writeText(in.path(member), lines.join('\n'));
    return true;
  };
}

/// Changes a field of a line of a CSV file: a digit of its end.
QByteArray withOtherField(const QByteArray& line, int column) {
  QList<QByteArray> fields = line.split(',');
  QByteArray& field = fields[column];
  field[field.size() - 1] = field.endsWith('7') ? '3' : '7';
  return fields.join(',');
}

int columnOf(const QByteArray& header, const char* name) {
  return header.split(',').indexOf(name);
}

/// The same number in results.csv and results.sqlite.
bool changeBothTables(const AlteredCapsule& in) {
  const std::string path = in.path("study/results.sqlite").toStdString();
  const std::string other = path + ".new";
  const auto store = app::ResultStore::open(path);
  const auto changed = app::ResultStore::create(other, (*store)->study());
  base::Diagnostics problems = (*store)->forEach([&](const app::StoredRun& stored) {
    app::StoredRun run = stored;
    for (auto& [column, field] : run.row.fields) {
      if (run.run == 1 && column == "path_length") {
        field = "3.25";
      }
    }
    base::append(problems, (*changed)->add(run));
  });
  const std::string csv = in.path("study/results.csv").toStdString();
  base::append(problems, app::writeResults(**changed, csv));
  base::append(problems, (*changed)->close());
  QFile::remove(small::textOf(path));
  return problems.empty() && QFile::rename(small::textOf(other), small::textOf(path));
}

bool removeRunFolder(const AlteredCapsule& in) {
  return QDir(in.path("study/runs/0")).removeRecursively();
}

bool changeRecordedInput(const AlteredCapsule& in) {
  nlohmann::ordered_json manifest = in.readJson("manifest.json");
  manifest["inputs"].erase(1);
  outside::writeText(in.path("manifest.json"), QByteArray::fromStdString(manifest.dump()));
  return true;
}

const char* const kMap = "inputs/files/two_workers.pgm";
const char* const kTree = "inputs/files/two_workers_agents__agent_1_bt.xml";
const char* const kYard = "inputs/files/yard.yaml";
const char* const kExperiment = "inputs/files/study.yaml";
const char* const kResults = "study/results.csv";
const char* const kTrack = "study/runs/0/trajectory.csv";

void changeMetric(QList<QByteArray>& lines) {
  lines[2] = withOtherField(lines[2], columnOf(lines[0], "path_length"));
}
void changeSeed(QList<QByteArray>& lines) {
  lines[2] = withOtherField(lines[2], columnOf(lines[0], "seed"));
}
void changeScenario(QList<QByteArray>& lines) {
  lines[3].replace("two_workers_agents.yaml", "two_workers_agents.yml");
}
void changeDrawnValue(QList<QByteArray>& lines) {
  lines[1] = withOtherField(lines[1], columnOf(lines[0], "*.max_vel"));
}
void changeStatus(QList<QByteArray>& lines) {
  lines[1].replace(",ok,", ",failed,");
}
void removeRow(QList<QByteArray>& lines) {
  lines.removeAt(2);
}
void addRow(QList<QByteArray>& lines) {
  lines.insert(5, "9" + lines[4].mid(1));
}
void changeTrack(QList<QByteArray>& lines) {  // line 41: step 13 of the second of three bodies
  lines[41] = withOtherField(lines[41], columnOf(lines[0], "x"));
}

const Tampering kTamperings[] = {
    // A file is edited.
    {"digit in the results", Openly, NoRuns, editing(kResults, changeMetric), kResults, "SHA-256"},
    {"pixel of the map", Openly, NoRuns, flipping(kMap), kMap, "SHA-256 that manifest.json"},
    {"seed in the experiment", Openly, NoRuns, replacing(kExperiment, "[3, 7]", "[3, 8]"),
     kExperiment, "SHA-256"},
    {"node of a tree", Openly, NoRuns, replacing(kTree, "delay=\"2.0\"", "delay=\"2.5\""), kTree,
     "SHA-256"},
    {"parameter of a person", Openly, NoRuns, replacing(kYard, "max_vel: 1.2", "max_vel: 1.3"),
     kYard, "is not the file that the study has read"},
    {"missing trajectory", Openly, NoRuns, removing(kTrack), kTrack, "missing"},
    {"missing map", Openly, NoRuns, removing(kMap), kMap, "missing"},
    {"missing results", Openly, NoRuns, removing(kResults), kResults, "missing"},
    {"missing database", Openly, NoRuns, removing("study/results.sqlite"), "study/results.sqlite",
     "missing"},
    {"missing checksums", Openly, NoRuns, removing("SHA256SUMS"), "SHA256SUMS", "missing"},
    {"additional file", Openly, NoRuns, adding("study/extra.csv"), "study/extra.csv",
     "not part of the capsule"},
    {"additional input", Openly, NoRuns, adding("inputs/files/yard__agent_1_bt.xml"),
     "inputs/files/yard__agent_1_bt.xml", "not part of the capsule"},
    {"renamed input", Openly, NoRuns,
     [](const AlteredCapsule& in) {
       return QFile::rename(in.path(kYard), in.path("inputs/files/yard2.yaml"));
     },
     kYard, "missing"},
    {"version in the manifest", Openly, NoRuns,
     replacing("manifest.json", "\"format\": 1", "\"format\":  1"), "manifest.json",
     "SHA-256 that SHA256SUMS"},
    {"hash in the manifest", Openly, NoRuns,
     [](const AlteredCapsule& in) {
       return in.replace(
           "manifest.json",
           in.readJson("manifest.json")["outputs"][3]["sha256"].get<std::string>().c_str(),
           QByteArray(64, '0'));
     },
     "manifest.json", "SHA-256 that SHA256SUMS"},
    {"hash in the checksums", Openly, NoRuns,
     editing("SHA256SUMS", [](QList<QByteArray>& lines) { lines[1][0] = 'x'; }),
     "inputs/files/study.yaml", "SHA-256 that SHA256SUMS"},
    {"line of the checksums", Openly, NoRuns,
     editing("SHA256SUMS", [](QList<QByteArray>& lines) { lines.removeAt(1); }),
     "inputs/files/study.yaml", "SHA-256 that SHA256SUMS"},
    {"methods text", Openly, NoRuns, replacing("methods.html", "Wilcoxon", "Wilcoxen"),
     "methods.html", "SHA-256"},
    {"reference", Openly, NoRuns, replacing("references.bib", "2025", "2024"), "references.bib",
     "SHA-256"},
    {"type", Openly, NoRuns, replacing("mimetype", "x-hunavsim", "y-hunavsim"), "mimetype",
     "SHA-256"},
    {"bit of the database", Openly, NoRuns, flipping("study/results.sqlite"),
     "study/results.sqlite", "SHA-256"},
    {"empty file", Openly, NoRuns,
     [](const AlteredCapsule& in) {
       outside::writeText(in.path(kTrack), "");
       return true;
     },
     kTrack, "SHA-256"},

    // The checksums of the capsule are updated too.
    {"hidden: digit in the results", InCapsule, NoRuns, editing(kResults, changeMetric), kResults,
     "run 1: path_length is"},
    {"hidden: status of a run", InCapsule, NoRuns, editing(kResults, changeStatus), kResults,
     "run 0: status is failed, but results.sqlite has ok"},
    {"hidden: seed of a run", InCapsule, NoRuns, editing(kResults, changeSeed), kResults,
     "run 1: seed is 3, but the experiment gives 7"},
    {"hidden: scenario of a run", InCapsule, NoRuns, editing(kResults, changeScenario), kResults,
     "run 2: scenario is two_workers_agents.yml, but the experiment gives two_workers_agents.yaml"},
    {"hidden: drawn value of a run", InCapsule, NoRuns, editing(kResults, changeDrawnValue),
     kResults, "run 0: *.max_vel is"},
    {"hidden: missing row", InCapsule, NoRuns, editing(kResults, removeRow), kResults,
     "there is no row of run 1"},
    {"hidden: additional row", InCapsule, NoRuns, editing(kResults, addRow), kResults,
     "run 9 is not part of the study"},
    {"hidden: pixel of the map", InCapsule, NoRuns, flipping(kMap), kMap,
     "is not the file that the study has read"},
    {"hidden: node of a tree", InCapsule, NoRuns,
     replacing(kTree, "delay=\"2.0\"", "delay=\"2.5\""), kTree,
     "is not the file that the study has read"},
    {"hidden: trajectory", InCapsule, NoRuns, editing(kTrack, changeTrack), kTrack,
     "SHA-256 that study/runs/0/manifest.json"},
    {"hidden: manifest of the batch", InCapsule, NoRuns,
     replacing("study/manifest.json", "\"failed\": 0", "\"failed\": 1"), "study/manifest.json",
     "/failed is 1, but the results give 0"},
    {"hidden: input taken from the list", InCapsule, NoRuns, changeRecordedInput, "manifest.json",
     "is not listed as an input"},
    {"hidden: additional tree", InCapsule, AllRuns,
     [](const AlteredCapsule& in) {
       return QFile::copy(in.path(kTree), in.path("inputs/files/yard__agent_1_bt.xml"));
     },
     "", "would be read from outside the capsule"},
    {"hidden: run folder taken away", InCapsule, AllRuns, removeRunFolder, kTrack, "missing"},

    // All checksums are updated: only repeated runs show the change.
    {"renewed: digit in both tables", Everywhere, AllRuns, changeBothTables, kResults,
     "run 1: path_length is 3.25, the repeated run has"},
    {"renewed: trajectory", Everywhere, AllRuns, editing(kTrack, changeTrack), kTrack,
     "differs from step 13 on: x of id 2"},
    {"renewed: event", Everywhere, AllRuns,
     [](const AlteredCapsule& in) {
       return in.replace("study/runs/0/events.csv", ",stop,", ",stuck,");
     },
     "study/runs/0/events.csv", "kind is stuck, the repeated run has stop"},
    {"renewed: metric of a run", Everywhere, AllRuns,
     replacing("study/runs/0/metrics.json", "\"profile\": \"corrected\"",
               "\"profile\": \"hunav2\""),
     "study/runs/0/metrics.json", "/profile is \"hunav2\", the repeated run has \"corrected\""},
    {"renewed: parameter in the manifest of a run", Everywhere, AllRuns,
     replacing("study/runs/0/manifest.json", "\"seed\": 3", "\"seed\": 4"),
     "study/runs/0/manifest.json", "/seed is 4, the repeated run has 3"},
    {"renewed: parameter of a person", Everywhere, AllRuns,
     replacing(kYard, "goal_radius: 0.3", "goal_radius: 0.4"), "study/runs/0/trace.json",
     "the repeated run has"},
    {"renewed: place of a person", Everywhere, AllRuns, replacing(kYard, "x: 6.0", "x: 5.5"),
     kTrack, "differs from step 0 on: x of id 2"},
    {"renewed: seeds of the experiment", Everywhere, AllRuns,
     replacing(kExperiment, "[3, 7]", "[3, 8]"), kResults,
     "run 1: seed is 7, but the experiment gives 8"},
    {"renewed: duration of the experiment", Everywhere, AllRuns,
     replacing(kExperiment, "duration: 1.5", "duration: 1.4"), kResults,
     "run 0: simulated is 1.5, the repeated run has 1.4"},
};

}  // namespace

Q_DECLARE_METATYPE(const Tampering*)

/// Every change of a packed study is found and named with its place.
class TamperingTest : public QObject {
  Q_OBJECT

 private:
  small::PackedSmallStudy study_;

  base::Result<capsule::Verification> verify(const std::string& file, Runs runs) const {
    capsule::VerifyOptions options;
    options.file = file;
    options.share = 1.0;
    options.jobs = 2;
    if (runs == NoRuns) {
      options.runs = 0;
    }
    return capsule::verify(options);
  }
  static QByteArray textOf(const base::Diagnostics& problems) {
    QByteArray all;
    for (const base::Diagnostic& problem : problems) {
      all += QByteArray::fromStdString(problem.text()) + "\n";
    }
    return all;
  }
  /// The error of a file that cannot be verified.
  QByteArray errorOf(const QString& file) const {
    const auto found = verify(file.toStdString(), NoRuns);
    return found ? QByteArray("verified") : textOf(found.diagnostics());
  }

 private Q_SLOTS:
  void initTestCase() {
    const base::Diagnostics problems = study_.make();
    QVERIFY2(problems.empty(), textOf(problems).constData());
  }

  void unchanged_isEqual() {
    const auto found = verify(study_.file(), AllRuns);
    QVERIFY2(found, textOf(found.diagnostics()).constData());
    QVERIFY2(found->differences.empty(), textOf(found->differences).constData());
    QCOMPARE(found->repeated, std::vector<std::size_t>({0, 1, 2, 3}));
    QVERIFY(found->isEqual());
    QVERIFY(found->warnings.empty());
    QCOMPARE(found->identity.size(), std::size_t{64});
  }

  /// Renewed checksums of an unchanged study are no difference, or the table below proves nothing.
  void unchangedButRenewed_isEqual() {
    const AlteredCapsule copy(study_.file());
    copy.rehash(true);
    const auto found = verify(copy.pack(), AllRuns);
    QVERIFY2(found && found->isEqual(),
             textOf(found ? found->differences : found.diagnostics()).constData());
  }

  void tampering_isNamedWithItsPlace_data() {
    QTest::addColumn<const Tampering*>("tampering");
    for (const Tampering& each : kTamperings) {
      QTest::newRow(each.name) << &each;
    }
  }
  void tampering_isNamedWithItsPlace() {
    QFETCH(const Tampering*, tampering);
    const AlteredCapsule copy(study_.file());
    QVERIFY(copy.problems().empty());
    QVERIFY(tampering->change(copy));
    if (tampering->hidden != Openly) {
      copy.rehash(tampering->hidden == Everywhere);
    }
    const std::string file = copy.pack();
    const auto found = verify(file, tampering->runs);
    QVERIFY2(found, textOf(found.diagnostics()).constData());
    QVERIFY(!found->isEqual());
    const std::string place = tampering->place;
    const bool isNamed = std::any_of(
        found->differences.begin(), found->differences.end(), [&](const base::Diagnostic& each) {
          return each.file == file + (place.empty() ? "" : "/" + place) &&
                 each.message.find(tampering->message) != std::string::npos;
        });
    QVERIFY2(isNamed, textOf(found->differences).constData());
  }

  void damaged_isAnError_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("truncated") << 0;
    QTest::newRow("half of it") << 1;
    QTest::newRow("a byte of a member") << 2;
    QTest::newRow("empty") << 3;
  }
  void damaged_isAnError() {
    QFETCH(int, kind);
    QByteArray bytes = outside::bytesOf(small::textOf(study_.file()));
    if (kind == 2) {
      const int at = bytes.indexOf("study/results.csv") + 200;  // in its compressed content
      bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    } else {
      bytes = bytes.left(kind == 0 ? bytes.size() - 10 : kind == 1 ? bytes.size() / 2 : 0);
    }
    outside::writeText(study_.path("damaged.hnv"), bytes);
    const QByteArray error = errorOf(study_.path("damaged.hnv"));
    QVERIFY2(error.contains(kind == 2 ? "study/results.csv: error: this file of the archive is "
                                        "damaged"
                                      : "is not a ZIP archive"),
             error.constData());
  }

  void manifest_thatIsNone_isAnError_data() {
    QTest::addColumn<QByteArray>("was");
    QTest::addColumn<QByteArray>("by");
    QTest::addColumn<QByteArray>("error");
    QTest::newRow("no JSON") << QByteArray("{") << QByteArray("[")
                             << QByteArray("not the manifest");
    QTest::newRow("another kind") << QByteArray("\"capsule\"") << QByteArray("\"run\"")
                                  << QByteArray("not the manifest");
    QTest::newRow("newer") << QByteArray("\"format\": 1") << QByteArray("\"format\": 2")
                           << QByteArray("newer format");
    QTest::newRow("name that leaves the folder")
        << QByteArray("\"member\": \"inputs/files/study.yaml\"")
        << QByteArray("\"member\": \"inputs/../../../etc/passwd\"")
        << QByteArray("not the manifest");
    QTest::newRow("absolute name")
        << QByteArray("\"member\": \"inputs/files/study.yaml\"")
        << QByteArray("\"member\": \"/etc/passwd\"") << QByteArray("not the manifest");
    QTest::newRow("wrong type") << QByteArray("\"runs\": 4") << QByteArray("\"runs\": \"4\"")
                                << QByteArray("not the manifest");
  }
  void manifest_thatIsNone_isAnError() {
    QFETCH(QByteArray, was);
    QFETCH(QByteArray, by);
    QFETCH(QByteArray, error);
    const AlteredCapsule copy(study_.file());
    QVERIFY(copy.replace("manifest.json", was, by));
    const QByteArray found = errorOf(small::textOf(copy.pack()));
    QVERIFY2(found.contains("manifest.json: error: ") && found.contains(error), found.constData());
  }

  void manifest_missing_isAnError() {
    const AlteredCapsule copy(study_.file());
    QVERIFY(QFile::remove(copy.path("manifest.json")));
    QVERIFY(
        errorOf(small::textOf(copy.pack())).contains("manifest.json: error: this file is missing"));
  }

  void sample_bySeed_isReproducibleAndCoversAll() {
    std::vector<std::size_t> all(40);
    std::iota(all.begin(), all.end(), std::size_t{10});
    const auto sample = capsule::chooseRuns(all, 5, 7);
    QCOMPARE(sample, capsule::chooseRuns(all, 5, 7));
    QVERIFY(sample != capsule::chooseRuns(all, 5, 8));
    QCOMPARE(std::set<std::size_t>(sample.begin(), sample.end()).size(), std::size_t{5});
    QCOMPARE(capsule::chooseRuns(all, 99, 1), all);
    std::map<std::size_t, int> counts;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
      for (const std::size_t run : capsule::chooseRuns(all, 4, seed)) {
        ++counts[run];
      }
    }
    QCOMPARE(counts.size(), std::size_t{40});  // each 400 times, with a deviation of 19
    for (const auto& [run, count] : counts) {
      QVERIFY2(count > 300 && count < 500, QByteArray::number(count).constData());
    }
  }
};

QTEST_APPLESS_MAIN(TamperingTest)
#include "tst_Tampering.moc"
