#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim2d/scenario/Fields.h"

/// Builder for field tables. Private to this folder.
namespace sim2d {

/// Value type of a member, without std::optional.
template <class M>
struct Stored {
  using Value = M;
};
template <class M>
struct Stored<std::optional<M>> {
  using Value = M;
};
template <class V>
constexpr bool kIsInteger = std::is_integral_v<V> && !std::is_same_v<V, bool>;
template <class V>
constexpr bool kIsList =
    std::is_same_v<V, std::vector<double>> || std::is_same_v<V, std::vector<int>>;

template <class V>
constexpr ParameterType parameterType() {
  using Type = ParameterType;
  if constexpr (kIsList<V>) {
    return std::is_same_v<V, std::vector<int>> ? Type::Integers : Type::Numbers;
  } else if constexpr (std::is_enum_v<V>) {
    return Type::Choice;
  } else if constexpr (kIsInteger<V>) {
    return Type::Integer;
  } else if constexpr (std::is_same_v<V, double>) {
    return Type::Number;
  } else {
    return std::is_same_v<V, bool> ? Type::Boolean : Type::Text;
  }
}

/// Enumerators become their text, empty lists monostate.
template <class V>
ParameterValue valueFrom(const V& value, const ParameterSpec& spec) {
  if constexpr (std::is_enum_v<V>) {
    return spec.choices.at(static_cast<std::size_t>(value));
  } else if constexpr (kIsInteger<V>) {
    return static_cast<long long>(value);
  } else if constexpr (kIsList<V>) {
    return value.empty() ? ParameterValue() : ParameterValue(value);
  } else {
    return value;
  }
}

template <class V>
ParameterValue valueFrom(const std::optional<V>& value, const ParameterSpec& spec) {
  return value ? valueFrom(*value, spec) : ParameterValue();
}

/// The inverse; none for another type or an unknown choice.
template <class V>
std::optional<V> valueTo(const ParameterValue& value, const ParameterSpec& spec) {
  using Given = std::conditional_t<std::is_enum_v<V>, std::string,
                                   std::conditional_t<kIsInteger<V>, long long, V>>;
  const auto* given = std::get_if<Given>(&value);
  if (given == nullptr) {
    return std::nullopt;
  }
  if constexpr (std::is_enum_v<V>) {
    const auto word = std::find(spec.choices.begin(), spec.choices.end(), *given);
    return word == spec.choices.end() ? std::nullopt
                                      : std::optional(static_cast<V>(word - spec.choices.begin()));
  } else {
    return static_cast<V>(*given);
  }
}

/// Builder of one field.
template <class T>
class FieldBuilder {
 public:
  FieldBuilder(std::string key, std::string help, base::FormHints form = {}, std::string unit = {},
               base::Range range = {}) {
    ParameterSpec& spec = field_.spec;
    spec.key = std::move(key);
    spec.help = std::move(help);
    spec.form = std::move(form);
    spec.unit = std::move(unit);
    spec.range = range;
  }
  operator Field<T>() && { return std::move(field_); }  // NOLINT: meant to convert

