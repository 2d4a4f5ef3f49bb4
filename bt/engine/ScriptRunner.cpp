#include <cmath>
#include <utility>

#include "bt/engine/Script.h"
#include "bt/tree/NodeCatalogue.h"

namespace bt {
namespace {

using Kind = ScriptExpression::Kind;

constexpr std::size_t kMaxText = std::size_t{1} << 20U;  // [B] stops scripts that double a text

void setNumber(Value& value, double number) {
  value.type = ValueType::Double;
  value.real = number;
  value.text.clear();
}

/// Compares like BehaviorTree.CPP, which matters for NaN (0 / 0).
template <class T>
bool ordered(ScriptOperator sign, const T& left, const T& right) {
  switch (sign) {
    case ScriptOperator::Less:
      return !(left >= right);
    case ScriptOperator::Greater:
      return !(left <= right);
    case ScriptOperator::LessEqual:
      return !(left > right);
    case ScriptOperator::GreaterEqual:
      return !(left < right);
    case ScriptOperator::NotEqual:
      return left != right;
    default:
      return left == right;
  }
}

bool isOperand(const Value& value) {
  return value.isNumber() || value.type == ValueType::String;
}

std::optional<double> numberOf(const Value& value) {
  if (value.type != ValueType::String) {
    return value.number();
  }
  const bool isWord = value.text == "true" || value.text == "false";
  return isWord ? std::optional<double>(value.text == "true" ? 1.0 : 0.0)
                : doubleFromText(value.text);
}

/// Empty: text, or an integer other than 0 and 1.
std::optional<bool> conditionValue(const Value& value) {
  return value.isNumber() ? valueAs<bool>(value) : std::nullopt;
}

/// Empty: non-numeric text compared with a number, or no value.
std::optional<bool> compareValues(ScriptOperator sign, const Value& left, const Value& right) {
  if (left.type == ValueType::String && right.type == ValueType::String) {
    return ordered(sign, left.text, right.text);
  }
  if (!isOperand(left) || !isOperand(right)) {
    return std::nullopt;
  }
  const std::optional<double> a = numberOf(left);
  const std::optional<double> b = numberOf(right);
  if (!a || !b) {
    return std::nullopt;
  }
  if (sign == ScriptOperator::Equal || sign == ScriptOperator::NotEqual) {
    const bool same = std::fabs(*a - *b) <= kScriptTolerance;
    return same == (sign == ScriptOperator::Equal);
  }
  return ordered(sign, *a, *b);
}

std::string typeMismatchMessage(const Slot& slot, const Value& value) {
  const bool isCut = slot.value.isWhole() && value.type == ValueType::Double;
  return "the value '" + value.toText() + "' does not fit the type of the entry" +
         (isCut ? ", which is an integer (start with 1.0 instead of 1)" : "");
}

std::optional<std::int64_t> bitsOf(const Value& value) {
  constexpr double kLargest = 9007199254740992.0;  // 2^53: integers are exact up to it
  const double number = value.number();
  if (!value.isNumber() || !(std::fabs(number) <= kLargest) || number != std::floor(number)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(number);
}

}  // namespace

bool ScriptRunner::run() {
  for (const ScriptExpression& statement : script_.statements) {
    if (!evaluate(statement, result_)) {
      return false;
    }
  }
  return true;
}

std::optional<bool> ScriptRunner::truth() const {
  return conditionValue(result_);
}

bool ScriptRunner::evaluate(const ScriptExpression& expression, Value& result) {
  switch (expression.kind) {
    case Kind::Constant:
      copyValue(result, expression.constant);
      return true;
    case Kind::Load:
      return load(slots_[expression.slot], result);
    case Kind::Assign:
      return evaluate(expression.operands.front(), result) &&
             assign(slots_[expression.slot], expression.operators.front(), result);
    case Kind::Unary:
      return evaluate(expression.operands.front(), result) &&
             unary(expression.operators.front(), result);
    case Kind::Compare:
      return compare(expression, result);
    case Kind::Choose:
      return choose(expression, result);
    case Kind::Combine:
      return chain(expression, result);
  }
  return false;
}

bool ScriptRunner::chain(const ScriptExpression& expression, Value& result) {
  bool isFine = evaluate(expression.operands.front(), result);
  for (std::size_t i = 0; isFine && i < expression.operators.size(); ++i) {
    Value right;
    isFine = evaluate(expression.operands[i + 1], right) &&
             combine(expression.operators[i], result, right);
  }
  return isFine;
}

bool ScriptRunner::load(const Slot& slot, Value& result) {
  copyValue(result, slot.value);
  return slot.exists || fail("a variable of the script has no value");
}

bool ScriptRunner::assign(Slot& slot, ScriptOperator sign, Value& value) {
  if (!slot.exists && sign != ScriptOperator::Create) {
    return fail("the assigned entry does not exist (create it with ':=')");
  }
  if (value.type == ValueType::Unset) {
    return fail("the assigned expression has no value");
  }
  if (sign == ScriptOperator::Create || sign == ScriptOperator::Assign) {
    const bool isText = value.type == ValueType::String;
    if (!bt::assign(slot, value, isText ? numberOf(value) : std::nullopt)) {
      return fail(typeMismatchMessage(slot, value));
    }
  } else {
    if (slot.value.type == ValueType::Unset) {
      return fail("the changed entry has no value");
    }
    Value changed;
    copyValue(changed, slot.value);
    if (!arithmetic(sign, changed, value)) {
      return false;
    }
    if (!copyInto(slot.value, changed)) {
      return fail(typeMismatchMessage(slot, changed));
    }
    ++slot.version;
  }
  copyValue(value, slot.value);
  return true;
}

bool ScriptRunner::combine(ScriptOperator sign, Value& left, const Value& right) {
  switch (sign) {
    case ScriptOperator::Concat:
      return join(left, right);
    case ScriptOperator::And:
    case ScriptOperator::Or: {
      const std::optional<bool> a = conditionValue(left);
      const std::optional<bool> b = conditionValue(right);
      if (!a || !b) {
        return fail(
            "'&&' and '||' take neither text nor whole numbers other than 0 and 1 "
            "(compare: 'n != 0')");
      }
      setNumber(left, (sign == ScriptOperator::And ? *a && *b : *a || *b) ? 1.0 : 0.0);
      return true;
    }
    case ScriptOperator::BitAnd:
    case ScriptOperator::BitOr:
    case ScriptOperator::BitXor:
      return bits(sign, left, right);
    default:
      return arithmetic(sign, left, right);
  }
}

bool ScriptRunner::join(Value& left, const Value& right) {
  if (!isOperand(left) || !isOperand(right)) {
    return fail("an operand of '..' has no value");
  }
  if (left.isNumber() && right.isNumber()) {
    left = Value();  // as in BehaviorTree.CPP, which reports it where the result is used
    return true;
  }
  if (left.isNumber()) {
    left = Value::of(std::string_view(portText(left)));
  }
  left.text += portText(right);
  return left.text.size() <= kMaxText || fail("the text has more than 1 MB");
}

bool ScriptRunner::arithmetic(ScriptOperator sign, Value& left, const Value& right) {
  if (sign == ScriptOperator::Add && left.type == ValueType::String &&
      right.type == ValueType::String) {
    return join(left, right);
  }
  if (!left.isNumber() || !right.isNumber()) {
    return fail("arithmetic with text (join it with '..')");
  }
  const double a = left.number();
  const double b = right.number();
  setNumber(left, sign == ScriptOperator::Add        ? a + b
                  : sign == ScriptOperator::Subtract ? a - b
                  : sign == ScriptOperator::Multiply ? a * b
                                                     : a / b);
  return true;
}

bool ScriptRunner::bits(ScriptOperator sign, Value& left, const Value& right) {
  const std::optional<std::int64_t> a = bitsOf(left);
  const std::optional<std::int64_t> b = bitsOf(right);
  if (!a || !b) {
    return fail("bitwise operation on a value that is not an integer");
  }
  const std::int64_t result = sign == ScriptOperator::BitAnd  ? (*a & *b)
                              : sign == ScriptOperator::BitOr ? (*a | *b)
                                                              : (*a ^ *b);
  setNumber(left, static_cast<double>(result));
  return true;
}

bool ScriptRunner::unary(ScriptOperator sign, Value& value) {
  if (!value.isNumber()) {
    return fail("a sign is applied to text");
  }
  if (sign == ScriptOperator::Negate) {
    setNumber(value, -value.number());
  } else if (sign == ScriptOperator::Not) {
    setNumber(value, value.number() == 0.0 ? 1.0 : 0.0);
  } else {
    Value whole;
    setNumber(whole, std::trunc(value.number()));
    const std::optional<std::int64_t> number = bitsOf(whole);
    if (!number) {
      return fail("bitwise operation on a number that is too large");
    }
    setNumber(value, static_cast<double>(~*number));
  }
  return true;
}

/// Operands after a comparison that does not hold are not evaluated.
bool ScriptRunner::compare(const ScriptExpression& expression, Value& result) {
  if (!evaluate(expression.operands.front(), result)) {
    return false;
  }
  for (std::size_t i = 0; i < expression.operators.size(); ++i) {
    Value next;
    if (!evaluate(expression.operands[i + 1], next)) {
      return false;
    }
    const std::optional<bool> holds = compareValues(expression.operators[i], result, next);
    if (!holds) {
      return fail("text that is not a number is compared with a number");
    }
    if (!*holds) {
      setNumber(result, 0.0);
      return true;
    }
    if (i + 1 < expression.operators.size()) {
      result = std::move(next);
    }
  }
  setNumber(result, 1.0);
  return true;
}

bool ScriptRunner::choose(const ScriptExpression& expression, Value& result) {
  if (!evaluate(expression.operands[0], result)) {
    return false;
  }
  const bool isText = result.type == ValueType::String;
  if (isText && result.text.empty()) {
    return fail("an empty text is used as a condition");
  }
  if (!isText && !result.isNumber()) {
    return fail("a condition has no value");
  }
  const bool holds = isText || result.number() != 0.0;  // any text
  return evaluate(expression.operands[holds ? 1 : 2], result);
}

}  // namespace bt
