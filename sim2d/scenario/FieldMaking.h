#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/scenario/Fields.h"

/// To write the tables down. Private to this folder.
namespace sim2d {

template <class M>
struct Stored {
  using Value = M;
  static constexpr bool kOptional = false;
};
template <class M>
struct Stored<std::optional<M>> {
  using Value = M;
  static constexpr bool kOptional = true;
};
template <class V>
constexpr bool isInteger = std::is_integral_v<V> && !std::is_same_v<V, bool>;
template <class V>
constexpr bool isList =
    std::is_same_v<V, std::vector<double>> || std::is_same_v<V, std::vector<int>>;

template <class V>
constexpr base::ParameterType parameterType() {
  using Type = base::ParameterType;
  if constexpr (isList<V>) {
    return std::is_same_v<V, std::vector<int>> ? Type::Integers : Type::Numbers;
  } else if constexpr (std::is_enum_v<V>) {
    return Type::Choice;
  } else if constexpr (isInteger<V>) {
    return Type::Integer;
  } else if constexpr (std::is_same_v<V, double>) {
    return Type::Number;
  } else {
    return std::is_same_v<V, bool> ? Type::Boolean : Type::Text;
  }
}

/// An enumerator as its word, an empty list as nothing.
template <class V>
base::ParameterValue valueFrom(const V& value, const base::ParameterSpec& spec) {
  if constexpr (std::is_enum_v<V>) {
    return spec.choices.at(static_cast<std::size_t>(value));
  } else if constexpr (isInteger<V>) {
    return static_cast<long long>(value);
  } else if constexpr (isList<V>) {
    return value.empty() ? base::ParameterValue() : base::ParameterValue(value);
  } else {
    return value;
  }
}

/// The way back; nothing when it is of another type, or no word of the choices.
template <class V>
std::optional<V> valueTo(const base::ParameterValue& value, const base::ParameterSpec& spec) {
  if constexpr (std::is_enum_v<V>) {
    const auto* word = std::get_if<std::string>(&value);
    for (std::size_t i = 0; word != nullptr && i < spec.choices.size(); ++i) {
      if (spec.choices[i] == *word) {
        return static_cast<V>(i);
      }
    }
    return std::nullopt;
  } else if constexpr (isInteger<V>) {
    const auto* number = std::get_if<long long>(&value);
    return number == nullptr ? std::nullopt : std::optional<V>(static_cast<V>(*number));
  } else {
    const auto* same = std::get_if<V>(&value);
    return same == nullptr ? std::nullopt : std::optional<V>(*same);
  }
}

/// Builds one field; each function adds to it.
template <class T>
class FieldOf {
 public:
  FieldOf(std::string key, std::string help, base::FormHints form = {}, std::string unit = {},
          base::Range range = {}) {
    base::ParameterSpec& spec = field_.spec;
    spec.key = std::move(key);
    spec.help = std::move(help);
    spec.form = std::move(form);
    spec.unit = std::move(unit);
    spec.range = range;
  }
  operator Field<T>() && { return std::move(field_); }  // NOLINT: meant to convert

  /// Where it is kept: a generic lambda `[](auto& of) -> auto&`.
  template <class Access>
  FieldOf&& keptAt(Access access) && {
    using Member = std::decay_t<decltype(access(std::declval<T&>()))>;
    using Value = typename Stored<Member>::Value;
    field_.spec.type = parameterType<Value>();
    field_.isWide = std::is_same_v<Value, long long>;
    field_.equal = [access](const T& a, const T& b) { return access(a) == access(b); };
    field_.get = [access](const T& of, const base::ParameterSpec& spec) -> base::ParameterValue {
      const Member& member = access(of);
      if constexpr (Stored<Member>::kOptional) {
        return member ? valueFrom<Value>(*member, spec) : base::ParameterValue();
      } else {
        return valueFrom<Value>(member, spec);
      }
    };
    field_.set = [access](T& of, const base::ParameterValue& value,
                          const base::ParameterSpec& spec) {
      const std::optional<Value> given = valueTo<Value>(value, spec);
      if constexpr (Stored<Member>::kOptional) {
        access(of) = given;
      } else if (given || !std::is_enum_v<Value>) {
        access(of) = given.value_or(Value());
      }
    };
    return std::move(*this);
  }
  /// What counts in a run; its first value is the default. After `words`.
  template <class R>
  FieldOf&& resolvedTo(R Resolving<T>::Type::*member) && {
    using Resolved = typename Resolving<T>::Type;
    field_.resolve = [get = field_.get, member](const T& from, Resolved& to,
                                                const base::ParameterSpec& spec) {
      if (const auto value = valueTo<R>(get(from, spec), spec)) {
        to.*member = *value;
      }
    };
    return std::move(*this).countsAs(member).orElse(Resolved().*member);
  }
  /// What counts in a run and is made from more than this key.
  template <class R>
  FieldOf&& countsAs(R Resolving<T>::Type::*member) && {
    field_.resolved = [member](const typename Resolving<T>::Type& from,
                               const base::ParameterSpec& spec) {
      return valueFrom(from.*member, spec);
    };
    return std::move(*this);
  }
  /// The number that stands for nothing.
  FieldOf&& noneAt(long long none) && {
    field_.get = [get = field_.get, none](const T& of, const base::ParameterSpec& spec) {
      const base::ParameterValue value = get(of, spec);
      return value == base::ParameterValue(none) ? base::ParameterValue() : value;
    };
    field_.set = [set = field_.set, none](T& of, const base::ParameterValue& value,
                                          const base::ParameterSpec& spec) {
      set(of, value == base::ParameterValue() ? base::ParameterValue(none) : value, spec);
    };
    return std::move(*this);
  }
  /// Structures: read and written by functions of their own.
  FieldOf&& madeBy(decltype(Field<T>::read) read, decltype(Field<T>::write) write,
                   decltype(Field<T>::equal) equal) && {
    field_.equal = std::move(equal);
    return std::move(*this).with(&Field<T>::read, read).with(&Field<T>::write, write);
  }
  FieldOf&& words(std::vector<std::string> words) && {
    field_.spec.type = base::ParameterType::Choice;
    field_.spec.choices = std::move(words);
    return std::move(*this);
  }
  template <class V>
  FieldOf&& orElse(const V& value) && {
    field_.spec.fallback = valueFrom(value, field_.spec);
    return std::move(*this);
  }
  FieldOf&& required() && { return std::move(*this).with(&Field<T>::required, true); }
  FieldOf&& digits(int digits) && { return std::move(*this).with(&Field<T>::digits, digits); }
  /// Whatever else differs from the usual.
  template <class M, class V>
  FieldOf&& with(M Field<T>::*member, V value) && {
    field_.*member = std::move(value);
    return std::move(*this);
  }
  FieldOf&& typed(base::ParameterType type) && {
    field_.spec.type = type;
    return std::move(*this);
  }

 private:
  Field<T> field_;
};

/// A key kept in one member.
template <class T, class M>
FieldOf<T> field(std::string key, M T::*member, std::string help, base::FormHints form = {},
                 std::string unit = {}, base::Range range = {}) {
  return FieldOf<T>(std::move(key), std::move(help), std::move(form), std::move(unit), range)
      .keptAt([member](auto& of) -> auto& { return of.*member; });
}

}  // namespace sim2d
