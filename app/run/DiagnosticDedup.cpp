#include "app/run/DiagnosticDedup.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace app {

namespace {

struct DuplicateRule {
  std::string_view code, of;
};
constexpr DuplicateRule kDuplicateRules[] = {
    {"scenario.nobody-listed", "scenario.nobody"},
    {"tree.no-goal", "scenario.goal-undefined"},
    {"world.body-moved", "places.moved"},
    {"world.body-does-not-fit", "places.no-place"},
    {"world.goal-out-of-reach", "places.no-way"},
    {"world.point-out-of-reach", "places.no-way"},
    {"world.point-out-of-reach", "places.no-way-to-point"}};

}  // namespace

base::Diagnostics withoutDuplicates(const base::Diagnostics& some, const base::Diagnostics& all) {
  using Subject = std::tuple<base::EntityId, std::string_view, std::string>;  // entity, code, goal
  std::set<Subject> reported;
  for (const base::Diagnostic& issue : all) {
    for (const base::EntityId thing : {issue.entity, base::EntityId()}) {
      reported.insert({thing, issue.code, issue.value("goal")});
      reported.insert({thing, issue.code, std::string()});
    }
  }
  base::Diagnostics left;
  std::copy_if(some.begin(), some.end(), std::back_inserter(left), [&](const auto& issue) {
    return std::none_of(std::begin(kDuplicateRules), std::end(kDuplicateRules),
                        [&](const DuplicateRule& echo) {
                          return echo.code == issue.code &&
                                 reported.count({issue.entity, echo.of, issue.value("goal")}) > 0;
                        });
  });
  return left;
}

base::Diagnostics newDiagnostics(const base::Diagnostics& reported, const base::Diagnostics& more) {
  std::set<std::string> lines;
  for (const base::Diagnostic& problem : reported) {
    lines.insert(problem.text());
  }
  base::Diagnostics rest;
  std::copy_if(more.begin(), more.end(), std::back_inserter(rest),
               [&lines](const auto& problem) { return lines.count(problem.text()) == 0; });
  return rest;
}

}  // namespace app
