#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/Futures.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

// Futures and requests for them as text, for other processes.
namespace app {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FuturesOptions, count, horizon, spread, jobs, seed, sampleGap)

namespace {

using FutureJson = nlohmann::json;

/// Rejects JSON nested deeper than any valid request, because the library's parser is recursive.
class JsonDepthCheck : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool string(string_t& /*value*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool key(string_t& /*value*/) override { return true; }
  bool start_object(std::size_t /*elements*/) override { return ++depth_ < kMaxDepth; }
  bool end_object() override { return --depth_ >= 0; }
  bool start_array(std::size_t /*elements*/) override { return ++depth_ < kMaxDepth; }
  bool end_array() override { return --depth_ >= 0; }
  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*problem*/) override {
    return false;
  }

 private:
  static constexpr int kMaxDepth = 16;
  int depth_ = 0;
};

/// NaN becomes null in the text.
FutureJson numbersOf(const std::vector<base::Vec2>& way, int axis) {
  FutureJson numbers = FutureJson::array();
  for (const base::Vec2& point : way) {
    numbers.push_back(point[axis]);
  }
  return numbers;
}

double numberOf(const FutureJson& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<base::Vec2> wayOf(const FutureJson& x, const FutureJson& y) {
  std::vector<base::Vec2> way;
  for (std::size_t k = 0; k < x.size(); ++k) {
    way.emplace_back(numberOf(x.at(k)), numberOf(y.at(k)));
  }
  return way;
}

FutureJson branchJson(const RunBranch& branch) {
  return {{"step", branch.step}, {"options", commandLineOf(branch.changes, RunOption::AtBranch)}};
}

/// Null: invalid options.
std::optional<RunBranch> branchOf(const FutureJson& json) {
  const base::Result<RunSpec> changes =
      runSpecOfCommandLine(json.at("options").get<std::vector<std::string>>());
  return changes ? std::optional(RunBranch{json.at("step").get<std::int64_t>(), *changes})
                 : std::nullopt;
}

FutureJson mapJson(const sim2d::OccupancyGrid& map) {
  if (map.isEmpty()) {
    return FutureJson();
  }
  const auto* const cells = reinterpret_cast<const std::uint8_t*>(map.cells().data());
  return {{"width", map.width()},
          {"height", map.height()},
          {"resolution", map.resolution()},
          {"x", map.origin().position.x()},
          {"y", map.origin().position.y()},
          {"heading", map.origin().heading},
          {"cells", FutureJson::binary({cells, cells + map.cells().size()})}};
}

/// Null: it has not the cells that it should.
std::shared_ptr<const sim2d::OccupancyGrid> mapOf(const FutureJson& json) {
  if (json.is_null()) {
    return std::make_shared<const sim2d::OccupancyGrid>();
  }
  const FutureJson::binary_t& bytes = json.at("cells").get_binary();
  std::vector<std::int8_t> cells;
  cells.reserve(bytes.size());
  for (const std::uint8_t byte : bytes) {
    cells.push_back(static_cast<std::int8_t>(byte));
  }
  const int width = json.at("width").get<int>(), height = json.at("height").get<int>();
  const double resolution = json.at("resolution").get<double>();
  const bool isWhole =
      width > 0 && height > 0 && resolution > 0.0 && std::isfinite(resolution) &&
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) == cells.size();
  if (!isWhole) {
    return nullptr;
  }
  const base::Pose2 origin{{json.at("x").get<double>(), json.at("y").get<double>()},
                           json.at("heading").get<double>()};
  return std::make_shared<const sim2d::OccupancyGrid>(width, height, resolution, origin,
                                                      std::move(cells));
}

FutureJson treesJson(const bt::TreeFiles& trees) {
  FutureJson json = FutureJson::object();
  for (const auto& [name, tree] : trees) {
    json[name] = {{"path", tree.path}, {"folder", tree.folder}};
    if (tree.text) {
      json[name]["text"] = *tree.text;
    }
  }
  return json;
}

bt::TreeFiles treesOf(const FutureJson& json) {
  bt::TreeFiles trees;
  for (const auto& [name, tree] : json.items()) {
    bt::TreeSource source(tree.at("path").get<std::string>());
    source.folder = tree.at("folder").get<std::string>();
    if (tree.contains("text")) {
      source.text = tree.at("text").get<std::string>();
    }
    trees.emplace(name, std::move(source));
  }
  return trees;
}

std::string inputRows(const sim2d::RecordedInputs& inputs) {
  std::string rows = sim2d::inputsHeader();
  for (const auto& [step, input] : inputs) {
    sim2d::appendInputRow(rows, step, input);
  }
  return rows;
}

std::string quirksText(const sim2d::Compatibility& compatibility) {
  return compatibility.hunav2() ? "hunav2" : base::join(compatibility.names(), ",");
}

bool areOptions(const FuturesOptions& options) {
  constexpr double kLeastGap = 1e-3;  // [s]
  return options.count >= 1 && options.count <= kMaxFutures && options.jobs >= 1 &&
         options.jobs <= kMaxFutures && options.horizon >= 0.0 &&
         options.horizon <= kLongestFuture && options.spread >= 0.0 && options.spread <= 1.0 &&
         options.sampleGap >= kLeastGap && options.sampleGap <= kLongestFuture;
}

