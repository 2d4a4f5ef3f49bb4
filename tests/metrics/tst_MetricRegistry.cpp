#include <algorithm>
#include <set>

#include <QtTest>

#include "MetricCases.h"
#include "SampledRun.h"
#include "metrics/Expression.h"
#include "metrics/Report.h"
#include "metrics/RunResults.h"
#include "sim2d/base/Text.h"

using namespace metrics;

namespace {

/// All that a new metric needs: what is summed up and its entry.
class CrowdSize : public Accumulator {
 public:
  void add(const Instant& at) override { sum_.add(at, static_cast<double>(at.now.people.size())); }
  MetricValue value() const { return withTerms(sum_, Kind::Count); }

 private:
  SeriesSum sum_;
};

/// The same, of the whole record.
MetricComputation ofWholeRecord() {
  const Expression formula = *Expression::parse("sum(people + 0 * duration)");
  return formula.needsRecord() ? formula.computation() : MetricComputation{};
}

void addCrowdSize(MetricRegistry& to) {
  MetricInfo info{"crowd_size",
                  "People met",
                  "people",
                  Category::Social,
                  Better::Neutral,
                  Needs{false, true},
                  "sum of n_i",
                  "this test",
                  "0, 1, ...",
                  Kind::Count,
                  0,
                  ""};
  to.add(info, metricOf<CrowdSize>(&CrowdSize::value));
  info.key = "crowd_size_of_all";
  to.add(info, ofWholeRecord());
}

const MetricRegistry& extended() {
  static const MetricRegistry kRegistry = [] {
    MetricRegistry registry = standardRegistry();
    addCrowdSize(registry);
    return registry;
  }();
  return kRegistry;
}

Evaluation evaluation() {
  return *evaluate(sampledRunOf(cases::trace(9, 4)), Selection{}, MetricParameters{}, extended());
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Text of a table cell with escaped bars.
std::string cellOf(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    cell += c == '|' ? std::string("\\|") : std::string(1, c);
  }
  return cell.empty() ? "-" : cell;
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) {
    text += " " + cell + " |";
  }
  return text + "\n";
}

/// "robot, people"; "nothing".
std::string needsText(const Needs& needs) {
  const std::pair<bool, const char*> all[] = {
      {needs.robot, "robot"},         {needs.people, "people"}, {needs.groups, "groups"},
      {needs.obstacles, "obstacles"}, {needs.goal, "goal"},     {needs.map, "map"}};
  std::vector<std::string> names;
  for (const auto& [needed, name] : all) {
    if (needed) {
      names.emplace_back(name);
    }
  }
  return names.empty() ? "nothing" : base::join(names, ", ");
}

std::string categoryTable(const MetricRegistry& registry, Category category) {
  std::string text = "\n## " + std::string(categoryName(category)) + "\n\n";
  text +=
      row({"#", "key", "meaning", "unit", "formula", "range", "better", "rate", "needs", "source"});
  text += "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const MetricEntry& entry : registry.entries()) {
    const MetricInfo& info = entry.info;
    if (info.category == category) {
      text += row({info.hunav > 0 ? std::to_string(info.hunav) : "", "`" + info.key + "`",
                   cellOf(info.name), cellOf(info.unit), cellOf(info.formula), cellOf(info.range),
                   betterName(info.better), base::formatDouble(100.0 * info.rateBound) + " %",
                   needsText(info.needs), cellOf(info.source)});
    }
  }
  return text;
}

std::string parameterTable() {
  std::string text = row({"name", "default", "unit", "meaning"}) + "|---|---|---|---|\n";
  for (const ParameterInfo& info : parameterInfos()) {
    const base::ParameterSpec& spec = info.spec;
    text += row({"`" + spec.key + "`", base::formatDouble(std::get<double>(spec.fallback)),
                 cellOf(spec.unit), cellOf(spec.help)});
  }
  return text;
}

