#include <set>

#include <QtTest>

#include "app/run/Nav2Robots.h"
#include "app/run/RunComparison.h"
#include "bt/human/BehaviorBlocks.h"
#include "editor/document/PersonTree.h"
#include "editor/look/CoreText.h"
#include "editor/panels/properties/PropertyPage.h"
#include "metrics/MetricRegistry.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/Export.h"
#include "sim2d/scenario/Fields.h"

namespace {

/// The texts of the parts without Qt that the window shows, each once, in order.
class CoreTexts {
 public:
  const std::vector<std::string>& all() const { return texts_; }

  void add(const std::string& text) {
    if (!text.empty() && known_.insert(text).second) {
      texts_.push_back(text);
    }
  }

  void addSpec(const base::ParameterSpec& spec) {
    QString words = QString::fromStdString(spec.key).replace(QLatin1Char('_'), QLatin1Char(' '));
    add(spec.form.label.empty() ? editor::capitalized(words).toStdString() : spec.form.label);
    add(spec.help);
  }

  void addFields() {
    std::apply([this](const auto&... tables) { (addTable(tables), ...); },
               static_cast<const sim2d::FieldTables::tuple&>(sim2d::fieldTables()));
  }

  template <class Registry>
  void addRegistry(const Registry& registry) {
    for (const auto& entry : registry.entries()) {
      add(entry.help);
      std::for_each(entry.parameters.begin(), entry.parameters.end(),
                    [this](const base::ParameterSpec& spec) { addSpec(spec); });
    }
  }

  void addMetrics() {
    for (int i = 0; i < metrics::kCategories; ++i) {
      add(metrics::categoryName(static_cast<metrics::Category>(i)));
    }
    for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
      add(entry.info.name);  // its formula is that of METRICS.md in every language
    }
    for (const metrics::Kind kind : {metrics::Kind::Number, metrics::Kind::Count}) {
      for (const bool isPerSample : {false, true}) {
        app::MetricTimeSeries series;
        series.kind = kind;
        series.isPerSample = isPerSample;
        add(series.meaning());
      }
    }
  }

  void addNodes() {
    for (const bt::NodeManifest& node : editor::treeCatalogue().all()) {
      add(bt::nodeKindName(node.kind));
      add(node.description);
      for (const bt::PortSpec& port : node.ports) {
        add(port.help);
      }
    }
    for (const bt::BlockType& block : bt::blockTypes()) {
      add(block.title);
      add(block.description);
      for (const bt::BlockParameter& parameter : block.parameters) {
        add(parameter.label);
      }
    }
  }

 private:
  template <class T>
  void addTable(const sim2d::Fields<T>& fields) {
    for (const sim2d::Field<T>& field : fields) {
      addSpec(field.spec);
      add(field.group);
    }
  }

  std::vector<std::string> texts_;
  std::set<std::string> known_;
};

/// As a literal of C++.
std::string quoted(std::string text) {
  for (const char mark : {'\\', '"'}) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 2)) {
      text.insert(at, 1, '\\');
    }
  }
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
    text.replace(at, 1, "\\n");
  }
  return '"' + text + '"';
}

std::string listing(const CoreTexts& texts) {
  std::string all =
      "// clang-format off\n"
      "// Generated; do not edit. Labels and explanations of the folders without Qt, for lupdate;\n"
      "// not compiled. Regenerate with: HUNAV_UPDATE=1 build/dev/tests/tst_CoreTexts\n";
  for (const std::string& text : texts.all()) {
    all += "QT_TRANSLATE_NOOP(\"Core\", " + quoted(text) + ")\n";
  }
  return all;
}

}  // namespace

/// The list of texts for Qt Linguist that come from folders without Qt.
class CoreTextsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// With HUNAV_UPDATE=1 the list is rewritten.
  void list_isThatOfTheProgram() {
    CoreTexts texts;
    texts.addFields();
    const sim2d::Registries registries = app::builtinRegistries();
    texts.addRegistry(registries.planners);
    texts.addRegistry(registries.models);
    texts.add(sim2d::robotTypes().front().title);
    texts.addMetrics();
    texts.addNodes();
    const std::string path = SOURCE_DIR "/resources/translations/core_texts.cpp";
    const std::string current = listing(texts);
    if (qEnvironmentVariableIsSet("HUNAV_UPDATE")) {
      QVERIFY(base::writeFileAtomically(path, current).empty());
      return;
    }
    const base::Result<std::string> committed = base::readTextFile(path);
    QVERIFY(committed);
    QVERIFY2(*committed == current, "run HUNAV_UPDATE=1 tst_CoreTexts, then update_translations");
  }

  void coreText_unknownOrWithoutTranslation_isUnchanged() {
    QCOMPARE(editor::coreText("no such text"), QStringLiteral("no such text"));
    QCOMPARE(editor::coreText(""), QString());
  }
};

QTEST_APPLESS_MAIN(CoreTextsTest)
#include "tst_CoreTexts.moc"
