#include "sim2d/scenario/ExportGoals.h"

#include <algorithm>
#include <vector>

#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {

GoalNumbers numbersWithoutGaps(const Scenario& scenario) {
  GoalNumbers numbers;
  for (const GlobalGoal& goal : scenario.goals) {
    numbers[goal.id] = 0;
  }
  int next = 1;
  for (auto& [old, now] : numbers) {
    now = next++;
  }
  return numbers;
}

GoalNumbers numbersOfDialectB(const Scenario& scenario) {
  GoalNumbers numbers;
  int next = 1;
  for (const GlobalGoal& goal : goalsOfNobody(scenario)) {
    numbers.emplace(goal.id, next++);
  }
  for (const bool listed : {true, false}) {  // as they stand in the file
    for (const Human& human : scenario.humans) {
      for (const int goal : human.listed == listed ? human.goals : std::vector<int>()) {
        if (scenario.goal(goal) != nullptr) {
          numbers.emplace(goal, next++);  // one more even where the goal has its number
        }
      }
    }
  }
  return numbers;
}

void renumberGoals(Scenario& scenario, const GoalNumbers& numbers) {
  const auto renumber = [&numbers](int& goal) {
    const auto found = numbers.find(goal);
    goal = found == numbers.end() ? goal : found->second;
  };
  for (GlobalGoal& goal : scenario.goals) {
    renumber(goal.id);
  }
  std::stable_sort(scenario.goals.begin(), scenario.goals.end(),
                   [](const GlobalGoal& a, const GlobalGoal& b) { return a.id < b.id; });
  for (Human& human : scenario.humans) {
    std::for_each(human.goals.begin(), human.goals.end(), renumber);
  }
  for (Robot& robot : scenario.robots) {
    std::for_each(robot.goal.goals.begin(), robot.goal.goals.end(), renumber);
  }
}

GoalNumbers chained(const GoalNumbers& first, const GoalNumbers& second) {
  GoalNumbers numbers = first;
  for (auto& [old, now] : numbers) {
    const auto found = second.find(now);
    now = found == second.end() ? now : found->second;
  }
  return numbers;
}

}  // namespace sim2d
