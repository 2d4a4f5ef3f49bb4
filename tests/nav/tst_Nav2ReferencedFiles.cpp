#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/params/ReferencedFiles.h"

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

/// Files that a parameter file names by their places on a robot.
class Nav2ReferencedFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    // A workspace as on a robot: src/<package>/<folder>/<file>.
    touch("src/my_nav/config/beside.xml");
    touch("src/my_nav/config/nested/deep.xml");
    touch("src/my_nav/config/maps/keepout.yaml");
    touch("src/my_nav/behavior_trees/mine.xml");
    touch("src/my_nav/behavior_trees/same.xml");
    touch("src/my_nav/bt/same.xml");
    touch("src/my_nav/graphs/turtle.geojson");
    touch("src/my_trees/own/navigate.xml");
    touch("src/my_nav/odd/place/odd.xml");
    touch("extra/config/extra.xml");
  }

  void path_withoutPlaceholder_data() {
    QTest::addColumn<QString>("named");
    QTest::addColumn<QString>("path");
    const std::vector<std::pair<const char*, const char*>> rows = {
        {"maps/a.yaml", "maps/a.yaml"},
        {"/opt/ros/a.xml", "/opt/ros/a.xml"},
        {"$(find-pkg-share my_nav)/maps/a.yaml", "maps/a.yaml"},
        {"$(find my_nav)/maps/a.yaml", "maps/a.yaml"},
        {"$(find-pkg-share $(var package))/maps/a.yaml", "maps/a.yaml"},
        {"$(find-pkg-share my_nav)/$(var folder)/a.yaml", "a.yaml"},
        {"package://my_nav/maps/a.yaml", "maps/a.yaml"},
        {"package://my_nav", ""},
        {"file:///home/u/a.yaml", "/home/u/a.yaml"},
        {"$(env HOME)/a.yaml", "a.yaml"},
        {"${HOME}/a.yaml", "a.yaml"},
        {"~/a.yaml", "a.yaml"},
        {"$(var tree)", ""},
        {"$(var tree).xml", ""},
        {"$(find-pkg-share my_nav/a.yaml", ""},
        {"", ""}};
    for (const auto& [named, path] : rows) {
      QTest::newRow(named) << QString::fromLatin1(named) << QString::fromLatin1(path);
    }
  }

  void path_withoutPlaceholder() {
    QFETCH(QString, named);
    QFETCH(QString, path);
    QCOMPARE(pathWithoutSubstitution(named.toStdString()), path.toStdString());
  }

  void find_named_isTheFileBeside_data() {
    QTest::addColumn<QString>("named");
    QTest::addColumn<QString>("file");
    const std::vector<std::pair<const char*, const char*>> rows = {
        {"beside.xml", "src/my_nav/config/beside.xml"},
        {"../behavior_trees/mine.xml", "src/my_nav/behavior_trees/mine.xml"},
        {"$(find-pkg-share my_nav)/behavior_trees/mine.xml", "src/my_nav/behavior_trees/mine.xml"},
        {"$(find-pkg-share my_nav)/odd/place/odd.xml", "src/my_nav/odd/place/odd.xml"},
        {"package://my_trees/own/navigate.xml", "src/my_trees/own/navigate.xml"},
        {"$(find-pkg-share my_trees)/own/navigate.xml", "src/my_trees/own/navigate.xml"},
        {"/opt/ros/jazzy/share/other/behavior_trees/mine.xml",
         "src/my_nav/behavior_trees/mine.xml"},
        {"/home/robot/ws/src/nav/config/nested/deep.xml", "src/my_nav/config/nested/deep.xml"},
        {"$(var maps)/keepout.yaml", "src/my_nav/config/maps/keepout.yaml"},
        {"/somewhere/turtle.geojson", "src/my_nav/graphs/turtle.geojson"},
        {"nothing.xml", ""},
        {"$(var tree)", ""}};
    for (const auto& [named, file] : rows) {
      QTest::newRow(named) << QString::fromLatin1(named) << QString::fromLatin1(file);
    }
  }

  void find_named_isTheFileBeside() {
    QFETCH(QString, named);
    QFETCH(QString, file);
    const ReferencedFile found = findReferencedFile(named.toStdString(), {at("src/my_nav/config")});
    QCOMPARE(found.file, file.isEmpty() ? std::string() : folder_.filePath(file).toStdString());
  }

  void find_longerEnd_winsOverShorter() {
    // "behavior_trees" comes before "bt" for the name alone, but bt/same.xml is what is written.
    const std::vector<std::string> folders = {at("src/my_nav/config")};
    QCOMPARE(findReferencedFile("/a/bt/same.xml", folders).file, at("src/my_nav/bt/same.xml"));
    QCOMPARE(findReferencedFile("/a/same.xml", folders).file,
             at("src/my_nav/behavior_trees/same.xml"));
  }

  void find_folderOfTheValue_comesFirst() {
    touch("extra/config/beside.xml");
    QCOMPARE(findReferencedFile("beside.xml", {at("extra/config"), at("src/my_nav/config")}).file,
             at("extra/config/beside.xml"));
    QCOMPARE(findReferencedFile("extra.xml", {at("src/my_nav/config"), at("extra/config")}).file,
             at("extra/config/extra.xml"));
  }

  void find_nothing_namesTheFoldersThatExist() {
    const ReferencedFile found = findReferencedFile("nothing.xml", {at("src/my_nav/config")});
    const std::vector<std::string> expected = {
        at("src/my_nav/config"),         at("src/my_nav/config/maps"), at("src/my_nav"),
        at("src/my_nav/behavior_trees"), at("src/my_nav/bt"),          at("src/my_nav/graphs")};
    QCOMPARE(found.searched, expected);
  }

  void missing_warning_hasKeyPlacesAndSubstitute() {
    const base::Diagnostic problem = referencedFileMissing(
        "bt_navigator.default_nav_to_pose_bt_xml", "a.xml", {"", {"/x", "/y"}}, "the default tree");
    QCOMPARE(problem.severity, base::Severity::Warning);
    QCOMPARE(problem.message,
             std::string("bt_navigator.default_nav_to_pose_bt_xml: 'a.xml' was not found (searched "
                         "in /x, /y); the default tree is used"));
  }

 private:
  std::string at(const char* path) const {
    return folder_.filePath(QString::fromLatin1(path)).toStdString();
  }
  void touch(const char* path) const {
    const QFileInfo file(folder_.filePath(QString::fromLatin1(path)));
    QDir().mkpath(file.path());
    QFile made(file.filePath());
    QVERIFY(made.open(QIODevice::WriteOnly));
  }

  QTemporaryDir folder_;
};

QTEST_APPLESS_MAIN(Nav2ReferencedFilesTest)
#include "tst_Nav2ReferencedFiles.moc"
