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

}  // namespace

void addDanger(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Singamaneni, Favier, Alami, RO-MAN 2023";
  to.addSum({"danger_fear_cost", "Danger: fear", "1/s", Category::DangerSurprise, Better::Lower,
             needs, "sum over i, a of min(1/ttc, fear_cap), 0 without a collision course", source,
             "[0, inf)", Kind::Number, 30},
            streamOfPart<DangerSum>(0));
  to.addSum(
      {"danger_panic_cost", "Danger: panic", "1/s", Category::DangerSurprise, Better::Lower, needs,
       "sum over i, a of near misses: (|V|/d) * m/(m - R), m = miss distance of the centres",
       source, "[0, inf)", Kind::Number, 31},
      streamOfPart<DangerSum>(1));
}

}  // namespace metrics
