#include <cmath>

#include "bt/engine/Script.h"
#include "bt/tree/TextValue.h"

namespace bt {
namespace {

using Comparison = Script::Comparison;

void setNumber(Value& value, double number) {
  value.type = ValueType::Double;
  value.real = number;
  value.text.clear();
}

/// Numbers within a script are doubles.
void copyNumber(Value& to, const Value& from) {
  if (from.type == ValueType::String) {
    to = from;
  } else {
    setNumber(to, from.number());
  }
}

template <class T>
bool ordered(Comparison comparison, const T& left, const T& right) {
  switch (comparison) {
    case Comparison::Less:
      return left < right;
    case Comparison::Greater:
      return left > right;
    case Comparison::LessEqual:
      return left <= right;
    case Comparison::GreaterEqual:
      return left >= right;
    case Comparison::Equal:
      return left == right;
    case Comparison::NotEqual:
      return left != right;
  }
  return false;
}

bool compareNumbers(Comparison comparison, double left, double right) {
  const bool same = std::fabs(left - right) <= kScriptTolerance;
  if (comparison == Comparison::Equal || comparison == Comparison::NotEqual) {
    return same == (comparison == Comparison::Equal);
  }
  return ordered(comparison, left, right);
}

std::optional<double> numberOf(const Value& value) {
  return value.type == ValueType::String ? doubleFromText(value.text)
                                         : std::optional<double>(value.number());
}

/// Nothing = text that is no number against a number.
std::optional<bool> compareValues(Comparison comparison, const Value& left, const Value& right) {
  if (left.type == ValueType::String && right.type == ValueType::String) {
    return ordered(comparison, left.text, right.text);
  }
  const std::optional<double> a = numberOf(left);
  const std::optional<double> b = numberOf(right);
  if (!a || !b) {
    return std::nullopt;
  }
  return compareNumbers(comparison, *a, *b);
}

std::optional<std::int64_t> bitsOf(const Value& value) {
  constexpr double kLargest = 9007199254740992.0;  // 2^53: whole numbers are exact up to it
  const double number = value.number();
  if (!value.isNumber() || !(std::fabs(number) <= kLargest) || number != std::floor(number)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(number);
}

}  // namespace

bool ScriptRunner::run() {
  while (next_ < script_.code.size()) {
    const ScriptInstruction& instruction = script_.code[next_++];
    if (!execute(instruction)) {
      return false;
    }
  }
  return true;
}

std::optional<bool> ScriptRunner::truth() const {
  if (!result().isNumber()) {
    return std::nullopt;
  }
  return result().number() != 0.0;
}

bool ScriptRunner::execute(const ScriptInstruction& instruction) {
  switch (instruction.code) {
    case Code::Number:
      setNumber(stack_[size_++], instruction.number);
      return true;
    case Code::Text: {
      Value& place = stack_[size_++];
      place.type = ValueType::String;
      place.text = script_.texts[static_cast<std::size_t>(instruction.index)];
      return true;
    }
    case Code::Load:
      return load(instruction.index);
    case Code::Create:
    case Code::Assign:
    case Code::AddTo:
    case Code::SubtractFrom:
    case Code::MultiplyBy:
    case Code::DivideBy:
      return assign(instruction);
    case Code::BitNot:
    case Code::Not:
    case Code::Negate:
      return unary(instruction.code);
    case Code::Compare:
      return compare(script_.chains[static_cast<std::size_t>(instruction.index)]);
    case Code::JumpIfFalse:
    case Code::Jump:
      return jump(instruction);
    case Code::Drop:
      --size_;
      return true;
    default:
      return binary(instruction.code);
  }
}

bool ScriptRunner::load(int slot) {
  const Value& value = slots_[static_cast<std::size_t>(slot)].value;
  if (value.type == ValueType::Unset) {
    return fail("a variable of the script has no value");
  }
  copyNumber(stack_[size_++], value);
  return true;
}

bool ScriptRunner::assign(const ScriptInstruction& instruction) {
  Slot& slot = slots_[static_cast<std::size_t>(instruction.index)];
  if (!slot.exists && instruction.code != Code::Create) {
    return fail("an entry that is assigned does not exist (create it with ':=')");
  }
  if (instruction.code != Code::Create && instruction.code != Code::Assign) {
    if (slot.value.type == ValueType::Unset) {
      return fail("an entry that is changed has no value");
    }
    Value changed;
    copyNumber(changed, slot.value);
    const Code operation = instruction.code == Code::AddTo          ? Code::Add
                           : instruction.code == Code::SubtractFrom ? Code::Subtract
                           : instruction.code == Code::MultiplyBy   ? Code::Multiply
                                                                    : Code::Divide;
    if (!arithmetic(operation, changed, top())) {
      return false;
    }
    top() = changed;
  }
  const bool holdsText = slot.value.type == ValueType::String;
  const bool givesText = top().type == ValueType::String;
  const bool mixed =
      slot.type == PortType::Any && slot.value.type != ValueType::Unset && holdsText != givesText;
  if (mixed || !store(slot, top())) {
    return fail("the value '" + top().toText() + "' does not fit the type of the entry");
  }
  return true;
}

bool ScriptRunner::binary(Code code) {
  const Value& right = top();
  Value& left = top(1);
  --size_;
  switch (code) {
    case Code::Concat:
      if (left.type != ValueType::String) {
        left.text = left.toText();
        left.type = ValueType::String;
      }
      left.text += right.type == ValueType::String ? right.text : right.toText();
      return true;
    case Code::And:
    case Code::Or: {
      if (!left.isNumber() || !right.isNumber()) {
        return fail("text is used as a condition");
      }
      const bool a = left.number() != 0.0;
      const bool b = right.number() != 0.0;
      setNumber(left, (code == Code::And ? a && b : a || b) ? 1.0 : 0.0);
      return true;
    }
    case Code::BitAnd:
    case Code::BitOr:
    case Code::BitXor:
      return bits(code, left, right);
    default:
      return arithmetic(code, left, right);
  }
}

bool ScriptRunner::arithmetic(Code code, Value& left, const Value& right) {
  if (code == Code::Add && left.type == ValueType::String && right.type == ValueType::String) {
    left.text += right.text;
    return true;
  }
  if (!left.isNumber() || !right.isNumber()) {
    return fail("arithmetic with text (join it with '..')");
  }
  const double a = left.number();
  const double b = right.number();
  setNumber(left, code == Code::Add        ? a + b
                  : code == Code::Subtract ? a - b
                  : code == Code::Multiply ? a * b
                                           : a / b);
  return true;
}

bool ScriptRunner::bits(Code code, Value& left, const Value& right) {
  const std::optional<std::int64_t> a = bitsOf(left);
  const std::optional<std::int64_t> b = bitsOf(right);
  if (!a || !b) {
    return fail("bits of something that is no whole number");
  }
  const std::int64_t result = code == Code::BitAnd  ? (*a & *b)
                              : code == Code::BitOr ? (*a | *b)
                                                    : (*a ^ *b);
  setNumber(left, static_cast<double>(result));
  return true;
}

bool ScriptRunner::unary(Code code) {
  Value& value = top();
  if (!value.isNumber()) {
    return fail("a sign before text");
  }
  if (code == Code::Negate) {
    setNumber(value, -value.number());
  } else if (code == Code::Not) {
    setNumber(value, value.number() == 0.0 ? 1.0 : 0.0);
  } else {
    const std::optional<std::int64_t> number = bitsOf(value);
    if (!number) {
      return fail("bits of something that is no whole number");
    }
    setNumber(value, static_cast<double>(~*number));
  }
  return true;
}

bool ScriptRunner::compare(const std::vector<Comparison>& chain) {
  const std::size_t first = size_ - 1 - chain.size();
  bool all = true;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::optional<bool> holds =
        compareValues(chain[i], stack_[first + i], stack_[first + i + 1]);
    if (!holds) {
      return fail("text that is no number is compared with a number");
    }
    all = all && *holds;
  }
  size_ = first + 1;
  setNumber(top(), all ? 1.0 : 0.0);
  return true;
}

bool ScriptRunner::jump(const ScriptInstruction& instruction) {
  bool leave = true;
  if (instruction.code == Code::JumpIfFalse) {
    if (!top().isNumber()) {
      return fail("text is used as a condition");
    }
    leave = top().number() == 0.0;
    --size_;
  }
  next_ = leave ? static_cast<std::size_t>(instruction.index) : next_;
  return true;
}

}  // namespace bt
