#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/Expectation.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

using TextList = std::vector<std::string> ScenarioCard::*;

constexpr const char* kBetween = "; ";  // between the texts of a list in a form

std::vector<std::string> textsOf(const std::string& joined) {
  std::vector<std::string> texts;
  for (const std::string& part : base::split(joined, ';')) {
    if (std::string text = base::trimmed(part); !text.empty()) {
      texts.push_back(std::move(text));
    }
  }
  return texts;
}

/// A list of texts; forms show it as one text.
FieldBuilder<ScenarioCard> textList(const char* key, TextList list, std::string help,
                                    const char* label) {
  return FieldBuilder<ScenarioCard>(key, std::move(help), {label})
      .typed(ParameterType::Text)
      .withCustomIo([key, list](YamlMap& view, ScenarioCard& to) { to.*list = view.names(key); },
                    [key, list](YamlNode& tree, const ScenarioCard& card) {
                      if (!(card.*list).empty()) {
                        YamlNode texts(YamlNode::Kind::List);
                        std::transform((card.*list).begin(), (card.*list).end(),
                                       std::back_inserter(texts.items), base::stringNode);
                        setChild(tree, key, std::move(texts));
                      }
                    },
                    list)
      .with(&Field<ScenarioCard>::get,
            [list](const ScenarioCard& card, const ParameterSpec& /*spec*/) {
              return (card.*list).empty() ? ParameterValue() : base::join(card.*list, kBetween);
            })
      .with(&Field<ScenarioCard>::set,
            [list](ScenarioCard& card, const ParameterValue& value, const ParameterSpec& /*spec*/) {
              const auto* const text = std::get_if<std::string>(&value);
              card.*list = textsOf(text != nullptr ? *text : std::string());
            });
}

}  // namespace

Fields<ScenarioCard> cardFields() {
  using Card = ScenarioCard;
  return {
      field("title", &Card::title, "Name of the scenario in lists", {"Title"}),
      field("family", &Card::family, "Group of scenarios that it belongs to", {"Family"}),
      field("purpose", &Card::purpose, "What the scenario tests", {"Purpose"}),
      field("robot_task", &Card::robotTask, "What the robot has to do", {"Task of the robot"}),
      field("people", &Card::people, "What people do", {"People"}),
      field("outcome", &Card::outcome, "What is expected of a good robot", {"Expected outcome"}),
      textList("metrics", &Card::metrics,
               "Keys of the metrics to read, see `list metrics`; the first one compares planners",
               "Metrics"),
      field("difficulty", &Card::difficulty, "Difficulty for the robot", {"Difficulty"})
          .words({"easy", "normal", "hard"}),
      field("source", &Card::source, "Publication or standard that the scenario is taken from",
            {"Source"}),
      field("licence", &Card::licence, "Licence of the scenario and its map", {"Licence"}),
      textList("expect", &Card::expect,
               "What happens in a run without robots, see below; `check --certify` tests it",
               "Expected events")};
}

void readCard(YamlMap& view, DesktopSettings& to) {
  readObject(view.map("card"), to.card, fieldTables());
}

void writeCard(YamlNode& tree, const DesktopSettings& desktop) {
  YamlNode card = objectTree(desktop.card, fieldTables());
  if (!card.isNull()) {
    setChild(tree, "card", std::move(card));
  }
}

ScenarioCard cardOf(const std::string& text) {
  static const std::string kHead = "\n    card:\n";
  const std::size_t head = text.find(kHead);
  if (head == std::string::npos) {
    const bool mayHaveCard = text.find("card") != std::string::npos;
    return mayHaveCard ? readScenarioText(text, {}).scenario.desktop.card : ScenarioCard();
  }
  std::size_t end = head + kHead.size();
  while (text.compare(end, 6, "      ") == 0) {
    const std::size_t next = text.find('\n', end);
    end = next == std::string::npos ? text.size() : next + 1;
  }
  const std::string block = text.substr(head + 1, end - head - 1);
  const std::string file = std::string(kLoaderNode) + ":\n  " + kParameters +
                           ":\n    publish_people: true\n" + kDesktopNode + ":\n  " + kParameters +
                           ":\n    format: 1\n" + block;
  return readScenarioText(file, {}).scenario.desktop.card;
}

void checkCard(const Scenario& scenario, CheckReport& report) {
  const Subject card({base::EntityKind::Scenario, 0}, "card.expect");
  for (const std::string& text : scenario.desktop.card.expect) {
    const base::Result<Expectation> expectation = parseExpectation(text);
    if (!expectation) {
      report.error(card, "card.expectation-form", {text, expectationForms()});
      continue;
    }
    for (const std::string& name : unknownNames(*expectation, scenario)) {
      report.error(card, "card.expectation-name", {name, text});
    }
  }
}

}  // namespace sim2d
