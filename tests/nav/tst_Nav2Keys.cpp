#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/BtNavigatorParameters.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "tests/nav/Nav2KeyPlaces.h"

namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using namespace nav2keys;     // NOLINT

/// A file with one key of a component, and how a branch treats it.
Nav2ReadResult readingOf(const Place& place, const std::string& key, const std::string& value,
                         Distro distro) {
  const std::string text = key.empty() ? place.head : place.fileWith(key, value);
  const auto file = ParameterFile::parse(text, "p.yaml");
  return file ? readNav2Parameters(*file, {distro, {}, true}) : Nav2ReadResult();
}

void addComponents() {
  QTest::addColumn<QString>("component");
  for (const auto& [component, keys] : declaredKeys()) {
    QTest::newRow(component.c_str()) << QString::fromStdString(component);
  }
}

/// Whether a branch has the component, and it is not a node that is ignored as a whole.
bool isComponentOf(const std::string& component, Distro distro) {
  const auto& keys = declaredKeys().at(component);
  return ignoredNodeReason(component) == nullptr &&
         std::any_of(keys.begin(), keys.end(), [distro](const DeclaredKey& key) {
           return key.defaults.at(static_cast<std::size_t>(distro)) != "-";
         });
}

std::optional<KeyUse> useOf(const Nav2ReadResult& reading, const std::string& path) {
  for (const KeyUsage& note : reading.parameters.notes.keys) {
    if (note.path == path) {
      return note.use;
    }
  }
  return std::nullopt;
}

}  // namespace

/// Every parameter that Nav2 declares, against the tables of this program: which branches read it,
/// and its default. The table in tests/data/nav2/keys.csv was made from Nav2's sources, not by this
/// program.
class Nav2KeysTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachKey_isReadByItsBranches_data() { addComponents(); }

  /// A key is used, or known to have no effect, in each branch that declares it, and not known in
  /// the others.
  void eachKey_isReadByItsBranches() {
    QFETCH(QString, component);
    QStringList wrong;
    const Place& place = placesOfComponents().at(component.toStdString());
    for (const DeclaredKey& key : declaredKeys().at(component.toStdString())) {
      if (isList(key.name)) {
        continue;
      }
      for (const Distro distro : kDistros) {
        const std::string& own = key.defaults.at(static_cast<std::size_t>(distro));
        std::string value = own;
        for (const std::string& other : key.defaults) {
          value = value == "-" || value == "*" ? other : value;
        }
        value = value == "-" || value == "*" ? "\"word\"" : value;
        const auto use = useOf(readingOf(place, key.name, value, distro), place.path + key.name);
        const bool isRead = use == KeyUse::Used || use == KeyUse::Ignored;
        const bool isWrong = own != "-"                                       ? !isRead
                             : isComponentOf(component.toStdString(), distro) ? isRead
                                                                              : use == KeyUse::Used;
        if (isWrong) {
          wrong << QStringLiteral("%1 in %2")
                       .arg(QString::fromStdString(key.name), QLatin1String(distroTitle(distro)));
        }
      }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QStringLiteral(", "))));
  }

  void eachDefault_isThatOfTheCode_data() { addComponents(); }

  void eachDefault_isThatOfTheCode() {
    QFETCH(QString, component);
    QStringList wrong;
    const Place& place = placesOfComponents().at(component.toStdString());
    for (const Distro distro : kDistros) {
      const Nav2ReadResult reading = readingOf(place, {}, {}, distro);
      for (const EffectiveKey& known : reading.parameters.notes.known) {
        for (const DeclaredKey& key : declaredKeys().at(component.toStdString())) {
          const std::string& declared = key.defaults.at(static_cast<std::size_t>(distro));
          if (known.path != place.path + key.name || declared == "*" || declared == "-") {
            continue;
          }
          const auto number = base::parseDouble(declared), ours = base::parseDouble(known.fallback);
          const bool isSame = number && ours ? std::abs(*number - *ours) <= 1e-6 * std::abs(*number)
                                             : known.fallback == declared;
          if (!isSame) {
            wrong << QStringLiteral("%1 in %2: %3, not %4")
                         .arg(QString::fromStdString(key.name), QLatin1String(distroTitle(distro)),
                              QString::fromStdString(known.fallback),
                              QString::fromStdString(declared));
          }
        }
      }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QStringLiteral(", "))));
  }

  /// Parameters that the base classes of Nav2's nodes declare have no effect here.
  void keysOfEveryNode_areKnownInEachNode() {
    QStringList wrong;
    for (const auto& [component, place] : nodePlaces()) {
      if (place.indent != 4 || place.path != component + ".") {
        continue;  // not a node
      }
      for (const DeclaredKey& key : declaredKeys().at("every_node")) {
        for (const Distro distro : kDistros) {
          const std::string& value = key.defaults.at(static_cast<std::size_t>(distro));
          if (value != "-" && useOf(readingOf(place, key.name, value, distro),
                                    place.path + key.name) != KeyUse::Ignored) {
            wrong << QString::fromStdString(place.path + key.name);
          }
        }
      }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QStringLiteral(", "))));
  }

  void eachComponent_isInTheTable() {
    QVERIFY(declaredKeys().size() >= 60);
    for (const auto& [component, place] : placesOfComponents()) {
      QVERIFY2(declaredKeys().count(component) == 1, component.c_str());
    }
    for (const auto& [component, keys] : declaredKeys()) {
      QVERIFY2(placesOfComponents().count(component) == 1, component.c_str());
    }
  }
};

QTEST_GUILESS_MAIN(Nav2KeysTest)
#include "tst_Nav2Keys.moc"