  /// The member, as a generic lambda `[](auto& of) -> auto&`.
  template <class Access>
  FieldBuilder&& storedAt(Access access) && {
    using Member = std::decay_t<decltype(access(std::declval<T&>()))>;
    using Value = typename Stored<Member>::Value;
    field_.spec.type = parameterType<Value>();
    field_.is64Bit = std::is_same_v<Value, long long>;
    field_.equal = [access](const T& a, const T& b) { return access(a) == access(b); };
    field_.get = [access](const T& of, const ParameterSpec& spec) {
      return valueFrom(access(of), spec);
    };
    field_.set = [access](T& of, const ParameterValue& value, const ParameterSpec& spec) {
      const std::optional<Value> given = valueTo<Value>(value, spec);
      if constexpr (std::is_same_v<Member, std::optional<Value>>) {
        access(of) = given;
      } else if (given || !std::is_enum_v<Value>) {
        access(of) = given.value_or(Value());
      }
    };
    return std::move(*this);
  }
  /// The corresponding member of the resolved struct; its initial value is the default. Call after
  /// `words`.
  template <class R>
  FieldBuilder&& resolvedTo(R Resolved<T>::*member) && {
    return std::move(*this)
        .resolvedAt([member](auto& of) -> auto& { return of.*member; })
        .defaultsTo(Resolved<T>().*member);
  }
  /// The resolved value at a place given as in `storedAt`; the default is set elsewhere.
  template <class Access>
  FieldBuilder&& resolvedAt(Access access) && {
    using R = std::decay_t<decltype(access(std::declval<Resolved<T>&>()))>;
    field_.resolve = [get = field_.get, access](const T& from, Resolved<T>& to,
                                                const ParameterSpec& spec) {
      if (const auto value = valueTo<R>(get(from, spec), spec)) {
        access(to) = *value;
      }
    };
    field_.resolved = [access](const Resolved<T>& from, const ParameterSpec& spec) {
      return valueFrom(access(from), spec);
    };
    return std::move(*this);
  }
  /// The resolved value that is computed from several keys.
  template <class R>
  FieldBuilder&& computedTo(R Resolved<T>::*member) && {
    field_.resolved = [member](const Resolved<T>& from, const ParameterSpec& spec) {
      return valueFrom(from.*member, spec);
    };
    return std::move(*this);
  }
  /// The number that means "not given".
  FieldBuilder&& withNoneValue(long long none) && {
    field_.get = [get = field_.get, none](const T& of, const ParameterSpec& spec) {
      const ParameterValue value = get(of, spec);
      return value == ParameterValue(none) ? ParameterValue() : value;
    };
    field_.set = [set = field_.set, none](T& of, const ParameterValue& value,
                                          const ParameterSpec& spec) {
      set(of, value == ParameterValue() ? ParameterValue(none) : value, spec);
    };
    return std::move(*this);
  }
  /// Composite values: read and written by own functions, compared by a member or function.
  template <class Part>
  FieldBuilder&& withCustomIo(decltype(Field<T>::read) read, decltype(Field<T>::write) write,
                              Part part) && {
    field_.equal = [part](const T& a, const T& b) {
      return std::invoke(part, a) == std::invoke(part, b);
    };
    return std::move(*this).with(&Field<T>::read, read).with(&Field<T>::write, write);
  }
  FieldBuilder&& words(const std::vector<std::string>& words) && {
    field_.spec.type = ParameterType::Choice;
    field_.spec.choices = words;
    return std::move(*this);
  }
  template <class V>
  FieldBuilder&& defaultsTo(const V& value) && {
    field_.spec.fallback = valueFrom(value, field_.spec);
    return std::move(*this);
  }
  FieldBuilder&& required() && { return std::move(*this).with(&Field<T>::required, true); }
  FieldBuilder&& digits(int digits) && { return std::move(*this).with(&Field<T>::digits, digits); }
  /// A collapsible section of the form: "Lidar".
  FieldBuilder&& inGroup(std::string title) && {
    return std::move(*this).with(&Field<T>::group, std::move(title));
  }
  /// Sets any other member of the field.
  template <class M, class V>
  FieldBuilder&& with(M Field<T>::*member, V value) && {
    field_.*member = std::move(value);
    return std::move(*this);
  }
  FieldBuilder&& typed(ParameterType type) && {
    field_.spec.type = type;
    return std::move(*this);
  }

 private:
  Field<T> field_;
};

/// A key stored in one member.
template <class T, class M>
FieldBuilder<T> field(std::string key, M T::*member, std::string help, base::FormHints form = {},
                      std::string unit = {}, base::Range range = {}) {
  return FieldBuilder<T>(std::move(key), std::move(help), std::move(form), std::move(unit), range)
      .storedAt([member](auto& of) -> auto& { return of.*member; });
}

}  // namespace sim2d
