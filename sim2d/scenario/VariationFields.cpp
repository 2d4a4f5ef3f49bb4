#include <map>

#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/ScenarioTree.h"
#include "sim2d/scenario/Variation.h"

/// The key `variation`: a preset, and a map for each quantity. The table names the keys of these
/// maps with a dot: `speed.sd`.
namespace sim2d {
namespace {

/// How far from the middle a draw may lie, and how wide its distribution may be.
double widestOf(Varied quantity) {
  switch (quantity) {
    case Varied::StartTime:
      return base::kTime.high;
    case Varied::Start:
      return 1000.0;  // [m]
    case Varied::Heading:
      return base::kAngleWidth.high;
    case Varied::Speed:
    case Varied::ReactionTime:
      return 100.0;  // times what is written
    case Varied::FirstGoal:
      break;
  }
  return base::kLargestValue;
}

/// "speed.sd": the map, and the key in it; no map: empty.
std::pair<std::string, std::string> partsOf(const std::string& key) {
  const std::size_t dot = key.find('.');
  return dot == std::string::npos ? std::pair(std::string(), key)
                                  : std::pair(key.substr(0, dot), key.substr(dot + 1));
}

/// The description of the key as it is in its own map.
ParameterSpec innerSpec(const ParameterSpec& spec) {
  ParameterSpec inner = spec;
  inner.key = partsOf(spec.key).second;
  return inner;
}

template <class M>
FieldOf<VariationSettings> spreadField(Varied quantity, const char* key, M SpreadSettings::*member,
                                       std::string help, base::FormHints form, Range range) {
  const VariedQuantity& facts = variedQuantity(quantity);
  form.label = std::string(facts.label) + ": " + form.label;
  constexpr bool kIsNumber = std::is_same_v<M, std::optional<double>>;
  return FieldOf<VariationSettings>(std::string(facts.key) + "." + key, std::move(help),
                                    std::move(form), kIsNumber ? facts.unit : "", range)
      .keptAt([ quantity, member ](auto& of) -> auto& { return of.of(quantity).*member; });
}

/// The limits lie round what is written, so that no two keys can be at odds.
void addSpread(Varied quantity, const std::string& help, Fields<VariationSettings>& to) {
  const VariedQuantity& facts = variedQuantity(quantity);
  const double centre = facts.isFactor ? 1.0 : 0.0;
  const double widest = widestOf(quantity);
  const double least = facts.isFactor ? facts.least : -widest;
  const double most = facts.isFactor ? facts.most : widest;
  const Range width{0.0, widest};
  using S = SpreadSettings;
  to.push_back(
      spreadField(quantity, "kind", &S::kind, help + "; absent: the preset's", {"drawn"}, {})
          .words({"none", "normal", "uniform"}));
  to.push_back(spreadField(quantity, "sd", &S::sd, "Normal: the standard deviation",
                           {"deviation", 2, 0.05}, width));
  to.push_back(spreadField(quantity, "half_width", &S::halfWidth, "Uniform: so much either way",
                           {"half width", 2, 0.05}, width));
  to.push_back(
      spreadField(quantity, "min", &S::min, "Never below", {"least", 2, 0.1}, {least, centre}));
  to.push_back(
      spreadField(quantity, "max", &S::max, "Never above", {"most", 2, 0.1}, {centre, most}));
}

/// Keys that nothing comes of: that of a width is for one kind of drawing.
void warnUnused(YamlMap& view, const SpreadSettings& own, SpreadKind kind) {
  static const std::vector<std::string> kWords = {"none", "normal", "uniform"};
  const auto warn = [&](const char* key, bool isGiven, bool isUsed) {
    if (isGiven && !isUsed) {
      view.warning(key, "scenario.spread-unused", {key, kWords[static_cast<std::size_t>(kind)]});
    }
  };
  const bool isDrawn = kind != SpreadKind::None;
  warn("sd", own.sd.has_value(), kind == SpreadKind::Normal);
  warn("half_width", own.halfWidth.has_value(), kind == SpreadKind::Uniform);
  warn("min", own.min.has_value(), isDrawn);
  warn("max", own.max.has_value(), isDrawn);
}

}  // namespace

Fields<VariationSettings> variationFields() {
  Fields<VariationSettings> all;
  all.push_back(field("preset", &VariationSettings::preset,
                      "How much people differ from seed to seed; keys of a quantity come first",
                      {"People differ"})
                    .words({"none", "light", "strong"})
                    .orElse(VariationPreset::None));
  addSpread(Varied::StartTime, "Added to the start time", all);
  addSpread(Varied::Start, "Added to x and to y of the start", all);
  addSpread(Varied::Heading, "Added to the heading at the start", all);
  addSpread(Varied::Speed, "Factor of max_vel", all);
  addSpread(Varied::ReactionTime, "Factor of how slowly a person reacts to others", all);
  addSpread(Varied::FirstGoal, "Goals of a repeated route that are left out at first", all);
  return all;
}

void readVariation(YamlMap& view, DesktopSettings& to) {
  VariationSettings& variation = to.variation;
  YamlMap map = view.map("variation");
  std::map<std::string, YamlMap> spreads;
  for (const auto& field : fieldsOf<VariationSettings>()) {
    const std::string part = partsOf(field.spec.key).first;
    if (!part.empty() && spreads.count(part) == 0) {
      spreads.emplace(part, map.map(part));
    }
    YamlMap& at = part.empty() ? map : spreads.at(part);
    field.assign(variation, readValue(at, innerSpec(field.spec), field.isWide));
  }
  for (std::size_t i = 0; i < kVariedCount; ++i) {
    const auto quantity = static_cast<Varied>(i);
    YamlMap& spread = spreads.at(variedQuantity(quantity).key);
    warnUnused(spread, variation.of(quantity), spreadOf(variation, quantity).kind);
    variation.of(quantity).unknown = spread.takeUnknown();
  }
  variation.unknown = map.takeUnknown();
}

void writeVariation(YamlNode& tree, const DesktopSettings& desktop) {
  const VariationSettings& variation = desktop.variation;
  YamlNode map;
  for (const auto& field : fieldsOf<VariationSettings>()) {
    const ParameterValue value = field.value(variation);
    const std::string part = partsOf(field.spec.key).first;
    if (value != ParameterValue()) {
      writeValue(part.empty() ? map : map.child(part), innerSpec(field.spec), value, field.digits);
    }
  }
  for (std::size_t i = 0; i < kVariedCount; ++i) {
    const auto quantity = static_cast<Varied>(i);
    if (const UnknownKeys& unknown = variation.of(quantity).unknown; !unknown.empty()) {
      setUnknown(map.child(variedQuantity(quantity).key), unknown);
    }
  }
  setUnknown(map, variation.unknown);
  if (!map.isNull()) {
    setChild(tree, "variation", std::move(map));
  }
}

}  // namespace sim2d
