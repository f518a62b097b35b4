#pragma once
// How the library refuses bad input: a value or a one-line error, never an exception.

#include <string>
#include <utility>
#include <variant>

#include "base/assertion.hpp"

namespace tuberia {

/// One line for a person: what was wrong with which input, with the culprit's name.
struct Error {
  std::string message;
};

/// Either a T or an Error. Ask `ok()` (or test it as a bool) before reading either side.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const noexcept { return state_.index() == 0; }
  explicit operator bool() const noexcept { return ok(); }

  T& value() & { return *checked_value(); }
  const T& value() const& { return *const_cast<Result*>(this)->checked_value(); }
  T&& value() && { return std::move(*checked_value()); }
  T* operator->() { return checked_value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }

  const Error& error() const {
    TUBERIA_ASSERT(!ok(), "error() of a Result that holds a value");
    return *std::get_if<1>(&state_);
  }

 private:
  T* checked_value() {
    TUBERIA_ASSERT(ok(), "value() of a Result that holds an error");
    return std::get_if<0>(&state_);
  }

  std::variant<T, Error> state_;
};

/// The value of a Result<Nothing>: the work was done and there is nothing to hand over.
struct Nothing {};

}  // namespace tuberia
