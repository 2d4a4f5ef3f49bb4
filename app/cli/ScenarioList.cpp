#include "app/cli/ScenarioList.h"

#include <map>

#include "app/run/Certificate.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

struct CardFile {
  ShippedScenario file;
  sim2d::ScenarioCard card;
  Json certificate;  // null: none
};

std::vector<CardFile> cardFiles() {
  std::vector<CardFile> all;
  for (ShippedScenario& shipped : shippedScenarios()) {
    CardFile one;
    const base::Result<std::string> text = base::readTextFile(shipped.path);
    one.card = text ? sim2d::cardOf(*text) : sim2d::ScenarioCard();
    const base::Result<std::string> proof = base::readTextFile(certificatePath(shipped.path));
    one.certificate = proof ? Json::parse(base::shallowJson(*proof), nullptr, false) : Json();
    one.certificate = one.certificate.is_object() ? one.certificate : Json();
    one.file = std::move(shipped);
    all.push_back(std::move(one));
  }
  return all;
}

/// By the keys of the file; a list stays a list.
Json cardJson(const sim2d::ScenarioCard& card) {
  Json json = Json::object();
  for (const auto& field : sim2d::fieldsOf<sim2d::ScenarioCard>()) {
    const std::string& key = field.spec.key;
    const base::ParameterValue value = field.value(card);
    if (key == "metrics" || key == "expect") {
      json[key] = key == "metrics" ? card.metrics : card.expect;
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      json[key] = *text;
    }
  }
  return json;
}

/// "separates orca and pursuit", "certified", "not certified"; empty without a certificate.
std::string certificationText(const Json& certificate) {
  if (certificate.is_null()) {
    return {};
  }
  if (certificate.value("certified", Json()) != true) {
    return "not certified";
  }
  const Json pair = certificate.value(Json::json_pointer("/metrics/0/separates"), Json());
  const bool isPair =
      pair.is_array() && pair.size() == 2 && pair[0].is_string() && pair[1].is_string();
  return isPair && certificate.value("separates", Json()) == true
             ? "separates " + pair[0].get<std::string>() + " and " + pair[1].get<std::string>()
             : "certified";
}

std::string difficultyText(const sim2d::ScenarioCard& card) {
  const auto* field = sim2d::fieldOf<sim2d::ScenarioCard>("difficulty");
  const base::ParameterValue value = field->value(card);
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::string() : *text;
}

/// As text inside a table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '|' ? "\\|" : std::string(1, c);
  }
  return escaped;
}

std::string familyOf(const CardFile& file) {
  return file.card.family.value_or("Others");
}

std::string cardText(const CardFile& file) {
  const sim2d::ScenarioCard& card = file.card;
  std::string text = "\n### " + file.file.name + "\n\n";
  const auto line = [&text](const char* label, const std::string& value) {
    if (!value.empty()) {
      text += std::string("- **") + label + ":** " + value + "\n";
    }
  };
  line("Title", card.title.value_or(""));
  line("Purpose", card.purpose.value_or(""));
  line("Task of the robot", card.robotTask.value_or(""));
  line("People", card.people.value_or(""));
  line("Expected outcome", card.outcome.value_or(""));
  line("Metrics", base::join(card.metrics, ", "));
  line("Difficulty", difficultyText(card));
  line("Expected without a robot", base::join(card.expect, "; "));
  line("Source", card.source.value_or(""));
  line("Licence", card.licence.value_or(""));
  line("Certificate", certificationText(file.certificate));
  return text;
}

}  // namespace

std::vector<ListedScenario> listedScenarios() {
  std::vector<ListedScenario> all;
  const auto shown = [](const std::string& text) { return text.empty() ? "-" : text; };
  for (const CardFile& file : cardFiles()) {
    const std::string& path = file.file.path;
    all.push_back(
        {file.file.name,
         {shown(file.card.title.value_or("")), shown(difficultyText(file.card)),
          shown(certificationText(file.certificate)), path},
         {{"path", path}, {"card", cardJson(file.card)}, {"certificate", file.certificate}}});
  }
  return all;
}

std::string scenariosPage() {
  std::map<std::string, std::vector<CardFile>> families;
  for (CardFile& file : cardFiles()) {
    families[familyOf(file)].push_back(std::move(file));
  }
  std::string text =
      "# Scenarios\n\nWritten by `hunavsim list scenarios --format md`; do not edit by hand.\n";
  for (const auto& [family, files] : families) {
    text += "\n## " + family +
            "\n\n| scenario | title | difficulty | certificate |\n|---|---|---|---|\n";
    for (const CardFile& file : files) {
      text += "| `" + file.file.name + "` | " + cell(file.card.title.value_or("")) + " | " +
              difficultyText(file.card) + " | " + certificationText(file.certificate) + " |\n";
    }
    for (const CardFile& file : files) {
      text += file.card.purpose ? cardText(file) : "";
    }
  }
  return text;
}

}  // namespace app
