#include "metrics/Interaction.h"
#include "metrics/MetricRegistry.h"
#include "metrics/PersonCosts.h"

namespace metrics {

namespace {

class DangerSum : public PersonCosts {
 public:
  explicit DangerSum(const MetricParameters& given) : PersonCosts(2, given) {}

 protected:
  bool addCosts(const Recording& /*recording*/, const Sample& sample, const Person& person,
                std::vector<double>& costs) override {
    costs[0] = fearCost(sample.robot, person, parameters());
    costs[1] = panicCost(sample.robot, person, parameters());
    return true;
  }
};

void addCost(MetricRegistry& to, MetricInfo info, std::size_t cost) {
  const std::string key = info.key;
  to.addStream(std::move(info),
               streamOf<DangerSum>(
                   "danger",
                   [cost](const DangerSum& sum, const Recording& /*recording*/,
                          const MetricParameters& /*parameters*/) { return sum.value(cost); },
                   [](const MetricParameters& parameters) {
                     return std::make_unique<DangerSum>(parameters);
                   }));
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
          0);
  addCost(
      to,
      {"danger_panic_cost", "Danger: panic", "1/s", Category::DangerSurprise, Better::Lower, needs,
       "sum over i, a of near misses: (|V|/d) * m/(m - R), m = miss distance of the centres",
       source, "[0, inf)", Kind::Number, 31, ""},
      1);
}

}  // namespace metrics
