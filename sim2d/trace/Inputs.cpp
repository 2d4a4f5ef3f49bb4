#include "sim2d/trace/Inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace sim2d {
namespace {

constexpr char kColumns[] = "step,input,id,name,x,y,heading,vx,vy,omega,desired_vx,desired_vy";
constexpr std::size_t kWidth = 12;
constexpr std::size_t kFirstNumber = 4;
constexpr std::array<const char*, 7> kNames = {"robot", "open", "close", "move",
                                               "add",   "set",  "push"};

/// In the order of the columns.
template <class AnyInput>
auto numbersOf(AnyInput& input) {
  return std::array{&input.pose.position.x(),   &input.pose.position.y(),  &input.pose.heading,
                    &input.velocity.x(),        &input.velocity.y(),       &input.omega,
                    &input.desiredVelocity.x(), &input.desiredVelocity.y()};
}

/// Reads one row after the other; problems are noted.
class InputsReader {
 public:
  InputsReader(const std::string& text, const std::string& file) : csv_(text), file_(file) {}

  base::Result<RecordedInputs> read() {
    CsvRow row;
    std::string head;
    csv_.next(row);
    for (const CsvField& field : row) {
      head += (head.empty() ? "" : ",") + field.text;
    }
    if (head != kColumns) {
      return base::makeError(std::string("the first line must be ") + kColumns, file_, 1, 1);
    }
    while (csv_.next(row)) {
      readRow(row);
    }
    if (base::hasErrors(problems_)) {
      return problems_;
    }
    return std::move(inputs_);
  }

 private:
  void error(const CsvField& field, const std::string& message) {
    problems_.push_back(base::makeError(message, file_, field.line, field.column));
  }

  long long whole(const CsvField& field, const char* name) {
    const std::optional<long long> value = base::parseInt(field.text);
    constexpr long long kMost = std::numeric_limits<int>::max();
    const bool isWhole = value && *value >= -kMost && *value <= kMost;
    if (!isWhole) {
      error(field, std::string(name) + " is not a whole number: '" + field.text + "'");
    }
    return isWhole ? *value : 0;
  }

  void readRow(const CsvRow& row) {
    if (csv_.isTruncated() || row.size() != kWidth) {
      error(row.back(), csv_.isTruncated() ? "the file ends inside this line (cut?)"
                                           : "the line has " + std::to_string(row.size()) +
                                                 " fields instead of " + std::to_string(kWidth));
      return;
    }
    Input input;
    const std::int64_t step = whole(row[0], "step");
    const auto kind = std::find(kNames.begin(), kNames.end(), row[1].text);
    if (kind == kNames.end()) {
      error(row[1], "unknown input '" + row[1].text + "'");
    }
    input.kind = static_cast<InputKind>(kind - kNames.begin());
    input.id = static_cast<int>(whole(row[2], "id"));
    input.name = row[3].text;
    std::size_t column = kFirstNumber;
    for (double* const number : numbersOf(input)) {
      const std::optional<double> value = base::parseDouble(row[column].text);
      if (!value || !std::isfinite(*value)) {
        error(row[column], "not a finite number: '" + row[column].text + "'");
      }
      *number = value.value_or(0.0);
      ++column;
    }
    if (!inputs_.empty() && step < inputs_.back().first) {
      error(row[0], "steps run backwards");
    }
    inputs_.emplace_back(step, std::move(input));
  }

  CsvReader csv_;
  std::string file_;
  base::Diagnostics problems_;
  RecordedInputs inputs_;
};

}  // namespace

const char* inputKindName(InputKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

std::string inputsHead() {
  return std::string(kColumns) + '\n';
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
  return InputsReader(text, file).read();
}

}  // namespace sim2d