/// Nothing: values that cannot be.
std::optional<FuturesRequest> requestOf(const FutureJson& json) {
  FuturesRequest request;
  Bundle& bundle = request.bundle;
  bundle.path = json.at("path").get<std::string>();
  bundle.scenario = std::make_shared<const sim2d::Scenario>(
      sim2d::readScenarioText(json.at("scenario").get<std::string>(), bundle.path).scenario);
  bundle.map = mapOf(json.at("map"));
  bundle.trees = treesOf(json.at("trees"));
  bundle.settings.exact = json.at("exact").get<bool>();
  bundle.settings.code = sim2d::ExternalCodePolicy::Refused;
  const auto quirks = json.at("compat").get<std::string>();
  const auto compatibility = sim2d::Compatibility::parse(quirks);
  if (bundle.map == nullptr || (!quirks.empty() && !compatibility)) {
    return std::nullopt;
  }
  if (!quirks.empty()) {
    bundle.settings.compatibility = *compatibility;
  }
  for (const FutureJson& branch : json.at("branches")) {
    std::optional<RunBranch> read = branchOf(branch);
    if (!read) {
      return std::nullopt;
    }
    request.branches.push_back(*std::move(read));
  }
  const base::Result<sim2d::RecordedInputs> inputs =
      sim2d::parseInputs(json.at("inputs").get<std::string>(), "inputs");
  request.inputs = inputs ? *inputs : sim2d::RecordedInputs();
  request.at = json.at("at").get<std::int64_t>();
  request.state = json.at("state").get<std::string>();
  request.options = json.at("options").get<FuturesOptions>();
  return request.at >= 0 && areOptions(request.options)
             ? std::optional<FuturesRequest>(std::move(request))
             : std::nullopt;
}

}  // namespace

std::string futureText(const Future& future) {
  FutureJson json = {{"number", future.number}, {"seed", future.seed}, {"times", future.times}};
  json["bodies"] = FutureJson::array();
  for (const auto& [id, way] : future.ways) {
    json["bodies"].push_back({{"id", id}, {"x", numbersOf(way, 0)}, {"y", numbersOf(way, 1)}});
  }
  if (future.contact) {
    const FutureContact& contact = *future.contact;
    json["contact"] = {{"time", contact.time},
                       {"id", contact.id},
                       {"other", contact.other},
                       {"x", contact.where.x()},
                       {"y", contact.where.y()}};
  }
  if (!future.failure.empty()) {
    json["failure"] = future.failure;
  }
  return json.dump(-1, ' ', false, FutureJson::error_handler_t::replace);
}

std::optional<Future> futureOf(const std::string& text) {
  const FutureJson json = FutureJson::parse(base::shallowJson(text), nullptr, false);
  Future future;
  try {
    future.number = json.at("number").get<int>();
    future.seed = json.at("seed").get<long long>();
    future.times = json.at("times").get<std::vector<double>>();
    for (const FutureJson& body : json.at("bodies")) {
      future.ways[body.at("id").get<int>()] = wayOf(body.at("x"), body.at("y"));
    }
    if (json.contains("contact")) {
      const FutureJson& contact = json["contact"];
      future.contact = FutureContact{contact.at("time").get<double>(),
                                     contact.at("id").get<int>(),
                                     contact.at("other").get<int>(),
                                     {numberOf(contact.at("x")), numberOf(contact.at("y"))}};
    }
    future.failure = json.value("failure", std::string());
  } catch (const FutureJson::exception&) {
    return std::nullopt;
  }
  return future;
}

std::string encodeFuturesRequest(const FuturesRequest& request) {
  const Bundle& bundle = request.bundle;
  FutureJson branches = FutureJson::array();
  for (const RunBranch& branch : request.branches) {
    branches.push_back(branchJson(branch));
  }
  const FutureJson json = {{"path", bundle.path},
                           {"scenario", sim2d::writeScenario(*bundle.scenario)},
                           {"map", mapJson(*bundle.map)},
                           {"trees", treesJson(bundle.trees)},
                           {"exact", bundle.settings.exact},
                           {"compat", quirksText(bundle.settings.compatibility)},
                           {"branches", branches},
                           {"inputs", inputRows(request.inputs)},
                           {"at", request.at},
                           {"state", request.state},
                           {"options", request.options}};
  const std::vector<std::uint8_t> bytes = FutureJson::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

base::Result<FuturesRequest> decodeFuturesRequest(const std::string& bytes) {
  JsonDepthCheck shallow;
  if (!FutureJson::sax_parse(bytes, &shallow, FutureJson::input_format_t::cbor)) {
    return base::error("futures.bad-question");
  }
  const FutureJson json = FutureJson::from_cbor(bytes, true, false);
  try {
    if (std::optional<FuturesRequest> request = requestOf(json)) {
      return *std::move(request);
    }
  } catch (const FutureJson::exception&) {  // reported below
  }
  return base::error("futures.bad-question");
}

}  // namespace app
