#include "metrics/Interaction.h"
#include "metrics/MetricRegistry.h"
#include "metrics/PersonCosts.h"

namespace metrics {

namespace {

using Cost = double (*)(const Body&, const Body&, const MetricParameters&);

class DangerSum : public PersonCosts {
 public:
  DangerSum(Cost cost, const MetricParameters& parameters) : PersonCosts(parameters), cost_(cost) {}

 protected:
  std::optional<double> costOf(const Recording& /*recording*/, const Sample& sample,
                               const Person& person) override {
    return cost_(sample.robot, person, parameters());
  }

 private:
  Cost cost_;
};

void addCost(MetricRegistry& to, MetricInfo info, Cost cost) {
  const std::string key = info.key;
  to.addAccumulated(std::move(info), [cost](const MetricParameters& parameters) {
    return std::make_unique<DangerSum>(cost, parameters);
  });
  to.addMeanOf(key);
}

}  // namespace

void addDanger(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Singamaneni, Favier, Alami, RO-MAN 2023";
  addCost(to,
          {"danger_fear_cost", "Danger: fear", "1/s", Category::DangerSurprise, Better::Lower,
           needs, "sum over i, a of min(1/ttc, fear_cap), 0 without a collision course", source,
           "[0, inf)", Kind::Number, 30, ""},
          fearCost);
  addCost(
      to,
      {"danger_panic_cost", "Danger: panic", "1/s", Category::DangerSurprise, Better::Lower, needs,
       "sum over i, a of near misses: (|V|/d) * m/(m - R), m = miss distance of the centres",
       source, "[0, inf)", Kind::Number, 31, ""},
      panicCost);
}

}  // namespace metrics
