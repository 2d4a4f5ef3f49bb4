#include <map>
#include <regex>
#include <set>

#include <QtTest>

#include "bt/human/TreeLoader.h"
#include "tests/bt/ShippedScenario.h"

using namespace shipped;
namespace fs = std::filesystem;

namespace {

/// Cards of all stored scenarios by name.
std::map<std::string, sim2d::ScenarioCard> cards() {
  std::map<std::string, sim2d::ScenarioCard> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(mapsFolder())) {
    const base::Result<std::string> text = base::readTextFile(entry.path().string());
    if (entry.path().extension() == ".yaml" && text &&
        text->find("hunav_loader:") != std::string::npos) {
      found[entry.path().stem().string()] =
          sim2d::readScenario(entry.path().string()).scenario.desktop.card;
    }
  }
  return found;
}

/// Names of elements in the tree files of the library.
std::set<std::string> usedNodes() {
  std::set<std::string> used;
  const std::regex element("<([A-Z][A-Za-z]+)");
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(mapsFolder() + "/library")) {
    if (entry.path().extension() != ".xml") {
      continue;
    }
    const std::string text = *base::readTextFile(entry.path().string());
    for (std::sregex_iterator at(text.begin(), text.end(), element), end; at != end; ++at) {
      used.insert((*at)[1]);
    }
  }
  return used;
}

}  // namespace

/// What the library of scenarios promises.
class ScenarioLibraryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void library_hasScenariosWithCompleteCards() {
    const auto all = cards();
    QVERIFY2(all.size() >= 120, std::to_string(all.size()).c_str());
    for (const auto& [name, card] : all) {
      const bool isComplete = card.title && card.purpose && card.robotTask && card.people &&
                              card.outcome && card.difficulty && card.source && card.licence &&
                              !card.metrics.empty();
      QVERIFY2(isComplete, name.c_str());
    }
  }

  void library_hasThe25SituationsAtThreeLevels() {
    std::map<std::string, std::set<std::string>> levels;
    for (const auto& [name, card] : cards()) {
      if (card.family == std::string("Francis 2025")) {
        const std::size_t end = name.rfind('_');
        levels[name.substr(0, end)].insert(name.substr(end + 1));
      }
    }
    QCOMPARE(levels.size(), std::size_t{25});
    for (const auto& [situation, found] : levels) {
      QVERIFY2((found == std::set<std::string>{"easy", "hard", "normal"}), situation.c_str());
    }
  }

  void library_usesEveryNodeOfPeople() {
    const std::set<std::string> used = usedNodes();
    std::string unused;
    const bt::NodeLibrary library = bt::humanNodes();
    for (const bt::NodeManifest& node : library.catalogue().all()) {
      const bool isOfPeople = node.origin != bt::NodeOrigin::BehaviorTreeCpp;
      unused += isOfPeople && used.count(node.id) == 0 ? " " + node.id : std::string();
    }
    QVERIFY2(unused.empty(), unused.c_str());
  }

  void library_isSmall() {
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(mapsFolder() + "/library")) {
      bytes += entry.is_regular_file() ? entry.file_size() : 0;
    }
    QVERIFY2(bytes < 25'000'000, std::to_string(bytes).c_str());
  }
};

QTEST_APPLESS_MAIN(ScenarioLibraryTest)
#include "tst_ScenarioLibrary.moc"
