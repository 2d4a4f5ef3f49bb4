#include "sim2d/trace/Inputs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace sim2d {
namespace {

constexpr char kInputColumns[] = "step,input,id,name,x,y,heading,vx,vy,omega,desired_vx,desired_vy";
constexpr std::size_t kFirstNumber = 4;
constexpr std::array<const char*, 11> kNames = {"robot", "open", "close",  "move",  "add", "set",
                                                "push",  "stop", "resume", "entry", "goal"};

/// In the order of the columns.
template <class AnyInput>
auto numbersOf(AnyInput& input) {
  return std::array{&input.pose.position.x(),   &input.pose.position.y(),  &input.pose.heading,
                    &input.velocity.x(),        &input.velocity.y(),       &input.omega,
                    &input.desiredVelocity.x(), &input.desiredVelocity.y()};
}

void readRow(CsvTable& row, RecordedInputs& inputs) {
  Input input;
  std::int64_t step = 0;
  row.read(0, step);
  const auto kind = std::find(kNames.begin(), kNames.end(), row[1].text);
  if (kind == kNames.end()) {
    row.error(1, "trace.unknown-input", {row[1].text});
  }
  input.kind = static_cast<InputKind>(kind - kNames.begin());
  row.read(2, input.id);
  input.name = row[3].text;
  std::size_t column = kFirstNumber;
  for (double* const number : numbersOf(input)) {
    const std::optional<double> value = base::parseDouble(row[column].text);
    if (!value || !std::isfinite(*value)) {
      row.error(column, "trace.no-finite-number", {row[column].text});
    }
    *number = value.value_or(0.0);
    ++column;
  }
  if (!inputs.empty() && step < inputs.back().first) {
    row.error(0, "trace.steps-backwards");
  }
  inputs.emplace_back(step, std::move(input));
}

}  // namespace

bool operator==(const Input& a, const Input& b) {
  return a.kind == b.kind && a.id == b.id && a.name == b.name && a.pose == b.pose &&
         a.velocity == b.velocity && a.omega == b.omega && a.desiredVelocity == b.desiredVelocity;
}

const char* inputKindName(InputKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

StepInputs inputsOf(const RecordedInputs& inputs, std::int64_t step) {
  StepInputs found;
  const auto isBefore = [](const auto& each, std::int64_t wanted) { return each.first < wanted; };
  for (auto each = std::lower_bound(inputs.begin(), inputs.end(), step, isBefore);
       each != inputs.end() && each->first == step; ++each) {
    found.push_back(each->second);
  }
  return found;
}

std::string inputsHeader() {
  return std::string(kInputColumns) + '\n';
}

void appendInputRow(std::string& to, std::int64_t step, const Input& input) {
  to +=
      std::to_string(step) + ',' + inputKindName(input.kind) + ',' + std::to_string(input.id) + ',';
  appendCsvField(to, input.name);
  for (const double* const number : numbersOf(input)) {
    to += ',' + base::formatDouble(*number);
  }
  to += '\n';
}

base::Result<RecordedInputs> parseInputs(const std::string& text, const std::string& file) {
  return readCsvTable<RecordedInputs>(text, file, kInputColumns, readRow);
}

}  // namespace sim2d
