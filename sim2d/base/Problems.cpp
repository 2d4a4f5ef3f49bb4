#include "sim2d/base/Problems.h"

#include <algorithm>

namespace base {
namespace {

constexpr ProblemText kTexts[] = {
    // Names, numbers and references of a scenario.
    {"scenario.bad-person-name", "a person cannot have the name '{name}'"},
    {"scenario.bad-name",
     "'{name}' cannot be a name (letters, digits and _, a letter first, no key of the file)"},
    {"scenario.name-twice", "the name '{name}' is there twice"},
    {"scenario.id-negative", "{name}: needs an id from 0 on"},
    {"scenario.id-twice", "{name}: id {id} is that of {other} too"},
    {"scenario.ids-not-in-order",
     "the ids are not 1, 2, 3 … in the order of agents: HuNavSim's Isaac wrapper cannot run that"},
    {"scenario.goal-below-one", "goal {goal}: goals are numbered from 1"},
    {"scenario.goal-twice", "goal {goal} is there twice"},
    {"scenario.goal-missing",
     "goal {goal} is missing in global_goals: HuNavSim stops counting there"},
    {"scenario.goal-undefined", "{name}: goal {goal} is not defined"},
    {"scenario.unknown-word",
     "{name?%: }{key} '{found}' is unknown ({nearest?did you mean '%'? }known: {known})"},
    {"scenario.map-name", "map '{found}' counts as '{map}' (no folder, no extension)"},
    {"scenario.nobody", "there is nobody in this scenario"},
    {"scenario.no-robot", "there is no robot: what is measured about it stays empty"},
    {"planner.unknown-parameter", "{path}: unknown to '{planner}'{nearest}"},
    {"planner.not-a-distance", "{path}: '{found}' is not a distance"},
    {"source.no-like", "{name}: a source needs 'like', the person it copies"},
    {"source.like-unknown", "{name}: there is no person '{found}' to copy"},
    {"source.no-rate", "{name}: without a 'rate' nobody arrives"},
    {"source.until-before-from", "{name}: 'until' is before 'from', nobody arrives"},

    // One person, one shape.
    {"person.out-of-range",
     "{name}: {key} {found} is outside {low} to {high}, HuNavSim's loader will clamp it"},
    {"person.vel-too-high", "{name}: vel {found} is above 1.8, HuNavSim's loader will clamp it"},
    {"person.behavior-incomplete", "{name}: missing in behavior, so these count: {values}"},
    {"person.skin-unknown", "{name}: skin {found} counts as {skin} (0 to {most} with {simulator})"},
    {"person.no-init-pose", "{name}: without init_pose the start is 0, 0"},
    {"person.no-goals", "{name}: has no goals (HuNavSim's loader refuses that)"},
    {"person.wait-count",
     "{name}: wait needs one number for each of the {goals} goals, has {found}"},
    {"person.name-is-key",
     "a person called '{name}' can have no settings of ours: that is a key of the block"},
    {"shape.sides-cross", "{name}: the sides of the polygon cross"},
    {"shape.door-without-length", "{name}: both ends are the same point"},
    {"shape.too-far", "{name}: {x}, {y} is beyond a million metres or no number"},
    {"shape.no-angle", "{name}: the heading {found} is no angle"},

    // Starts, goals and ways: does a body fit, can it get there.
    {"places.too-wide",
     "starts, goals and obstacles lie too far apart to check for ways round obstacles without a "
     "map"},
    {"places.no-place",
     "{name?%: }{place} {point}: a body of radius {radius} fits neither there nor anywhere within "
     "1 m"},
    {"places.moved",
     "{name?%: }{place} {point}: a body of radius {radius} does not fit, a run takes {taken}"},
    {"places.unknown-ground", "{name?%: }{place} {point}: the map does not know this place"},
    {"places.no-way",
     "{name}: there is no way from the start to goal {goal} {point}, it is left out"},
    {"places.no-way-for-robot",
     "{name}: there is no way from the start to {name}: goal {point}, it is left out"},
    {"places.wall-between", "{name}: a wall stands in the straight line to {goal}"},
    {"places.wall-between-planned",
     "{name}: a wall stands in the straight line to {goal} (HuNavSim's people walk straight)"},
};

}  // namespace

const std::vector<ProblemText>& problemTexts() {
  static const std::vector<ProblemText> kAll(std::begin(kTexts), std::end(kTexts));
  return kAll;
}

const ProblemText* problemText(std::string_view id) {
  const auto* found = std::find_if(std::begin(kTexts), std::end(kTexts),
                                   [id](const ProblemText& each) { return each.id == id; });
  return found == std::end(kTexts) ? nullptr : found;
}

}  // namespace base
