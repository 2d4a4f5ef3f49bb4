#include "app/run/Echoes.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace app {

namespace {

struct Echo {
  std::string_view code, of;
};
constexpr Echo kEchoes[] = {{"scenario.nobody-listed", "scenario.nobody"},
                            {"tree.no-goal", "scenario.goal-undefined"},
                            {"world.body-moved", "places.moved"},
                            {"world.body-does-not-fit", "places.no-place"},
                            {"world.goal-out-of-reach", "places.no-way"},
                            {"world.point-out-of-reach", "places.no-way"},
                            {"world.point-out-of-reach", "places.no-way-to-point"}};

}  // namespace

base::Diagnostics withoutEchoes(const base::Diagnostics& some, const base::Diagnostics& all) {
  using About = std::tuple<base::EntityId, std::string_view, std::string>;  // thing, code, goal
  std::set<About> told;
  for (const base::Diagnostic& issue : all) {
    for (const base::EntityId thing : {issue.entity, base::EntityId()}) {
      told.insert({thing, issue.code, issue.value("goal")});
      told.insert({thing, issue.code, std::string()});
    }
  }
  base::Diagnostics left;
  std::copy_if(some.begin(), some.end(), std::back_inserter(left), [&](const auto& issue) {
    return std::none_of(std::begin(kEchoes), std::end(kEchoes), [&](const Echo& echo) {
      return echo.code == issue.code &&
             told.count({issue.entity, echo.of, issue.value("goal")}) > 0;
    });
  });
  return left;
}

base::Diagnostics notYetTold(const base::Diagnostics& told, const base::Diagnostics& more) {
  std::set<std::string> lines;
  for (const base::Diagnostic& problem : told) {
    lines.insert(problem.text());
  }
  base::Diagnostics rest;
  std::copy_if(more.begin(), more.end(), std::back_inserter(rest),
               [&lines](const auto& problem) { return lines.count(problem.text()) == 0; });
  return rest;
}

}  // namespace app
