#pragma once

#include <string>
#include <vector>

#include "metrics/Expression.h"

/// What an expression can name.
namespace metrics {

enum class Scope { Run, Sample, Person };  // how often a value may differ

struct VariableName {
  std::string name;
  Scope scope = Scope::Run;
  Expression::Value value;
  bool needsRobot = false, needsPeople = false;
  bool isOfEnd = false;  // known when the run is over
};
const std::vector<VariableName>& variableNames();

/// Of numbers: abs(x) …
struct FunctionName {
  std::string name;
  std::size_t arguments = 1;
  double (*apply)(const double* arguments) = nullptr;
};
const std::vector<FunctionName>& functionNames();

/// Over time: min, max, mean, sum, integral, count, first, last.
struct TotalName {
  std::string name;
  Expression::Result result;
};
const std::vector<TotalName>& totalNames();
/// Over the people of a sample: people_min …, any, all.
const std::vector<TotalName>& peopleTotalNames();
double overPeople(const Expression::Place& place, const Expression::Value& term,
                  Expression::Result result);

}  // namespace metrics
