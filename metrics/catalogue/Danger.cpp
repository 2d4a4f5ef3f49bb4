#include "metrics/Interaction.h"
#include "metrics/MetricRegistry.h"
#include "metrics/TermSums.h"

namespace metrics {

namespace {

class DangerSum : public PersonCosts {
 public:
  DangerSum() : PersonCosts(2) {}

 protected:
  bool addCosts(const Instant& at, const Person& person, std::vector<double>& costs) override {
    costs[0] = fearCost(at.now.robot, person, at.parameters);
    costs[1] = panicCost(at.now.robot, person, at.parameters);
    return true;
  }
};

void addCost(MetricRegistry& to, MetricInfo info, std::size_t cost) {
  const std::string key = info.key;
  to.add(std::move(info), streamOf<DangerSum>([cost](const DangerSum& sum, const Instant& last) {
           return sum.value(cost, last);
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
           "[0, inf)", Kind::Number, 30},
          0);
  addCost(
      to,
      {"danger_panic_cost", "Danger: panic", "1/s", Category::DangerSurprise, Better::Lower, needs,
       "sum over i, a of near misses: (|V|/d) * m/(m - R), m = miss distance of the centres",
       source, "[0, inf)", Kind::Number, 31},
      1);
}

}  // namespace metrics