std::string listOf(const std::vector<MetricInfo>& infos) {
  std::string text;
  for (const MetricInfo& info : infos) {
    text += "- `" + info.key + "`: " + info.name + " [" + info.unit + "], " + info.formula + "; " +
            info.range + ", " + betterName(info.better) + " is better, source: " + info.source +
            "\n";
  }
  return text;
}

/// Replaces the part of the page from `begin` to before `end`, or to the end of the page.
void replacePart(std::string& page, const std::string& begin, const char* end,
                 const std::string& by) {
  const std::size_t from = page.find(begin);
  QVERIFY2(from != std::string::npos, begin.c_str());
  const std::size_t to = end != nullptr ? page.find(end, from) : page.size();
  QVERIFY2(to != std::string::npos, begin.c_str());
  page.replace(from, to - from, by);
}

/// The page METRICS.md with the tables and lists of a registry; its prose is kept.
std::string withCurrentTables(std::string page, const MetricRegistry& registry) {
  std::string tables;
  for (int category = 0; category < kCategories; ++category) {
    tables += categoryTable(registry, static_cast<Category>(category));
  }
  replacePart(page, "\n## " + std::string(categoryName(Category::Navigation)) + "\n",
              "\n## Profile `hunav2`\n", tables);
  replacePart(page, "- `counterfactual_", "\n## Wall-clock metrics\n", listOf(effectInfos()));
  replacePart(page, "- `planning_time_", "\n## Parameters\n", listOf(planningTimeInfos()));
  replacePart(page, "| name | default |", nullptr, parameterTable());
  return page;
}

}  // namespace

class MetricRegistryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void standardRegistry_hunavKeys_are34InOrder() {
    const auto& entries = standardRegistry().entries();
    QVERIFY(entries.size() > 34);
    for (std::size_t k = 0; k < 34; ++k) {
      QCOMPARE(entries[k].info.hunav, static_cast<int>(k) + 1);
    }
    QCOMPARE(entries[34].info.hunav, 0);
    QVERIFY(entries[0].info.key == "time_to_reach_goal");
    QVERIFY(entries[33].info.key == "surprise_react_cost");
    QVERIFY(standardRegistry().find("social_work_mean")->info.partOf == "social_work");
  }

  void standardRegistry_everyEntry_isDescribed() {
    std::set<std::string> keys;
    for (const MetricEntry& entry : standardRegistry().entries()) {
      QVERIFY2(keys.insert(entry.info.key).second, entry.info.key.c_str());
      QVERIFY2(!entry.info.name.empty() && !entry.info.formula.empty() &&
                   !entry.info.source.empty() && !entry.info.range.empty(),
               entry.info.key.c_str());
    }
  }

  void addedMetric_appearsEverywhere() {
    const Evaluation made = evaluation();
    QVERIFY(extended().find("crowd_size") != nullptr);
    QCOMPARE(*made.find("crowd_size")->value.value, 40.0);
    QCOMPARE(*made.find("crowd_size_of_all")->value.value, 40.0);
    QVERIFY(contains(toJson(made), "\"crowd_size\": {\n      \"value\": 40,"));
    QVERIFY(contains(metricsCsv(made), ",crowd_size,crowd_size_of_all\n"));
    QVERIFY(contains(metricsCsv(made), ",40,40\n"));
    QVERIFY(contains(stepsCsv(made), ",crowd_size\n"));
    QVERIFY(contains(tableText(made), "crowd_size"));
    QVERIFY(contains(withCurrentTables(metricsMarkdown(), extended()), "`crowd_size`"));
  }

  void addedMetric_isOnOnlyWhenListed() {
    const auto file = [](const char* text) {
      return parseMetricsFile(text, "metrics.yaml", extended())->selection;
    };
    const MetricInfo& info = extended().find("crowd_size")->info;
    QVERIFY(Selection{}.selects(info));
    QVERIFY(!file("metrics: {path_length: true}").selects(info));
    const Selection listed = file("metrics: {crowd_size: true}");
    QVERIFY(listed.selects(info));
    QVERIFY(contains(writeMetricsFile({listed, "r", true}, extended()), "crowd_size: true"));
  }

  void addedTable_tellsWhatTheMetricsAre() {
    MetricRegistry registry;
    registry.add(R"(
= Social Behavior|lower|robot, map|this test|0.05
7 bends|Bends|m|0, 1, ...|sum of |v|, from 0 to
  the end
met|Met||0 or 1|x
= Motion Analysis|higher|people|this test
rush|Rush|m/s|[0, inf)|y
)",
                 {{"bends", {}}, {"met", {}}, {"rush", {}}});
    const MetricInfo& bends = registry.find("bends")->info;
    QVERIFY(bends.kind == Kind::Count);
    QCOMPARE(bends.hunav, 7);
    QCOMPARE(bends.formula, std::string("sum of |v|, from 0 to the end"));
    QCOMPARE(bends.unit, std::string("m"));
    QCOMPARE(bends.rateBound, 0.05);
    QCOMPARE(needsText(bends.needs), std::string("robot, map"));
    const MetricInfo& met = registry.find("met")->info;
    QVERIFY(met.kind == Kind::Boolean);
    QCOMPARE(met.hunav, 0);
    const MetricInfo& rush = registry.find("rush")->info;
    QVERIFY(rush.kind == Kind::Number);
    QVERIFY(rush.category == Category::Motion);
    QVERIFY(rush.better == Better::Higher);
    QCOMPARE(rush.rateBound, MetricInfo{}.rateBound);
  }

  void parameterInfos_names_areUniqueAndFindable() {
    std::set<std::string> names;
    for (const ParameterInfo& info : parameterInfos()) {
      QVERIFY2(names.insert(info.spec.key).second, info.spec.key.c_str());
      QCOMPARE(findParameter(info.spec.key), &info);
    }
    QVERIFY(findParameter("goal_tolerrance") == nullptr);
  }

  void parametersOf_metricThatChanges_namesTheParameter() {
    const SampledRun record = sampledRunOf(cases::trace(9, 4));
    const auto valuesWith = [&record](const MetricParameters& parameters) {
      return evaluate(record, Selection{}, parameters)->results;
    };
    MetricParameters lined;
    lined.flowLineX2 = 3.0;
    const std::vector<MetricResult> before = valuesWith(lined);
    for (const ParameterInfo& info : parameterInfos()) {
      MetricParameters changed = lined;
      double& value = changed.*info.member;
      value = info.spec.range.high == 1.0 ? 1.0 - value : 1.5 * value + 0.1;
      const std::vector<MetricResult> after = valuesWith(changed);
      bool isUsed = false;
      for (std::size_t k = 0; k < after.size(); ++k) {
        const auto specs = standardRegistry().parametersOf(after[k].info);
        const bool isNamed = std::any_of(specs.begin(), specs.end(), [&info](const auto& spec) {
          return spec.key == info.spec.key;
        });
        isUsed = isUsed || isNamed;
        QVERIFY2(isNamed || before[k].value.value == after[k].value.value,
                 (after[k].info.key + " changes with " + info.spec.key).c_str());
      }
      QVERIFY2(isUsed, info.spec.key.c_str());
    }
  }

  /// With HUNAV_UPDATE=1 the tables and lists of METRICS.md are rewritten.
  void metricsMarkdown_tables_areThoseOfTheRegistry() {
    const std::string path = SOURCE_DIR "/metrics/METRICS.md";
    const base::Result<std::string> committed = base::readTextFile(path);
    QVERIFY(committed);
    const std::string current = withCurrentTables(*committed, standardRegistry());
    if (qEnvironmentVariableIsSet("HUNAV_UPDATE")) {
      QVERIFY(base::writeFileAtomically(path, current).empty());
      return;
    }
    QVERIFY2(*committed == current, "run HUNAV_UPDATE=1 tst_MetricRegistry");
    QVERIFY(*committed == metricsMarkdown());
  }
};

QTEST_APPLESS_MAIN(MetricRegistryTest)
#include "tst_MetricRegistry.moc"
