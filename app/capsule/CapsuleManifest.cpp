#include "app/capsule/CapsuleManifest.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/capsule/Archive.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

using CapsuleJson = nlohmann::ordered_json;

bool isHash(const std::string& text) {
  return text.size() == 64 && std::all_of(text.begin(), text.end(), [](char c) {
           return base::isDigit(c) || (c >= 'a' && c <= 'f');
         });
}

CapsuleInput inputOf(const CapsuleJson& json) {
  CapsuleInput input;
  input.path = json.at("path").get<std::string>();
  input.sha256 = json.at("sha256").get<std::string>();
  if (!json.at("member").is_null()) {
    input.member = json.at("member").get<std::string>();
  }
  return input;
}

CapsuleManifest readFields(const CapsuleJson& json) {
  CapsuleManifest manifest;
  const CapsuleJson& study = json.at("study");
  manifest.isBatch = study.at("kind").get<std::string>() == "batch";
  manifest.version = study.at("version").get<std::string>();
  manifest.commit = study.at("commit").get<std::string>();
  manifest.runs = study.at("runs").get<std::size_t>();
  manifest.finished = study.at("finished").get<std::size_t>();
  manifest.allowsCode = study.at("code_allowed").get<bool>();
  for (const CapsuleJson& input : json.at("inputs")) {
    manifest.inputs.push_back(inputOf(input));
  }
  for (const CapsuleJson& member : json.at("outputs")) {
    manifest.members[member.at("path").get<std::string>()] = member.at("sha256").get<std::string>();
  }
  return manifest;
}

/// Whether the names are ones that a capsule may have: they become paths.
bool hasGoodNames(const CapsuleManifest& manifest) {
  return !manifest.inputs.empty() &&
         std::all_of(
             manifest.inputs.begin(), manifest.inputs.end(),
             [](const CapsuleInput& input) {
               return input.member.empty() ||
                      (isMemberName(input.member) && base::startsWith(input.member, kInputsFolder));
             }) &&
         !manifest.inputs.front().member.empty();
}

}  // namespace

const CapsuleInput* omittedCode(const CapsuleManifest& manifest) {
  const auto found = std::find_if(manifest.inputs.begin(), manifest.inputs.end(),
                                  [](const CapsuleInput& each) { return each.member.empty(); });
  return found == manifest.inputs.end() ? nullptr : &*found;
}

std::string manifestText(const CapsuleManifest& manifest) {
  CapsuleJson inputs = CapsuleJson::array(), outputs = CapsuleJson::array();
  for (const CapsuleInput& input : manifest.inputs) {
    inputs.push_back(
        {{"path", input.path},
         {"sha256", input.sha256},
         {"member", input.member.empty() ? CapsuleJson() : CapsuleJson(input.member)}});
  }
  for (const auto& [name, hash] : manifest.members) {
    outputs.push_back({{"path", name}, {"sha256", hash}});
  }
  const CapsuleJson json = {
      {"kind", "capsule"},
      {"format", CapsuleManifest::kFormat},
      {"program", {{"version", app::programVersion()}, {"commit", app::programCommit()}}},
      {"study",
       {{"kind", manifest.isBatch ? "batch" : "run"},
        {"version", manifest.version},
        {"commit", manifest.commit},
        {"runs", manifest.runs},
        {"finished", manifest.finished},
        {"code_allowed", manifest.allowsCode}}},
      {"inputs", inputs},
      {"outputs", outputs}};
  return base::jsonText(json) + "\n";
}

base::Result<CapsuleManifest> parseCapsuleManifest(const std::string& text,
                                                   const std::string& file) {
  const CapsuleJson json = CapsuleJson::parse(base::shallowJson(text), nullptr, false);
  if (!json.is_object() || json.value("kind", CapsuleJson()) != "capsule") {
    return base::error("capsule.bad-manifest", {}, file);
  }
  const CapsuleJson format = json.value("format", CapsuleJson());
  if (format.is_number_integer() && format.get<int>() > CapsuleManifest::kFormat) {
    return base::error("capsule.newer", {}, file);
  }
  try {
    CapsuleManifest manifest = readFields(json);
    if (hasGoodNames(manifest)) {
      return manifest;
    }
  } catch (const CapsuleJson::exception&) {  // reported below
  }
  return base::error("capsule.bad-manifest", {}, file);
}

std::string sumsText(const app::FileHashes& members) {
  std::string text;
  for (const auto& [name, hash] : members) {
    text += hash;
    text += "  " + name + "\n";
  }
  return text;
}

app::FileHashes parseSums(const std::string& text) {
  constexpr std::size_t kHashLength = 64;
  app::FileHashes sums;
  for (const std::string& line : base::split(text, '\n')) {
    const std::string hash = line.substr(0, std::min(line.size(), kHashLength));
    if (line.size() > kHashLength + 2 && isHash(hash) && line.compare(kHashLength, 2, "  ") == 0) {
      sums[line.substr(kHashLength + 2)] = hash;
    }
  }
  return sums;
}

}  // namespace capsule
